//! The exercises' solutions, as the book prints them.

use ::plane_hit::{Plane, is_even};
use glam::{Vec2, Vec3};

// ANCHOR: exercise-1
pub fn is_even_on(plane: &Plane, point: Vec3) -> bool {
    is_even(plane.uv(point))
}
// ANCHOR_END: exercise-1

// ANCHOR: exercise-3
pub fn is_even_stripe(uv: Vec2) -> bool {
    is_even(Vec2::new(uv.x, 0.0))
}

pub fn is_even_ring(uv: Vec2) -> bool {
    is_even(Vec2::new(uv.length(), 0.0))
}
// ANCHOR_END: exercise-3
