// ANCHOR: head
//! Mirrors: a ray that meets one goes on, R = I − 2(N·I)N, and brings back what it sees.

pub mod views;
pub use views::STAGE;

use glam::Vec3;
use plane_hit::nearest;
use ray_casting::Ray;
use shading::{Phong, shade};
use shadows::{OFFSET, PointLight, Scene, light_reaches};
use sphere_hit::{Sphere, facing};
// ANCHOR_END: head

// ANCHOR: slide
/// Mirrors `incident` about the plane with the given `normal`, by the slide's formula as
/// it stands: R = I − 2(N·I)N.
///
/// Both should be unit vectors. If they are so only up to rounding, the error is passed
/// on, and where the next hit depends on the length of this direction it grows:
/// [`reflect`] is better.
///
/// Source: the talk's "Reflections" slide.
#[must_use]
pub fn reflect_by_slide(incident: Vec3, normal: Vec3) -> Vec3 {
    incident - 2.0 * normal.dot(incident) * normal
}
// ANCHOR_END: slide

// ANCHOR: reflect
/// Mirrors `incident` about the plane with the given `normal`.
///
/// Both must be unit vectors, up to rounding; so is the result, for it is normalised
/// here, once. On which side of the plane the normal stands makes no difference.
///
/// Source: the talk's "Reflections" slide; Whitted 1980.
#[must_use]
pub fn reflect(incident: Vec3, normal: Vec3) -> Vec3 {
    reflect_by_slide(incident, normal).normalize()
}
// ANCHOR_END: reflect

// ANCHOR: bounce
/// The ray after its next bounce inside a mirror sphere, on whose surface it starts, by
/// the slides' formulas and either way to `reflect`.
///
/// The ray must point inwards. The result starts on the surface again, up to rounding.
#[must_use]
pub fn bounce_inside(sphere: &Sphere, ray: &Ray, reflect: fn(Vec3, Vec3) -> Vec3) -> Ray {
    let oc = ray.origin - sphere.centre;
    let b = ray.direction.dot(oc);
    let discriminant = b * b - (oc.dot(oc) - sphere.radius * sphere.radius);
    // The near root is where the ray starts; the far one is where it goes.
    let point = ray.at(-b + discriminant.sqrt());
    let normal = (point - sphere.centre) / sphere.radius;
    Ray {
        origin: point,
        direction: reflect(ray.direction, normal),
    }
}
// ANCHOR_END: bounce

// ANCHOR: reach
/// The most bounces that a ray is followed for.
pub const MAX_DEPTH: u32 = 64;

/// The least share of a pixel's light that is worth a ray: an eighth of a screen's level.
pub const LEAST_WEIGHT: f32 = 1.0 / 2048.0;

/// How far a ray is followed: until its bounces or its weight run out.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Reach {
    /// How many bounces are left.
    pub depth: u32,
    /// The share of the pixel's light that this ray brings.
    pub weight: f32,
    /// The share that is not worth a ray. 0 follows every ray that brings anything at
    /// all.
    pub least_weight: f32,
}

impl Reach {
    /// A camera ray's, with at most so many bounces after it and the usual
    /// [`LEAST_WEIGHT`].
    #[must_use]
    pub fn new(depth: u32) -> Self {
        Self {
            depth,
            weight: 1.0,
            least_weight: LEAST_WEIGHT,
        }
    }

    /// What is left after a bounce that passes on a `share` of the light; `None` if it is
    /// not worth a ray.
    #[must_use]
    pub fn after(self, share: f32) -> Option<Self> {
        let weight = self.weight * share;
        let is_worth_it = self.depth > 0 && weight > self.least_weight;
        is_worth_it.then(|| Self {
            depth: self.depth - 1,
            weight,
            ..self
        })
    }
}
// ANCHOR_END: reach

// ANCHOR: trace
/// A surface that also mirrors.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Mirror {
    /// Its answer to the lamps.
    pub phong: Phong,
    /// kᵣ: the share of the light that it mirrors, from 0 to 1.
    pub reflectivity: f32,
}

/// What a ray brings back: the light of what it meets first, and what is seen mirrored in
/// it.
#[must_use]
pub fn trace(scene: &Scene<Mirror>, ray: &Ray, reach: Reach) -> Vec3 {
    let Some((object, hit)) = nearest(&scene.objects, ray) else {
        return scene.background;
    };
    let Mirror {
        phong,
        reflectivity,
    } = &object.material;
    let point = ray.at(hit.t);
    let normal = facing(hit.normal, ray.direction);
    let reaches = |light: &PointLight| light_reaches(scene, point, normal, light);
    let light = shade(phong, ray.direction, point, normal, &scene.lights, reaches);
    let Some(reach) = reach.after(*reflectivity) else {
        return light;
    };
    canvas::count_ray();
    let mirrored = Ray {
        origin: point + OFFSET * normal,
        direction: reflect(ray.direction, normal),
    };
    light + *reflectivity * trace(scene, &mirrored, reach)
}
// ANCHOR_END: trace
