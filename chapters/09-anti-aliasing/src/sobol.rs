// ANCHOR: sobol
//! Sobol's sequence: samples of a pixel whose number need not be known beforehand, since more
//! of them fill the gaps between the first.

use crate::hash;
use canvas::Pixel;
use glam::{Vec2, Vec3};

/// Returns the position in [0, 1)² of a pixel's i-th sample: Sobol's sequence, scrambled for
/// each pixel by Owen's permutations.
///
/// Of the first 4ᵏ samples, one is in each cell of a 2ᵏ × 2ᵏ grid, and so it is for each
/// further 4ᵏ.
///
/// Source: Burley, "Practical Hash-based Owen Scrambling" (JCGT 9(4), 2020).
pub fn sample_position(pixel: Pixel, i: u32) -> Vec2 {
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

/// Returns Owen's permutation of `x`: each bit is flipped or not, as the bits above it and
/// the seed decide.
///
/// Source: Laine and Karras, "Stratified Sampling for Stochastic Transparency" (2011).
fn scramble(x: u32, seed: u32) -> u32 {
    let mut x = x.reverse_bits().wrapping_add(seed);
    // Multiplying by an even number carries a bit upwards only, so the bits are reversed.
    for even in [0x6c50_b47c, 0xb82f_1e52, 0xc7af_e638, 0x8d22_f6e6] {
        x ^= x.wrapping_mul(even);
    }
    x.reverse_bits()
}

/// Returns the point of the image plane at a `position` in [0, 1]² within a pixel.
pub fn image_point(pixel: Pixel, position: Vec2) -> Vec2 {
    pixel.centre() + pixel.footprint() * (position - Vec2::splat(0.5))
}

/// Returns the mean of a pixel's first n × n samples; n is at least 1.
pub fn low_discrepancy(pixel: Pixel, n: u32, radiance: &dyn Fn(Vec2) -> Vec3) -> Vec3 {
    let samples =
        (0..n * n).map(|i| radiance(image_point(pixel, sample_position(pixel, i))));
    samples.sum::<Vec3>() / (n * n) as f32
}
// ANCHOR_END: sobol
