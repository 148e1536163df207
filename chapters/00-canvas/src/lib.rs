// ANCHOR: head
//! A picture is a function from a pixel to light; a canvas holds what a screen shows of it.

use glam::{UVec2, Vec2, Vec3};
use image::{ColorType, ImageResult};
use rayon::prelude::*;
use std::path::Path;
// ANCHOR_END: head

// ANCHOR: ours
#[expect(
    missing_docs,
    reason = "the line above the struct says what the fields are"
)]
// ANCHOR_END: ours
// ANCHOR: pixel
/// One pixel of a picture of `size` pixels; `x` counts from the left, `y` from the top.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pixel {
    pub x: u32,
    pub y: u32,
    pub size: UVec2,
}
// ANCHOR_END: pixel

// ANCHOR: ours
#[expect(
    missing_docs,
    reason = "the line above the struct says what the fields are"
)]
// ANCHOR_END: ours
// ANCHOR: canvas
/// A rendered picture: sRGB levels, 0 to 255, row by row from the top left.
pub struct Canvas {
    pub size: UVec2,
    pub levels: Vec<[u8; 3]>,
}

impl Canvas {
    /// Renders the picture whose pixels have the light that `radiance` returns: linear, where
    /// 1 is white.
    pub fn render(size: UVec2, radiance: impl Fn(Pixel) -> Vec3 + Sync) -> Self {
        let indices = (0..size.x * size.y).into_par_iter();
        let pixels = indices.map(|i| Pixel {
            x: i % size.x,
            y: i / size.x,
            size,
        });
        let levels = pixels.map(|pixel| encode(radiance(pixel))).collect();
        Self { size, levels }
    }

    /// Saves the canvas as an image, of the kind that the path's extension says.
    pub fn save(&self, path: impl AsRef<Path>) -> ImageResult<()> {
        let levels = self.levels.as_flattened();
        let UVec2 { x, y } = self.size;
        image::save_buffer(path, levels, x, y, ColorType::Rgb8)
    }
}
// ANCHOR_END: canvas

// ANCHOR: ours
#[expect(
    clippy::disallowed_methods,
    reason = "no f32 is within 10⁻⁹ of a level of a border between levels, and the power is exact to 10⁻¹³"
)]
// ANCHOR_END: ours
// ANCHOR: encode
/// Returns the sRGB levels of linear light. Light below 0 and NaN give 0, light above 1 gives
/// 255. Source: IEC 61966-2-1.
pub fn encode(radiance: Vec3) -> [u8; 3] {
    radiance.to_array().map(|channel| {
        let linear = f64::from(channel);
        let encoded = if linear <= 0.0031308 {
            12.92 * linear
        } else {
            1.055 * linear.powf(1.0 / 2.4) - 0.055
        };
        (255.0 * encoded).round() as u8
    })
}
// ANCHOR_END: encode

// ANCHOR: differing
impl Canvas {
    /// Returns how many pixels differ from those of an image file: all of them, if the file's
    /// size is another.
    pub fn differing(&self, path: impl AsRef<Path>) -> ImageResult<usize> {
        let image = image::open(path)?.into_rgb8();
        if image.dimensions() != self.size.into() {
            return Ok(self.levels.len());
        }
        let pairs = self.levels.iter().zip(image.pixels());
        Ok(pairs.filter(|(levels, pixel)| **levels != pixel.0).count())
    }
}
// ANCHOR_END: differing

// ANCHOR: centre
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

// ANCHOR: ours
// Inside the canvas: light kept beside the levels, rows, and an `encode` that is as exact and
// faster.
mod picture;
mod rays;
mod rows;
pub mod srgb;
mod stage;
pub mod views;
pub use picture::{Picture, Rendering};
pub use rays::{count_ray, count_rays, rays_so_far, rays_traced};
pub use rows::{Row, spawn_render};
pub use stage::{Knob, Scale, Stage, View, folder_name};
pub use views::STAGE;
// ANCHOR_END: ours
