// ANCHOR: head
//! Where a ray meets a sphere: the slide's formula, how it fails, and one that does not.

pub mod views;
pub use views::STAGE;

use glam::Vec3;
use ray_casting::{Ray, unit};
// ANCHOR_END: head

// ANCHOR: sphere
/// The points at a distance of `radius` from `centre`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sphere {
    /// The middle.
    pub centre: Vec3,
    /// Positive and finite.
    pub radius: f32,
}

impl Sphere {
    /// A sphere; `None` if the radius is zero, negative or not finite, or the centre is
    /// not finite.
    #[must_use]
    pub fn new(centre: Vec3, radius: f32) -> Option<Self> {
        let is_one = centre.is_finite() && radius > 0.0 && radius.is_finite();
        is_one.then_some(Self { centre, radius })
    }
}
// ANCHOR_END: sphere

// ANCHOR: hit
/// Where a ray meets a surface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hit {
    /// How far along the ray, in lengths of its direction; positive.
    pub t: f32,
    /// The surface's outward direction there; a unit vector.
    pub normal: Vec3,
}

/// As far as a ray can see: the squares of longer distances are beyond f32.
pub const FARTHEST: f32 = 1e18;

/// The first of two roots, in this order, that lies ahead of the ray and before `t_max`.
fn first_ahead(roots: [f32; 2], t_max: f32) -> Option<f32> {
    // Written so that NaN is rejected.
    roots.into_iter().find(|&t| t > 0.0 && t < t_max)
}

impl Sphere {
    /// The hit at distance `t`, which the sphere's equation has given.
    fn hit_at(&self, ray: &Ray, t: f32) -> Option<Hit> {
        // Dividing by the radius first keeps the squares in range for the smallest and
        // largest spheres.
        let normal = unit((ray.at(t) - self.centre) / self.radius)?;
        Some(Hit { t, normal })
    }
    // ANCHOR_END: hit

    // ANCHOR: slide
    /// The first hit ahead of the ray and before `t_max`, by the slide's formula for unit
    /// directions: t = −d·(o−c) ± √((d·(o−c))² − (‖o−c‖² − r²)).
    ///
    /// From a distance, or for a direction that is not quite a unit vector, it is wrong:
    /// [`Sphere::hit`] is better.
    ///
    /// Source: the talk's "Sphere-Ray intersection" slides.
    #[must_use]
    pub fn hit_by_slide(&self, ray: &Ray, t_max: f32) -> Option<Hit> {
        let oc = ray.origin - self.centre;
        let b = ray.direction.dot(oc);
        let discriminant = b * b - (oc.dot(oc) - self.radius * self.radius);
        if !(discriminant >= 0.0) {
            return None;
        }
        let root = discriminant.sqrt();
        self.hit_at(ray, first_ahead([-b - root, -b + root], t_max)?)
    }
    // ANCHOR_END: slide

    // ANCHOR: stable
    /// The first hit ahead of the ray and before `t_max`, from the ray's closest approach
    /// to the centre.
    ///
    /// The direction need not be a unit vector. Returns `None` for a miss, and for a ray
    /// or a sphere that is none: a zero direction, or anything that is not finite.
    ///
    /// Source: Haines, Günther and Akenine-Möller, "Precision Improvements for Ray/Sphere
    /// Intersection", Ray Tracing Gems (2019), ch. 7.
    #[must_use]
    pub fn hit(&self, ray: &Ray, t_max: f32) -> Option<Hit> {
        let oc = ray.origin - self.centre;
        let d_dot_d = ray.direction.dot(ray.direction);
        // The closest approach: t, and the way from the centre to there, perpendicular to
        // the ray.
        let t_closest = -ray.direction.dot(oc) / d_dot_d;
        let closest = oc + t_closest * ray.direction;
        // Pythagoras: the chord's half is the other leg of a right triangle.
        let half_chord_squared = self.radius * self.radius - closest.dot(closest);
        if !(half_chord_squared >= 0.0) {
            return None;
        }
        let t_half = (half_chord_squared / d_dot_d).sqrt();
        self.hit_at(
            ray,
            first_ahead([t_closest - t_half, t_closest + t_half], t_max)?,
        )
    }
    // ANCHOR_END: stable

    // ANCHOR: f64
    /// The same as [`Sphere::hit`], in f64 from the ray to the normal.
    ///
    /// For a finite ray and sphere it is right to the last bit of an f32, up to a
    /// distance of 10⁷ radii.
    #[must_use]
    pub fn hit_in_f64(&self, ray: &Ray, t_max: f32) -> Option<Hit> {
        let direction = ray.direction.as_dvec3();
        let oc = ray.origin.as_dvec3() - self.centre.as_dvec3();
        let radius = f64::from(self.radius);
        let d_dot_d = direction.dot(direction);
        let t_closest = -direction.dot(oc) / d_dot_d;
        let closest = oc + t_closest * direction;
        let half_chord_squared = radius * radius - closest.dot(closest);
        if !(half_chord_squared >= 0.0) {
            return None;
        }
        let t_half = (half_chord_squared / d_dot_d).sqrt();
        let from_closest = [-t_half, t_half].into_iter().find(|from_closest| {
            let t = (t_closest + from_closest) as f32;
            t > 0.0 && t < t_max
        })?;
        let normal = (closest + from_closest * direction) / radius;
        Some(Hit {
            t: (t_closest + from_closest) as f32,
            normal: normal.try_normalize()?.as_vec3(),
        })
    }
}
// ANCHOR_END: f64

// ANCHOR: facing
/// The `normal` on the side that a ray along `incident` comes from.
///
/// Outside a sphere that is its own normal, inside it the opposite one.
#[must_use]
pub fn facing(normal: Vec3, incident: Vec3) -> Vec3 {
    if normal.dot(incident) > 0.0 {
        -normal
    } else {
        normal
    }
}
// ANCHOR_END: facing
