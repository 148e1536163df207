//! The chapter's exercises: functions for you to write.

// ANCHOR: uses
use crate::{SurfaceRay, with_scaled_offset, without_offset};
use glam::Vec3;
use shadows::Interaction;
// ANCHOR_END: uses

// ANCHOR: exercise-1
/// Spawns a ray as [`with_scaled_offset`] does, but at a distance from the surface that is
/// `factor` ε max(|p|, |c|, r), with a factor in place of 4.
pub fn with_offset_by(_factor: f32, at: &Interaction, direction: Vec3) -> SurfaceRay {
    // Yours to write.
    with_scaled_offset(at, direction)
}
// ANCHOR_END: exercise-1

// ANCHOR: exercise-5
/// Spawns a ray at the computed point, moved by 32 floats in each coordinate: upwards or
/// downwards, as the coordinate grows or falls towards the side to which the `direction`
/// points. A coordinate that does neither, along the surface, stays. The ray's origin is not
/// known to be on a surface.
pub fn with_steps_of_floats(at: &Interaction, direction: Vec3) -> SurfaceRay {
    // Yours to write.
    without_offset(at, direction)
}
// ANCHOR_END: exercise-5
