//! The exercises' solutions, as the book prints them.

use ::packets::Lanes;
use ::shading::powi;
use glam::UVec2;

// ANCHOR: exercise-1
pub fn schlick(cos_theta_i: Lanes, eta_i: f32, eta_t: f32) -> Lanes {
    let r = (eta_i - eta_t) / (eta_i + eta_t);
    let r0 = r * r;
    r0 + (1.0 - r0) * powi(1.0 - cos_theta_i, 5)
}
// ANCHOR_END: exercise-1

// ANCHOR: exercise-4
pub fn place_in_square(lane: u32) -> UVec2 {
    UVec2::new(lane % 4, lane / 4)
}
// ANCHOR_END: exercise-4
