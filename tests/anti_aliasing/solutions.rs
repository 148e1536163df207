//! The exercises' solutions, as the book prints them.

use ::anti_aliasing::{hash, jittered, regular};
use ::canvas::Pixel;
use glam::{UVec2, Vec2, Vec3};

// ANCHOR: exercise-1
pub fn triangle_filter(pixel: Pixel, n: u32, radiance: &dyn Fn(Vec2) -> Vec3) -> Vec3 {
    let (mut sum, mut weights) = (Vec3::ZERO, 0.0);
    for i in 0..n * n {
        let cell = UVec2::new(i % n, i / n).as_vec2() + Vec2::splat(0.5);
        // From the centre, in pixels: from −1 to 1.
        let offset = 2.0 * cell / n as f32 - Vec2::ONE;
        let weight = (1.0 - offset.x.abs()) * (1.0 - offset.y.abs());
        sum += weight * radiance(pixel.centre() + pixel.footprint() * offset);
        weights += weight;
    }
    sum / weights
}
// ANCHOR_END: exercise-1

// ANCHOR: exercise-3
pub fn half_jittered(pixel: Pixel, n: u32, radiance: &dyn Fn(Vec2) -> Vec3) -> Vec3 {
    if pixel.x < pixel.size.x / 2 {
        regular(pixel, n, radiance)
    } else {
        jittered(pixel, n, radiance)
    }
}
// ANCHOR_END: exercise-3

// ANCHOR: exercise-4
pub fn in_motion(pixel: Pixel, n: u32, radiance: &dyn Fn(Vec2, f32) -> Vec3) -> Vec3 {
    let mut sum = Vec3::ZERO;
    for i in 0..n * n {
        let cell = UVec2::new(i % n, i / n).as_vec2() + Vec2::splat(0.5);
        let offset = cell / n as f32 - Vec2::splat(0.5);
        let bits = hash(pixel.x ^ hash(pixel.y ^ hash(i)));
        // An f32 holds 24 bits of them.
        let time = (bits >> 8) as f32 / (1 << 24) as f32;
        sum += radiance(pixel.centre() + pixel.footprint() * offset, time);
    }
    sum / (n * n) as f32
}
// ANCHOR_END: exercise-4
