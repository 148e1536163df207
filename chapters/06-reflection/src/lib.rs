// ANCHOR: head
//! Mirrors: a ray that hits one is reflected, R = I − 2(N·I)N.

pub mod scene;

use glam::Vec3;
use plane_hit::nearest;
use ray_casting::Ray;
use shading::{Phong, shade};
use shadows::{Interaction, SHADOW_BIAS, Scene, is_visible};
use sphere_hit::Sphere;
// ANCHOR_END: head

// ANCHOR: unnormalized
/// Returns `incident` reflected about the plane with the given unit `normal`, by the
/// textbook's formula as it stands: R = I − 2(N·I)N.
///
/// An error in the length of `incident` is passed on to the result. It grows at every bounce
/// if the next hit depends on that length: [`reflect`] is better.
///
/// Source: the lecture's "Reflections" slide.
#[inline]
pub fn reflect_unnormalized(incident: Vec3, normal: Vec3) -> Vec3 {
    incident - 2.0 * normal.dot(incident) * normal
}
// ANCHOR_END: unnormalized

// ANCHOR: reflect
/// Returns `incident` reflected about the plane with the given `normal`, which may point to
/// either side of the plane.
///
/// Both must be unit vectors, up to rounding. So is the result: it is normalised once, here.
///
/// Source: the lecture's "Reflections" slide; Whitted 1980.
#[inline]
pub fn reflect(incident: Vec3, normal: Vec3) -> Vec3 {
    reflect_unnormalized(incident, normal).normalize()
}
// ANCHOR_END: reflect

// ANCHOR: bounce
/// Returns the ray after its next bounce inside a mirror sphere, by the textbook's formula
/// for the hit, and one of the two functions above to `reflect`.
///
/// The ray must start on the sphere and point inwards. The result starts on the sphere
/// again, up to rounding.
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

// ANCHOR: budget
/// The greatest number of bounces for which a ray is followed.
pub const MAX_DEPTH: u32 = 64;

/// The throughput at or below which a ray is not traced: this fraction of white is a tenth of
/// a level in the dark, where sRGB is steepest and goes through 12.92 · 255 levels for white.
/// In brighter light it is less.
pub const MIN_THROUGHPUT: f32 = 1.0 / 32_768.0;

/// Recursion budget: the number of bounces that are left, and the throughput.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PathBudget {
    /// The number of bounces that are left. Each takes a piece of the stack: whoever sets more
    /// than [`MAX_DEPTH`] must know that it is large enough.
    pub depth: u32,
    /// The fraction, 0 to 1, of the ray's radiance that reaches the pixel.
    pub throughput: f32,
    /// Rays with a throughput at or below this are not traced. 0 traces every ray that
    /// contributes.
    pub min_throughput: f32,
}

impl PathBudget {
    /// Returns the budget of a camera ray: `depth` bounces, or [`MAX_DEPTH`] if that is less,
    /// and [`MIN_THROUGHPUT`].
    pub fn new(depth: u32) -> Self {
        Self {
            depth: depth.min(MAX_DEPTH),
            throughput: 1.0,
            min_throughput: MIN_THROUGHPUT,
        }
    }

    /// Returns the budget after a bounce that passes on the fraction `coefficient` of the
    /// light. `None` if no bounce is left, or if the new throughput is at most
    /// `min_throughput` or NaN.
    #[inline]
    pub fn attenuated(self, coefficient: f32) -> Option<Self> {
        let throughput = self.throughput * coefficient;
        let is_traced = self.depth > 0 && throughput > self.min_throughput;
        is_traced.then(|| Self {
            depth: self.depth - 1,
            throughput,
            ..self
        })
    }
}
// ANCHOR_END: budget

// ANCHOR: trace
/// A surface that also reflects like a mirror.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Mirror {
    /// How it reflects the lights.
    pub phong: Phong,
    /// kᵣ, the fraction of light that it reflects like a mirror, from 0 to 1.
    pub reflectivity: f32,
}

/// Returns the radiance along a ray: that of the surface that it hits first and what is
/// reflected in it, or the background.
///
/// Source: Whitted, "An Improved Illumination Model for Shaded Display" (1980).
pub fn trace(scene: &Scene<Mirror>, ray: &Ray, budget: PathBudget) -> Vec3 {
    let Some(hit) = nearest(&scene.objects, ray) else {
        return scene.background;
    };
    let at = Interaction::new(&scene.objects, ray, hit);
    let Mirror {
        phong,
        reflectivity,
    } = &scene.objects[at.index].material;
    let radiance = shade(phong, &at, &scene.lights, |light, _, _| {
        Vec3::splat(f32::from(is_visible(scene, &at, light)))
    });
    let Some(budget) = budget.attenuated(*reflectivity) else {
        return radiance;
    };
    let reflected = Ray {
        origin: at.point + SHADOW_BIAS * at.normal,
        direction: reflect(at.incident, at.normal),
    };
    radiance + *reflectivity * trace(scene, &reflected, budget)
}
// ANCHOR_END: trace

// ANCHOR: ours
// The exercises; and the pictures of this page, for the window, the command line and the tests
// of this project.
pub mod exercises;
pub mod views;
pub use views::STAGE;
// ANCHOR_END: ours
