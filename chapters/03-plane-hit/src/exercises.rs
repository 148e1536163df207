//! The chapter's exercises: functions for you to write.

// ANCHOR: uses
use crate::{Plane, is_even};
use glam::{Vec2, Vec3};
// ANCHOR_END: uses

// ANCHOR: exercise-1
/// Returns whether a computed `point` of a plane, which rounding has put a little above or
/// below it, lies in an even square of a checkerboard on it. The squares have a side of 1, and
/// a corner where `plane.point` is.
pub fn is_even_on(_plane: &Plane, point: Vec3) -> bool {
    // Yours to write.
    is_even(Vec2::new(point.x, point.z))
}
// ANCHOR_END: exercise-1

// ANCHOR: exercise-3
/// Returns whether a point of a floor lies in an even stripe. The stripes are 1 wide, run along
/// the second coordinate, and the one from u = 0 to u = 1 is even.
pub fn is_even_stripe(uv: Vec2) -> bool {
    // Yours to write.
    is_even(uv)
}

/// Returns whether a point of a floor lies in an even ring around the origin. The rings are 1
/// wide, and the innermost one, a disc of radius 1, is even.
pub fn is_even_ring(uv: Vec2) -> bool {
    // Yours to write.
    is_even(uv)
}
// ANCHOR_END: exercise-3
