//! The chapter's exercises: functions for you to write.

// ANCHOR: uses
use crate::{fresnel, schlick, trace};
use glam::Vec3;
use ray_casting::Ray;
use reflection::PathBudget;
use refraction::Material;
use shadows::Scene;
// ANCHOR_END: uses

// ANCHOR: exercise-1
/// Returns Schlick's approximation of the reflectance with the right cosine: that of the larger
/// of the two angles, which is the angle of refraction if the ray comes from the denser side.
/// Total internal reflection gives 1.
pub fn mended_schlick(cos_theta_i: f32, eta_i: f32, eta_t: f32) -> f32 {
    // Yours to write.
    schlick(cos_theta_i, eta_i, eta_t)
}
// ANCHOR_END: exercise-1

// ANCHOR: exercise-2
/// Returns the cosine of Brewster's angle: the angle of incidence at which light that is
/// polarised parallel to the plane of incidence is not reflected at all.
pub fn brewster_cosine(_eta_i: f32, _eta_t: f32) -> f32 {
    // Yours to write.
    std::f32::consts::FRAC_1_SQRT_2
}
// ANCHOR_END: exercise-2

// ANCHOR: exercise-3
/// Returns the reflectances for light that is polarised parallel and perpendicular to the plane
/// of incidence, in this order; [`fresnel`] is their mean.
pub fn polarised(cos_theta_i: f32, eta_i: f32, eta_t: f32) -> [f32; 2] {
    // Yours to write.
    [fresnel(cos_theta_i, eta_i, eta_t); 2]
}
// ANCHOR_END: exercise-3

// ANCHOR: exercise-4
/// Returns the radiance along a ray, as [`trace`] does with [`fresnel`], but with the light of
/// every reflected ray times the first of two tints, and that of every transmitted ray times the
/// second.
pub fn trace_split(
    scene: &Scene<Material>,
    ray: &Ray,
    budget: PathBudget,
    _tints: [Vec3; 2],
) -> Vec3 {
    // Yours to write.
    trace(scene, ray, budget, fresnel)
}
// ANCHOR_END: exercise-4
