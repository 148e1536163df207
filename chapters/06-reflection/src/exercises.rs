//! The chapter's exercises: functions for you to write.

// ANCHOR: uses
use crate::scene::still_life_mirrors;
use crate::{Mirror, PathBudget, trace};
use glam::Vec3;
use ray_casting::Ray;
use shadows::Scene;
// ANCHOR_END: uses

// ANCHOR: exercise-1
/// Returns the still life's surfaces with a floor that is a mirror as well, with a reflectivity
/// of 0.3.
pub fn still_life_on_a_mirror() -> [Mirror; 6] {
    // Yours to write.
    still_life_mirrors()
}
// ANCHOR_END: exercise-1

// ANCHOR: exercise-2
/// Returns the radiance along a ray, as [`trace`] does, but with tinted mirrors: `tints` holds
/// the fractions of red, green and blue light that each of the scene's objects reflects, in
/// place of its reflectivity. A mirror is followed as long as any of the three matters.
pub fn trace_tinted(
    scene: &Scene<Mirror>,
    _tints: &[Vec3],
    ray: &Ray,
    budget: PathBudget,
) -> Vec3 {
    // Yours to write.
    trace(scene, ray, budget)
}
// ANCHOR_END: exercise-2

// ANCHOR: exercise-3
/// Returns the indices of the pixels that differ between two pictures of the same size, given
/// by their levels, in ascending order.
pub fn differing_pixels(_first: &[[u8; 3]], _second: &[[u8; 3]]) -> Vec<usize> {
    // Yours to write.
    Vec::new()
}
// ANCHOR_END: exercise-3
