//! The chapter's exercises: functions for you to write.

// ANCHOR: uses
use crate::{jittered, regular};
use canvas::Pixel;
use glam::{Vec2, Vec3};
// ANCHOR_END: uses

// ANCHOR: exercise-1
/// Returns the weighted mean of n × n samples on a grid over a square twice as wide as the
/// pixel, around the same centre. A sample's weight is the product of two triangles, one for x
/// and one for y: from 1 in the pixel's centre it falls to 0 a whole pixel away.
pub fn triangle_filter(pixel: Pixel, n: u32, radiance: &dyn Fn(Vec2) -> Vec3) -> Vec3 {
    // Yours to write.
    regular(pixel, n, radiance)
}
// ANCHOR_END: exercise-1

// ANCHOR: exercise-3
/// Returns the mean of n × n samples of a pixel, on a grid in the left half of the picture, and
/// jittered in the right half.
pub fn half_jittered(pixel: Pixel, n: u32, radiance: &dyn Fn(Vec2) -> Vec3) -> Vec3 {
    // Yours to write.
    jittered(pixel, n, radiance)
}
// ANCHOR_END: exercise-3

// ANCHOR: exercise-4
/// Returns the mean of n × n samples of a pixel in a world that moves. `radiance` is given a
/// point of the image plane and a time, from 0, when the shutter opens, to 1, when it closes.
/// The times fill this interval, and have nothing to do with the places of the samples.
pub fn in_motion(pixel: Pixel, n: u32, radiance: &dyn Fn(Vec2, f32) -> Vec3) -> Vec3 {
    // Yours to write.
    regular(pixel, n, &|point| radiance(point, 0.5))
}
// ANCHOR_END: exercise-4
