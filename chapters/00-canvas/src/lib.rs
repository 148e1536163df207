// ANCHOR: ours
//! A picture is a function from a pixel to light; the canvas renders it.
// ANCHOR_END: ours
// ANCHOR: render
use glam::{UVec2, Vec3};
pub use image::{ImageResult, RgbImage};
use rayon::prelude::*;

/// One pixel of a picture.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pixel {
    /// Column, from 0 at the left.
    pub x: u32,
    /// Row, from 0 at the top.
    pub y: u32,
    /// Width and height of the whole picture, in pixels.
    pub size: UVec2,
}

/// Renders a picture on all cores: `radiance` returns a pixel's linear light, 1 for white.
pub fn render(size: UVec2, radiance: impl Fn(Pixel) -> Vec3 + Sync) -> RgbImage {
    let mut picture = RgbImage::new(size.x, size.y);
    let pixels = picture.par_chunks_mut(3).enumerate();
    pixels.for_each(|(i, levels)| {
        let (x, y) = (i as u32 % size.x, i as u32 / size.x);
        levels.copy_from_slice(&encode(radiance(Pixel { x, y, size })));
    });
    picture
}
// ANCHOR_END: render

// ANCHOR: ours
#[expect(
    clippy::disallowed_methods,
    reason = "no f32 is within 10⁻⁹ of a level of a border between two levels, and the power is exact to 10⁻¹³"
)]
// ANCHOR_END: ours
// ANCHOR: encode
/// Returns the sRGB levels of linear light: 0 to 255, also for light below 0 and above 1.
pub fn encode(radiance: Vec3) -> [u8; 3] {
    radiance.as_dvec3().to_array().map(|v| {
        let curve = 1.055 * v.powf(1.0 / 2.4) - 0.055;
        let encoded = if v <= 0.0031308 { 12.92 * v } else { curve };
        (255.0 * encoded).round() as u8
    })
}
// ANCHOR_END: encode

// ANCHOR: differing
/// Returns how many pixels differ from those of an image file of the same size.
pub fn differing(picture: &RgbImage, path: &str) -> ImageResult<usize> {
    let other = image::open(path)?.into_rgb8();
    assert_eq!(picture.dimensions(), other.dimensions(), "{path}");
    let pairs = picture.pixels().zip(other.pixels());
    Ok(pairs.filter(|(pixel, other)| pixel != other).count())
}
// ANCHOR_END: differing

// ANCHOR: centre
use glam::Vec2;

impl Pixel {
    /// Returns the pixel's centre on the image plane: x to the right, y up, the origin in
    /// the middle. The image plane is 2 high, from −1 to 1, and as wide as the picture's
    /// aspect ratio makes it.
    pub fn centre(self) -> Vec2 {
        let half = self.size.as_vec2() / 2.0;
        Vec2::new(self.x as f32 + 0.5 - half.x, half.y - (self.y as f32 + 0.5)) / half.y
    }
}
// ANCHOR_END: centre

// ANCHOR: ours
#[expect(
    clippy::disallowed_methods,
    reason = "the power is exact to 10⁻¹³, and no level's light is so near the middle of two f32s"
)]
// ANCHOR_END: ours
// ANCHOR: samples
/// Returns the linear light that sRGB encodes to `encoded`, from 0 to 1: the inverse of the
/// formula in [`encode`].
fn linear(encoded: f64) -> f64 {
    if encoded <= 0.04045 {
        encoded / 12.92
    } else {
        ((encoded + 0.055) / 1.055).powf(2.4)
    }
}

/// Returns the linear light in the middle of a `level`: that which sRGB encodes to
/// `level` / 255.
///
/// It is encoded to `level` again, and so is the mean of many such lights, although rounding
/// moves it a little.
pub fn decode(level: u8) -> f32 {
    linear(f64::from(level) / 255.0) as f32
}

impl Pixel {
    /// Returns the length of the pixel's side on the image plane.
    pub fn footprint(self) -> f32 {
        2.0 / self.size.y as f32
    }
}
// ANCHOR_END: samples

// ANCHOR: count
mod rays;
pub use rays::{count_ray, count_rays, rays_so_far, rays_traced};
// ANCHOR_END: count

// ANCHOR: inside
pub mod exercises;
mod picture;
mod rows;
pub mod srgb;
mod stage;
pub mod views;
pub use picture::{Canvas, Picture};
pub use rows::{Row, spawn_render};
pub use stage::{Knob, Scale, Stage, View, folder_name};
pub use views::STAGE;
// ANCHOR_END: inside
