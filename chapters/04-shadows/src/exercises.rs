//! The chapter's exercises: functions for you to write.

// ANCHOR: uses
use crate::scene::lit_still_life;
use crate::{PointLight, Scene, is_visible, trace};
use glam::Vec3;
use plane_hit::Texture;
use ray_casting::Ray;
// ANCHOR_END: uses

// ANCHOR: exercise-1
/// Returns the still life, made of `materials`, with a third light where the camera's eye is,
/// of intensity 0.3.
pub fn still_life_with_headlamp(materials: [Texture; 6]) -> Scene<Texture> {
    // Yours to write.
    lit_still_life(materials)
}
// ANCHOR_END: exercise-1

// ANCHOR: exercise-2
/// Returns the light along a ray, as [`trace`] does with [`is_visible`], but with coloured
/// lights: `colours` holds one for each of the scene's lights, in place of its intensity.
pub fn trace_coloured(scene: &Scene<Texture>, _colours: &[Vec3], ray: &Ray) -> Vec3 {
    // Yours to write.
    trace(scene, ray, is_visible)
}
// ANCHOR_END: exercise-2

// ANCHOR: exercise-4
/// Returns what is left of a light's intensity at a `point`: it fades with the square of the
/// distance, and at a distance of 1 all of it is left.
pub fn faded(light: &PointLight, _point: Vec3) -> f32 {
    // Yours to write.
    light.intensity
}
// ANCHOR_END: exercise-4
