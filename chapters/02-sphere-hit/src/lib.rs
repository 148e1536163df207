// ANCHOR: head
//! The intersection of a ray and a sphere: the textbook's formula, how it fails, and a
//! stable one.

pub mod scene;

use glam::Vec3;
use ray_casting::{MAX_LENGTH, Ray, checked_normalize, is_length, is_position};
// ANCHOR_END: head

// ANCHOR: sphere
/// The points at a distance of `radius` from `centre`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sphere {
    /// Its centre.
    pub centre: Vec3,
    /// Its radius; positive.
    pub radius: f32,
}

impl Sphere {
    /// Returns a sphere. `None` if the centre or the radius is out of range ([`is_position`],
    /// [`is_length`]).
    pub fn new(centre: Vec3, radius: f32) -> Option<Self> {
        let is_valid = is_position(centre) && is_length(radius);
        is_valid.then_some(Self { centre, radius })
    }
}
// ANCHOR_END: sphere

// ANCHOR: roots
/// The greatest distance of a hit: a thousand times [`MAX_LENGTH`]. The squares of distances
/// not much longer overflow f32.
pub const T_MAX: f32 = 1000.0 * MAX_LENGTH;

/// Returns the first of two roots, in this order, with 0 < t < `t_max`.
#[inline]
fn first_ahead(roots: [f32; 2], t_max: f32) -> Option<f32> {
    // Written so that NaN is rejected.
    roots.into_iter().find(|&t| t > 0.0 && t < t_max)
}
// ANCHOR_END: roots

// ANCHOR: quadratic
impl Sphere {
    /// Returns the distance to the first hit with 0 < t < `t_max`, by the textbook's formula
    /// for unit directions: t = −d·(o−c) ± √((d·(o−c))² − (‖o−c‖² − r²)). `None` if there is
    /// no such hit.
    ///
    /// From a distance, or for a direction that is not quite a unit vector, the result is
    /// wrong: [`Sphere::distance`] is better.
    ///
    /// Source: the lecture's "Sphere-Ray intersection" slides.
    pub fn distance_quadratic(&self, ray: &Ray, t_max: f32) -> Option<f32> {
        let oc = ray.origin - self.centre;
        let b = ray.direction.dot(oc);
        let discriminant = b * b - (oc.dot(oc) - self.radius * self.radius);
        if !(discriminant >= 0.0) {
            return None;
        }
        let root = discriminant.sqrt();
        first_ahead([-b - root, -b + root], t_max)
    }
}
// ANCHOR_END: quadratic

// ANCHOR: stable
impl Sphere {
    /// Returns the distance to the first hit with 0 < t < `t_max`, found from the ray's
    /// closest approach to the centre. `None` if there is no such hit, or if the ray or the
    /// sphere is not finite.
    ///
    /// The direction need not be a unit vector: a length from 1e-3 to 1e3 will do. The
    /// distance is in units of this length. A zero direction hits nothing.
    ///
    /// A ray that starts on the sphere may or may not hit it where it starts, as rounding has
    /// it: the chapter about shadow acne cures that.
    ///
    /// Source: Haines, Günther and Akenine-Möller, "Precision Improvements for Ray/Sphere
    /// Intersection", Ray Tracing Gems (2019), ch. 7.
    #[inline]
    pub fn distance(&self, ray: &Ray, t_max: f32) -> Option<f32> {
        let oc = ray.origin - self.centre;
        let d_dot_d = ray.direction.dot(ray.direction);
        // The closest approach: its t, and the vector to it from the centre, perpendicular
        // to the ray.
        let t_closest = -ray.direction.dot(oc) / d_dot_d;
        let perpendicular = oc + t_closest * ray.direction;
        // Pythagoras: half the chord is the other leg of a right triangle.
        let half_chord_squared =
            self.radius * self.radius - perpendicular.dot(perpendicular);
        if !(half_chord_squared >= 0.0) {
            return None;
        }
        let t_half = (half_chord_squared / d_dot_d).sqrt();
        first_ahead([t_closest - t_half, t_closest + t_half], t_max)
    }
}
// ANCHOR_END: stable

// ANCHOR: entered
impl Sphere {
    /// Returns whether a hit at distance `t`, as found by [`Sphere::distance`], is the one
    /// where the ray enters the sphere; otherwise the ray leaves the sphere there.
    ///
    /// The order of the two hits tells, not the normal: for a ray that only grazes the sphere,
    /// rounding decides whether the angle between the two is obtuse.
    #[inline]
    pub fn is_entered(&self, ray: &Ray, t: f32) -> bool {
        let oc = ray.origin - self.centre;
        t <= -ray.direction.dot(oc) / ray.direction.dot(ray.direction)
    }
}
// ANCHOR_END: entered

// ANCHOR: normal
impl Sphere {
    /// Returns the outward unit normal at a `point` of the surface.
    ///
    /// [`Vec3::Y`] if rounding has put the point into the centre, or so far away that the
    /// squares overflow: then a hit is not lost because it has no normal.
    #[inline]
    pub fn normal(&self, point: Vec3) -> Vec3 {
        // Dividing by the radius first keeps the squares in range for the smallest and
        // largest spheres.
        checked_normalize((point - self.centre) / self.radius).unwrap_or(Vec3::Y)
    }
}
// ANCHOR_END: normal

// ANCHOR: f64
use glam::DVec3;

/// A hit whose distance and normal come from one calculation in f64.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hit {
    /// Its distance along the ray, in lengths of the direction; positive.
    pub t: f32,
    /// The outward unit normal.
    pub normal: Vec3,
}

impl Sphere {
    /// Returns the first hit with 0 < t < `t_max`, calculated in f64 throughout. `None` if
    /// there is none.
    ///
    /// Up to a distance of 10⁷ radii, `t` is within a unit in its last place, and the normal
    /// within 10⁻⁷ radians.
    pub fn hit_in_f64(&self, ray: &Ray, t_max: f32) -> Option<Hit> {
        let direction = ray.direction.as_dvec3();
        let oc = ray.origin.as_dvec3() - self.centre.as_dvec3();
        let radius = f64::from(self.radius);
        let d_dot_d = direction.dot(direction);
        let t_closest = -direction.dot(oc) / d_dot_d;
        let perpendicular = oc + t_closest * direction;
        let half_chord_squared = radius * radius - perpendicular.dot(perpendicular);
        if !(half_chord_squared >= 0.0) {
            return None;
        }
        let t_half = (half_chord_squared / d_dot_d).sqrt();
        let from_closest = [-t_half, t_half].into_iter().find(|from_closest| {
            let t = (t_closest + from_closest) as f32;
            t > 0.0 && t < t_max
        })?;
        let normal = (perpendicular + from_closest * direction) / radius;
        Some(Hit {
            t: (t_closest + from_closest) as f32,
            normal: normal.normalize_or(DVec3::Y).as_vec3(),
        })
    }
}
// ANCHOR_END: f64

// ANCHOR: face-forward
/// Returns `normal` or its opposite, whichever faces a ray along `incident`: outside a
/// sphere that is the outward normal, inside the sphere the inward one.
///
/// Source: the OpenGL Shading Language's `faceforward`.
#[inline]
pub fn face_forward(normal: Vec3, incident: Vec3) -> Vec3 {
    if normal.dot(incident) > 0.0 {
        -normal
    } else {
        normal
    }
}
// ANCHOR_END: face-forward

// ANCHOR: ours
// The exercises; and the pictures of this page, for the window, the command line and the tests
// of this project.
pub mod exercises;
pub mod views;
pub use views::STAGE;
// ANCHOR_END: ours
