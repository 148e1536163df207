//! The chapter's exercises: functions for you to write.

use crate::Lanes;
use glam::UVec2;

// ANCHOR: exercise-1
/// Returns Schlick's approximation of the reflectance for the cosines of the angles of incidence
/// of sixteen rays: in each lane the bits that `fresnel::schlick` has for one.
pub fn schlick(_cos_theta_i: Lanes, eta_i: f32, eta_t: f32) -> Lanes {
    // Yours to write.
    let r = (eta_i - eta_t) / (eta_i + eta_t);
    Lanes::splat(r * r)
}
// ANCHOR_END: exercise-1

// ANCHOR: exercise-4
/// Returns the place of a lane's pixel in a packet of 4 × 4 pixels, from the packet's top left
/// one: row by row, each from the left.
pub fn place_in_square(lane: u32) -> UVec2 {
    // Yours to write.
    UVec2::new(lane, 0)
}
// ANCHOR_END: exercise-4
