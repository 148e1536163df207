//! The exercises' solutions, as the book prints them.

use ::fresnel::{fresnel, scatter, schlick};
use ::plane_hit::nearest;
use ::ray_casting::Ray;
use ::reflection::PathBudget;
use ::refraction::{Material, spawn_ray};
use ::shading::shade;
use ::shadows::{Interaction, Scene, is_visible};
use glam::Vec3;

// ANCHOR: exercise-1
pub fn mended_schlick(cos_theta_i: f32, eta_i: f32, eta_t: f32) -> f32 {
    if eta_i <= eta_t {
        return schlick(cos_theta_i, eta_i, eta_t);
    }
    let eta = eta_i / eta_t;
    let sin2_theta_t = eta * eta * (1.0 - cos_theta_i) * (1.0 + cos_theta_i);
    if !(sin2_theta_t < 1.0) {
        return 1.0;
    }
    schlick((1.0 - sin2_theta_t).sqrt(), eta_i, eta_t)
}
// ANCHOR_END: exercise-1

// ANCHOR: exercise-2
pub fn brewster_cosine(eta_i: f32, eta_t: f32) -> f32 {
    // The tangent is ηₜ/ηᵢ, and 1 + tan² = 1/cos².
    eta_i / (eta_i * eta_i + eta_t * eta_t).sqrt()
}
// ANCHOR_END: exercise-2

// ANCHOR: exercise-3
pub fn polarised(cos_theta_i: f32, eta_i: f32, eta_t: f32) -> [f32; 2] {
    if eta_i == eta_t {
        return [0.0; 2];
    }
    let eta = eta_i / eta_t;
    let sin2_theta_t = eta * eta * (1.0 - cos_theta_i) * (1.0 + cos_theta_i);
    if !(sin2_theta_t < 1.0) {
        return [1.0; 2];
    }
    let cos_theta_t = (1.0 - sin2_theta_t).sqrt();
    let r_parl = (eta_t * cos_theta_i - eta_i * cos_theta_t)
        / (eta_t * cos_theta_i + eta_i * cos_theta_t);
    let r_perp = (eta_i * cos_theta_i - eta_t * cos_theta_t)
        / (eta_i * cos_theta_i + eta_t * cos_theta_t);
    [r_parl * r_parl, r_perp * r_perp]
}
// ANCHOR_END: exercise-3

// ANCHOR: exercise-4
pub fn trace_split(
    scene: &Scene<Material>,
    ray: &Ray,
    budget: PathBudget,
    tints: [Vec3; 2],
) -> Vec3 {
    let Some(hit) = nearest(&scene.objects, ray) else {
        return scene.background;
    };
    let at = Interaction::new(&scene.objects, ray, hit);
    let Material { phong, optics } = &scene.objects[at.index].material;
    let mut radiance = shade(phong, &at, &scene.lights, |light, _, _| {
        Vec3::splat(f32::from(is_visible(scene, &at, light)))
    });
    for (scattered, tint) in scatter(optics, &at, fresnel).into_iter().zip(tints) {
        if let Some((weight, direction)) = scattered
            && let Some(budget) = budget.attenuated(weight)
        {
            let next = spawn_ray(&at, direction);
            radiance += weight * tint * trace_split(scene, &next, budget, tints);
        }
    }
    radiance
}
// ANCHOR_END: exercise-4
