// ANCHOR: head
//! Anti-aliasing: many rays for one pixel, and the mean of what they bring back.

pub mod views;
pub use views::STAGE;

use canvas::{Pixel, decode, encode};
use glam::{UVec2, Vec2, Vec3};
// ANCHOR_END: head

// ANCHOR: samples
/// The points of the image plane where a pixel of n × n cells is looked at, one in each
/// cell, row by row; `place` says where in its cell, from (0, 0) to (1, 1), the i-th of
/// them is.
fn cells(
    pixel: Pixel,
    n: u32,
    place: impl Fn(u32) -> Vec2,
) -> impl Iterator<Item = Vec2> {
    (0..n * n).map(move |i| {
        let cell = UVec2::new(i % n, i / n).as_vec2() + place(i);
        pixel.centre() + pixel.footprint() * (cell / n as f32 - Vec2::splat(0.5))
    })
}

/// The mean of what is seen at some points of the image plane, added up in their order.
fn mean(points: impl Iterator<Item = Vec2>, light: &dyn Fn(Vec2) -> Vec3) -> Vec3 {
    let mut sum = Vec3::ZERO;
    let mut count = 0.0;
    for point in points {
        sum += light(point);
        count += 1.0;
    }
    sum / count
}
// ANCHOR_END: samples

// ANCHOR: regular
/// The mean of n × n samples of a pixel, in the middle of as many equal cells; n is at
/// least 1.
///
/// `light` is what is seen at a point of the image plane. One sample is in the pixel's
/// centre.
///
/// Source: the talk's "Anti-Aliasing" slides, whose depth is our n.
#[must_use]
pub fn regular(pixel: Pixel, n: u32, light: &dyn Fn(Vec2) -> Vec3) -> Vec3 {
    mean(cells(pixel, n, |_| Vec2::splat(0.5)), light)
}
// ANCHOR_END: regular

// ANCHOR: jittered
/// The mean of n × n samples of a pixel, each somewhere in its own cell; n is at least 1.
///
/// Where, is as good as random, but always the same for the same pixel and sample.
///
/// Source: Cook, "Stochastic Sampling in Computer Graphics" (1986).
#[must_use]
pub fn jittered(pixel: Pixel, n: u32, light: &dyn Fn(Vec2) -> Vec3) -> Vec3 {
    mean(cells(pixel, n, |i| jitter(pixel, i)), light)
}

/// Two numbers from 0 to 1, without 1, for one sample of one pixel.
fn jitter(pixel: Pixel, sample: u32) -> Vec2 {
    let x = hash(pixel.x ^ hash(pixel.y ^ hash(sample)));
    let y = hash(x);
    // An f32 holds 24 bits of them.
    Vec2::new((x >> 8) as f32, (y >> 8) as f32) / (1 << 24) as f32
}

/// Stirs the bits of a number so that each of them depends on all.
///
/// The sum at first keeps 0 from staying 0.
///
/// Source: the multipliers and shifts are TheIronBorn's, in Chris Wellons's hash-prospector.
#[must_use]
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
/// The least difference of linear light between a pixel's samples that calls for more of
/// them.
pub const CONTRAST: f32 = 0.05;

/// The mean of n × n jittered samples where they are needed, and of 2 × 2 where those
/// agree.
///
/// Cheap where nothing happens in a pixel, and right where it can be seen that something
/// does; but what is so small that it falls between four samples is missed.
///
/// Source: Whitted 1980, with the pixel's own samples in place of its corners.
#[must_use]
pub fn adaptive(pixel: Pixel, n: u32, light: &dyn Fn(Vec2) -> Vec3) -> Vec3 {
    let points = cells(pixel, 2, |i| jitter(pixel, i));
    let samples: Vec<Vec3> = points.map(light).collect();
    let differ = |a: &Vec3| {
        let differences = samples.iter().map(|b| (*a - *b).abs().max_element());
        differences
            .into_iter()
            .any(|difference| difference > CONTRAST)
    };
    if samples.iter().any(differ) {
        jittered(pixel, n, light)
    } else {
        samples.iter().sum::<Vec3>() / 4.0
    }
}
// ANCHOR_END: adaptive

// ANCHOR: encoded
/// The bug: the mean of a screen's levels in place of the mean of light.
///
/// Levels are spread for the eye, and half the light is far more than half the levels.
#[must_use]
pub fn mean_of_levels(pixel: Pixel, n: u32, light: &dyn Fn(Vec2) -> Vec3) -> Vec3 {
    let levels = |point: Vec2| Vec3::from_array(encode(light(point)).map(f32::from));
    let mean = mean(cells(pixel, n, |_| Vec2::splat(0.5)), &levels);
    Vec3::from_array(mean.to_array().map(|level| decode(level.round() as u8)))
}
// ANCHOR_END: encoded
