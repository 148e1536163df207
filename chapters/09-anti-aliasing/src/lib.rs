// ANCHOR: head
//! Anti-aliasing: many rays per pixel, and the mean of their light.

pub mod scene;

use canvas::{Pixel, decode, encode};
use glam::{UVec2, Vec2, Vec3};
// ANCHOR_END: head

// ANCHOR: samples
/// Returns n × n points of the image plane, one per cell of a grid over the pixel, row by row
/// from the top left. `position` returns the position of the i-th within its cell, from
/// (0, 0) to (1, 1).
fn stratified_points(
    pixel: Pixel,
    n: u32,
    position: impl Fn(u32) -> Vec2,
) -> impl Iterator<Item = Vec2> {
    (0..n * n).map(move |i| {
        let cell = UVec2::new(i % n, i / n).as_vec2() + position(i);
        pixel.centre() + pixel.footprint() * (cell / n as f32 - Vec2::splat(0.5))
    })
}

/// Returns the mean radiance at some points of the image plane, added up in their order.
fn mean(points: impl Iterator<Item = Vec2>, radiance: &dyn Fn(Vec2) -> Vec3) -> Vec3 {
    let mut sum = Vec3::ZERO;
    let mut count = 0.0;
    for point in points {
        sum += radiance(point);
        count += 1.0;
    }
    sum / count
}

/// A function that takes n × n samples of a pixel: from the pixel, n, and the radiance at a
/// point of the image plane to the pixel's radiance.
pub type Sampler = fn(Pixel, u32, &dyn Fn(Vec2) -> Vec3) -> Vec3;
// ANCHOR_END: samples

// ANCHOR: regular
/// Returns the mean of n × n samples of a pixel, each in the centre of its cell; n is at
/// least 1. A single sample is in the pixel's centre.
///
/// `radiance` is the radiance at a point of the image plane.
///
/// Source: the lecture's "Anti-Aliasing" slides, whose depth is our n.
pub fn regular(pixel: Pixel, n: u32, radiance: &dyn Fn(Vec2) -> Vec3) -> Vec3 {
    mean(stratified_points(pixel, n, |_| Vec2::splat(0.5)), radiance)
}
// ANCHOR_END: regular

// ANCHOR: jittered
/// Returns the mean of n × n samples of a pixel, each anywhere in its own cell; n is at least
/// 1.
///
/// The positions come from a hash of the pixel and the sample, so that the picture is always
/// the same.
///
/// Source: Cook, "Stochastic Sampling in Computer Graphics" (1986).
pub fn jittered(pixel: Pixel, n: u32, radiance: &dyn Fn(Vec2) -> Vec3) -> Vec3 {
    mean(stratified_points(pixel, n, |i| jitter(pixel, i)), radiance)
}

/// Returns a position in [0, 1)² for one sample of one pixel.
fn jitter(pixel: Pixel, sample: u32) -> Vec2 {
    let x = hash(pixel.x ^ hash(pixel.y ^ hash(sample)));
    let y = hash(x);
    // An f32 holds 24 bits of them.
    Vec2::new((x >> 8) as f32, (y >> 8) as f32) / (1 << 24) as f32
}

/// Returns a hash of a number: any change of its bits changes about half of the result's.
///
/// The sum at the beginning keeps 0 from staying 0.
///
/// Source: the multipliers and shifts are TheIronBorn's, in Chris Wellons's hash-prospector.
#[inline]
pub fn hash(mut x: u32) -> u32 {
    x = x.wrapping_add(0x9e37_79b9);
    x ^= x >> 16;
    x = x.wrapping_mul(0x21f0_aaad);
    x ^= x >> 15;
    x = x.wrapping_mul(0xd35a_2d97);
    x ^ (x >> 15)
}
// ANCHOR_END: jittered

// ANCHOR: adaptive
/// The difference between a pixel's samples, in levels, above which more of them are taken.
pub const CONTRAST_THRESHOLD: u8 = 8;

/// Returns the mean of 2 × 2 jittered samples if no two of them differ by more than
/// [`CONTRAST_THRESHOLD`] in any channel, and otherwise that of n × n.
///
/// The differences are those of levels, not of light: in the dark, a twentieth of white is 63
/// levels.
///
/// Features smaller than the distance of the first four samples can be missed.
///
/// Source: Whitted 1980, with the pixel's own samples in place of its corners.
pub fn adaptive(pixel: Pixel, n: u32, radiance: &dyn Fn(Vec2) -> Vec3) -> Vec3 {
    let points = stratified_points(pixel, 2, |i| jitter(pixel, i));
    let samples: Vec<Vec3> = points.map(radiance).collect();
    let levels: Vec<[u8; 3]> = samples.iter().copied().map(encode).collect();
    let differ = |channel: usize| {
        let of_samples = levels.iter().map(|levels| levels[channel]);
        let (least, most) = (of_samples.clone().min(), of_samples.max());
        most > least.map(|least| least.saturating_add(CONTRAST_THRESHOLD))
    };
    if (0..3).any(differ) {
        jittered(pixel, n, radiance)
    } else {
        samples.iter().sum::<Vec3>() / 4.0
    }
}
// ANCHOR_END: adaptive

// ANCHOR: clamped
/// Returns the mean of n × n samples on a grid, as [`regular`] does, but none of them brighter
/// than white, in any channel.
///
/// An edge of a light far brighter than white is smooth then; but light is lost, wherever a
/// pixel holds both more than white and less.
pub fn clamped(pixel: Pixel, n: u32, radiance: &dyn Fn(Vec2) -> Vec3) -> Vec3 {
    regular(pixel, n, &|point| {
        let radiance = radiance(point);
        Vec3::select(radiance.cmpgt(Vec3::ONE), Vec3::ONE, radiance)
    })
}
// ANCHOR_END: clamped

// ANCHOR: encoded
/// The bug: returns the light of the mean *level* of n × n samples.
///
/// Levels are spread for the eye: half the light is far more than half the levels.
pub fn mean_of_levels(pixel: Pixel, n: u32, radiance: &dyn Fn(Vec2) -> Vec3) -> Vec3 {
    let levels = |point: Vec2| Vec3::from_array(encode(radiance(point)).map(f32::from));
    let mean = mean(stratified_points(pixel, n, |_| Vec2::splat(0.5)), &levels);
    Vec3::from_array(mean.to_array().map(|level| decode(level.round() as u8)))
}
// ANCHOR_END: encoded

// ANCHOR: sobol
pub mod sobol;
// ANCHOR_END: sobol

// ANCHOR: ours
// The exercises; and the pictures of this page, for the window, the command line and the tests
// of this project.
pub mod exercises;
pub mod views;
pub use views::STAGE;
// ANCHOR_END: ours
