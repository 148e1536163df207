//! The still life with its ball of amber glass.

use crate::Absorbing;
use glam::Vec3;
use refraction::Optics;
use refraction::scene::{AIR, GLASS, still_life_with_glass};
use shadows::Scene;

// ANCHOR: amber
/// The absorption of amber glass, per unit of length: red, green and blue.
pub const AMBER: Vec3 = Vec3::new(0.1, 0.7, 2.5);

/// Returns the still life with glass of the given absorption.
#[must_use]
pub fn absorbing_still_life(absorption: Vec3) -> Scene<Absorbing> {
    still_life_with_glass(GLASS, AIR).map(|material| Absorbing {
        material,
        absorption: match material.optics {
            Optics::Dielectric { .. } => absorption,
            Optics::Opaque { .. } => Vec3::ZERO,
        },
    })
}
// ANCHOR_END: amber
