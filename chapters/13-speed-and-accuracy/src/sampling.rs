//! Where to look in a pixel, so that every few more looks fill the gaps of those before.

use anti_aliasing::hash;
use canvas::Pixel;
use glam::{Vec2, Vec3};

// ANCHOR: sobol
/// The i-th of a pixel's places, from (0, 0) to (1, 1), without 1: Sobol's sequence,
/// scrambled for each pixel by Owen's permutations.
///
/// The first 4ᵏ of them are one in each cell of a grid of 2ᵏ × 2ᵏ, and so are the next 4ᵏ.
///
/// Source: Burley, "Practical Hash-based Owen Scrambling" (JCGT 9(4), 2020).
#[must_use]
pub fn place(pixel: Pixel, i: u32) -> Vec2 {
    let seed = hash(pixel.x ^ hash(pixel.y));
    // The first dimension mirrors the bits of i about the point; the second sums
    // Pascal's triangle modulo 2.
    let x = i.reverse_bits();
    let mut y = 0;
    let mut column = 1 << 31;
    for bit in 0..32 {
        if i >> bit & 1 == 1 {
            y ^= column;
        }
        column ^= column >> 1;
    }
    let scrambled = [scramble(x, seed), scramble(y, hash(seed))];
    // An f32 holds 24 bits of them.
    Vec2::from_array(scrambled.map(|bits| (bits >> 8) as f32)) / (1 << 24) as f32
}

/// Owen's permutation: each bit is flipped or not, as the bits above it and the seed
/// decide.
///
/// Source: Laine and Karras, "Stratified Sampling for Stochastic Transparency" (2011).
fn scramble(x: u32, seed: u32) -> u32 {
    let mut x = x.reverse_bits().wrapping_add(seed);
    // Multiplying by an even number carries a bit upwards only, and all is upside down.
    for even in [0x6c50_b47c, 0xb82f_1e52, 0xc7af_e638, 0x8d22_f6e6] {
        x ^= x.wrapping_mul(even);
    }
    x.reverse_bits()
}
// ANCHOR_END: sobol

/// The point of the image plane at a `place` of a pixel.
#[must_use]
pub fn point(pixel: Pixel, place: Vec2) -> Vec2 {
    pixel.centre() + pixel.footprint() * (place - Vec2::splat(0.5))
}

/// The mean of n × n samples of a pixel at the first [`place`]s; n is at least 1.
#[must_use]
pub fn low_discrepancy(pixel: Pixel, n: u32, light: &dyn Fn(Vec2) -> Vec3) -> Vec3 {
    let samples = (0..n * n).map(|i| light(point(pixel, place(pixel, i))));
    samples.sum::<Vec3>() / (n * n) as f32
}
