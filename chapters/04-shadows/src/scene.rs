//! The still life in the light of its two lights.

use crate::{PointLight, Scene};
use glam::Vec3;
use plane_hit::scene::still_life;
use ray_casting::SKY;

// ANCHOR: lit
/// Returns the still life, made of `materials`, with its two lights.
///
/// # Panics
/// Never: both lights are valid, and no two objects have the same surface.
pub fn lit_still_life<M>(materials: [M; 6]) -> Scene<M> {
    let light = |x, y, z, intensity| {
        PointLight::new(Vec3::new(x, y, z), intensity).expect("a valid light")
    };
    let lights = vec![light(-5.0, 7.0, -6.0, 0.6), light(4.0, 6.0, -4.0, 0.4)];
    Scene::new(still_life(materials), lights, SKY).expect("six surfaces")
}
// ANCHOR_END: lit
