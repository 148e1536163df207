// ANCHOR: head
//! Glass: a ray that enters it is refracted, and refracted again when it leaves; or it
//! cannot leave at all.

pub mod scene;

use glam::Vec3;
use plane_hit::nearest;
use ray_casting::Ray;
use reflection::{PathBudget, reflect};
use shading::{Phong, shade};
use shadows::{Interaction, SHADOW_BIAS, Scene, is_visible};
use sphere_hit::face_forward;
// ANCHOR_END: head

// ANCHOR: refract
/// Returns the direction of the refracted ray, by Snell's law: T = η (I + cosθᵢ N) −
/// N √(1 − η² sin²θᵢ), where η = ηᵢ/ηₜ. `None` for total internal reflection.
///
/// `incident` and `normal` must be unit vectors, and `normal` must face the incident ray. The
/// result is a unit vector. Equal indices leave the direction as it is, to the last bit.
///
/// Source: the lecture's "Refractions" slide.
#[inline]
pub fn refract(incident: Vec3, normal: Vec3, eta: f32) -> Option<Vec3> {
    if eta == 1.0 {
        return Some(incident);
    }
    let cos_theta_i = -normal.dot(incident);
    // The tangential part of the incident direction, sinθᵢ long.
    let tangential = incident + cos_theta_i * normal;
    // Snell's law: sinθₜ = η sinθᵢ.
    let sin2_theta_t = eta * eta * tangential.dot(tangential);
    if !(sin2_theta_t < 1.0) {
        return None;
    }
    let cos_theta_t = (1.0 - sin2_theta_t).sqrt();
    Some((eta * tangential - cos_theta_t * normal).normalize())
}
// ANCHOR_END: refract

// ANCHOR: interface
/// The indices of refraction on the two sides of a surface that a ray hits.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Interface {
    /// ηᵢ, on the side from which the ray comes.
    pub eta_i: f32,
    /// ηₜ, on the far side.
    pub eta_t: f32,
}

impl Interface {
    /// Returns the indices for a ray that enters or leaves an object, by the index inside
    /// and that outside.
    #[inline]
    pub fn new(at: &Interaction, eta_inside: f32, eta_outside: f32) -> Self {
        let (eta_i, eta_t) = if at.enters() {
            (eta_outside, eta_inside)
        } else {
            (eta_inside, eta_outside)
        };
        Self { eta_i, eta_t }
    }
}
// ANCHOR_END: interface

// ANCHOR: refract-or-reflect
/// Returns the weight and the unit direction of the ray that a dielectric scatters: the
/// refracted one, or under total internal reflection the reflected one.
pub fn refract_or_reflect(
    at: &Interaction,
    eta_inside: f32,
    eta_outside: f32,
) -> (f32, Vec3) {
    let Interface { eta_i, eta_t } = Interface::new(at, eta_inside, eta_outside);
    let refracted = refract(at.incident, at.normal, eta_i / eta_t);
    let direction = refracted.unwrap_or_else(|| reflect(at.incident, at.normal));
    (1.0, direction)
}
// ANCHOR_END: refract-or-reflect

// ANCHOR: material
/// How an object reflects and transmits rays.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Optics {
    /// A fraction of the light is reflected; the rest is lost.
    Opaque {
        /// kᵣ, the fraction of light that is reflected as by a mirror, from 0 to 1.
        reflectivity: f32,
    },
    /// Light passes through. Both indices are positive.
    Dielectric {
        /// The index of refraction inside the object.
        eta_inside: f32,
        /// The index of refraction outside the object.
        eta_outside: f32,
    },
}

/// How an object reflects the lights, and reflects and transmits rays.
///
/// The surfaces of dielectrics must not cross. One may lie wholly inside another if its
/// `eta_outside` is the other's `eta_inside`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Material {
    /// How the surface reflects the lights.
    pub phong: Phong,
    /// How the object reflects and transmits rays.
    pub optics: Optics,
}
// ANCHOR_END: material

// ANCHOR: trace
/// How a dielectric scatters a ray, as [`refract_or_reflect`] does: from a hit and the indices
/// inside and outside to the weight and the unit direction of the next ray.
pub type Transmission = fn(&Interaction, f32, f32) -> (f32, Vec3);

/// Returns the radiance along a ray: that of the surface that it hits first and what is seen
/// in it or through it, or the background.
pub fn trace(
    scene: &Scene<Material>,
    ray: &Ray,
    budget: PathBudget,
    transmission: Transmission,
) -> Vec3 {
    let Some(hit) = nearest(&scene.objects, ray) else {
        return scene.background;
    };
    let at = Interaction::new(&scene.objects, ray, hit);
    let Material { phong, optics } = &scene.objects[at.index].material;
    let radiance = shade(phong, &at, &scene.lights, |light, _, _| {
        Vec3::splat(f32::from(is_visible(scene, &at, light)))
    });
    let (weight, direction) = match *optics {
        Optics::Opaque { reflectivity } => {
            (reflectivity, reflect(at.incident, at.normal))
        }
        Optics::Dielectric {
            eta_inside,
            eta_outside,
        } => transmission(&at, eta_inside, eta_outside),
    };
    let Some(budget) = budget.attenuated(weight) else {
        return radiance;
    };
    let next = spawn_ray(&at, direction);
    radiance + weight * trace(scene, &next, budget, transmission)
}

/// Returns the ray from a hit in a unit `direction`, its origin moved by [`SHADOW_BIAS`] to
/// the side of the surface to which the direction points.
pub fn spawn_ray(at: &Interaction, direction: Vec3) -> Ray {
    Ray {
        origin: at.point + SHADOW_BIAS * face_forward(at.outward, -direction),
        direction,
    }
}
// ANCHOR_END: trace

// ANCHOR: failed
/// Refracts with a bug: the ratio of the indices is not inverted when the ray leaves.
pub fn refract_without_inverting(
    at: &Interaction,
    eta_inside: f32,
    eta_outside: f32,
) -> (f32, Vec3) {
    let refracted = refract(at.incident, at.normal, eta_outside / eta_inside);
    let direction = refracted.unwrap_or_else(|| reflect(at.incident, at.normal));
    (1.0, direction)
}

/// Refracts with a bug: under total internal reflection the light is lost.
pub fn refract_without_total_reflection(
    at: &Interaction,
    eta_inside: f32,
    eta_outside: f32,
) -> (f32, Vec3) {
    let Interface { eta_i, eta_t } = Interface::new(at, eta_inside, eta_outside);
    match refract(at.incident, at.normal, eta_i / eta_t) {
        Some(direction) => (1.0, direction),
        None => (0.0, at.incident),
    }
}
// ANCHOR_END: failed

// ANCHOR: ours
// The exercises; and the pictures of this page, for the window, the command line and the tests
// of this project.
pub mod exercises;
pub mod views;
pub use views::STAGE;
// ANCHOR_END: ours
