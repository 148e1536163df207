// ANCHOR: head
//! Fresnel: the fraction of light that an interface reflects; it transmits the rest.

pub mod scene;

use glam::Vec3;
use plane_hit::nearest;
use ray_casting::Ray;
use reflection::{PathBudget, reflect};
use refraction::{Interface, Material, Optics, refract, spawn_ray};
use shading::{powi, shade};
use shadows::{Interaction, Scene, is_visible};
// ANCHOR_END: head

// ANCHOR: fresnel
/// Returns the reflectance of the interface between two dielectrics for unpolarised light,
/// from 0 to 1; the rest is transmitted.
///
/// `cos_theta_i` is the cosine of the angle of incidence, from 0 to 1; `eta_i` and `eta_t`
/// are the indices on the side of the incident ray and on the far side. Total internal
/// reflection gives 1, equal indices give 0.
///
/// Source: Hecht, Optics, 4.6; the lecture's "Fresnel" slide.
#[inline]
pub fn fresnel(cos_theta_i: f32, eta_i: f32, eta_t: f32) -> f32 {
    // Without this, an invisible ball would sparkle: at grazing angles the sine rounds to 1,
    // or the amplitudes are nearly 0/0.
    if eta_i == eta_t {
        return 0.0;
    }
    // Snell's law; sin² = (1 − cos)(1 + cos) loses no digits near normal incidence.
    let eta = eta_i / eta_t;
    let sin2_theta_t = eta * eta * (1.0 - cos_theta_i) * (1.0 + cos_theta_i);
    // Total internal reflection.
    if !(sin2_theta_t < 1.0) {
        return 1.0;
    }
    let cos_theta_t = (1.0 - sin2_theta_t).sqrt();
    // The amplitudes of light polarised parallel and perpendicular to the plane of incidence.
    let r_parl = (eta_t * cos_theta_i - eta_i * cos_theta_t)
        / (eta_t * cos_theta_i + eta_i * cos_theta_t);
    let r_perp = (eta_i * cos_theta_i - eta_t * cos_theta_t)
        / (eta_i * cos_theta_i + eta_t * cos_theta_t);
    (r_parl * r_parl + r_perp * r_perp) / 2.0
}
// ANCHOR_END: fresnel

// ANCHOR: schlick
/// Returns Schlick's approximation of the reflectance, with the classic mistake: the cosine
/// is that of the incident ray, where the formula needs the one of the larger of the two
/// angles.
///
/// On entering a denser medium the two are the same, and for glass the error is a few
/// hundredths at most. On leaving the medium, total reflection is missed.
///
/// Source: Schlick, "An Inexpensive BRDF Model for Physically-based Rendering" (1994).
pub fn schlick(cos_theta_i: f32, eta_i: f32, eta_t: f32) -> f32 {
    let r = (eta_i - eta_t) / (eta_i + eta_t);
    let r0 = r * r;
    r0 + (1.0 - r0) * powi(1.0 - cos_theta_i, 5)
}
// ANCHOR_END: schlick

// ANCHOR: scatter
/// A function like [`fresnel`]: from cosθᵢ, ηᵢ and ηₜ to the reflectance.
pub type Reflectance = fn(f32, f32, f32) -> f32;

/// Returns the reflected and the transmitted ray of a hit, each as a weight and a unit
/// direction. `None` if there is no such ray. A weight may be 0.
#[inline]
pub fn scatter(
    optics: &Optics,
    at: &Interaction,
    reflectance: impl Fn(f32, f32, f32) -> f32,
) -> [Option<(f32, Vec3)>; 2] {
    match *optics {
        Optics::Opaque { reflectivity } => {
            let reflects = reflectivity > 0.0;
            let reflected = || (reflectivity, reflect(at.incident, at.normal));
            [reflects.then(reflected), None]
        }
        Optics::Dielectric {
            eta_inside,
            eta_outside,
        } => {
            let Interface { eta_i, eta_t } = Interface::new(at, eta_inside, eta_outside);
            let reflected = reflect(at.incident, at.normal);
            match refract(at.incident, at.normal, eta_i / eta_t) {
                Some(refracted) => {
                    let cos_theta_i = -at.normal.dot(at.incident);
                    let reflectance = reflectance(cos_theta_i, eta_i, eta_t);
                    [
                        Some((reflectance, reflected)),
                        Some((1.0 - reflectance, refracted)),
                    ]
                }
                // Total internal reflection.
                None => [Some((1.0, reflected)), None],
            }
        }
    }
}
// ANCHOR_END: scatter

// ANCHOR: trace
/// Returns the radiance along a ray: that of the surface that it hits first, and what is seen
/// in it and through it; or the background.
pub fn trace(
    scene: &Scene<Material>,
    ray: &Ray,
    budget: PathBudget,
    reflectance: Reflectance,
) -> Vec3 {
    let Some(hit) = nearest(&scene.objects, ray) else {
        return scene.background;
    };
    let at = Interaction::new(&scene.objects, ray, hit);
    let Material { phong, optics } = &scene.objects[at.index].material;
    let mut radiance = shade(phong, &at, &scene.lights, |light, _, _| {
        Vec3::splat(f32::from(is_visible(scene, &at, light)))
    });
    let rays = scatter(optics, &at, reflectance);
    for (weight, direction) in rays.into_iter().flatten() {
        if let Some(budget) = budget.attenuated(weight) {
            let next = spawn_ray(&at, direction);
            radiance += weight * trace(scene, &next, budget, reflectance);
        }
    }
    radiance
}
// ANCHOR_END: trace

// ANCHOR: ours
// The exercises; and the pictures of this page, for the window, the command line and the tests
// of this project.
pub mod exercises;
pub mod views;
pub use views::STAGE;
// ANCHOR_END: ours
