//! The chapter's exercises: functions for you to write.

// ANCHOR: uses
use crate::scene::still_life_surfaces;
use crate::{Phong, phong};
use glam::Vec3;
use shadows::Interaction;
// ANCHOR_END: uses

// ANCHOR: exercise-1
/// Returns the still life's surfaces, each ball with another shininess: 5, 20, 80, 320 and 1280
/// for the red one, the mirror, the green, the blue and the glass.
pub fn five_shininesses() -> [Phong; 6] {
    // Yours to write.
    still_life_surfaces()
}
// ANCHOR_END: exercise-1

// ANCHOR: exercise-2
/// Returns the light that a surface reflects, as [`phong`] does, but with Blinn's highlight:
/// k_s (N·H)ⁿ, where H is the unit vector halfway between L and V.
pub fn blinn_phong(
    surface: &Phong,
    colour: Vec3,
    at: &Interaction,
    to_light: Vec3,
) -> Vec3 {
    // Yours to write.
    phong(surface, colour, at, to_light)
}
// ANCHOR_END: exercise-2

// ANCHOR: exercise-3
/// Returns the ambient light on a surface with a unit `normal`: `sky` if it faces upwards,
/// `ground` if it faces downwards, and in between the more of the sky's the more it faces up,
/// in proportion to the normal's height.
pub fn ambient_from_around(sky: Vec3, ground: Vec3, _normal: Vec3) -> Vec3 {
    // Yours to write.
    (sky + ground) / 2.0
}
// ANCHOR_END: exercise-3
