//! A picture in a box, and what is rendered of it: its light, and the rays that it took.

use crate::{Pixel, rows};
use glam::{UVec2, Vec3};
use rayon::prelude::*;

impl Pixel {
    /// Iterates over the pixels of a picture, row by row from the top left.
    pub fn all(size: UVec2) -> impl Iterator<Item = Self> + Clone {
        (0..size.y).flat_map(move |y| (0..size.x).map(move |x| Self { x, y, size }))
    }
}

// ANCHOR: picture
/// A function from a pixel to linear light: red, green and blue, where 1 is white.
pub struct Picture(Box<RenderSpan>);

type RenderSpan = dyn Fn(Pixel, &mut [Vec3]) + Send + Sync;

impl Picture {
    /// Returns the picture that `radiance` defines, pixel by pixel.
    ///
    /// The light must be finite. Below 0 it is shown as black, above 1 as the brightest
    /// level.
    pub fn new(radiance: impl Fn(Pixel) -> Vec3 + Send + Sync + 'static) -> Self {
        Self::from_spans(move |first, span| {
            for (x, out) in (first.x..).zip(span) {
                *out = radiance(Pixel { x, ..first });
            }
        })
    }

    /// Returns the picture that `render_span` defines. It is given the first pixel of a
    /// span, and writes the light of this pixel and of those to its right into the slice.
    ///
    /// A pixel's light must not depend on the span in which the pixel is rendered.
    pub fn from_spans(
        render_span: impl Fn(Pixel, &mut [Vec3]) + Send + Sync + 'static,
    ) -> Self {
        Self(Box::new(render_span))
    }

    /// Writes the light of the `first` pixel and of those to its right into `span`.
    pub fn render_span(&self, first: Pixel, span: &mut [Vec3]) {
        (self.0)(first, span);
    }

    /// Returns the linear light of one pixel.
    pub fn radiance(&self, pixel: Pixel) -> Vec3 {
        let mut span = [Vec3::ZERO];
        self.render_span(pixel, &mut span);
        span[0]
    }
}
// ANCHOR_END: picture

// ANCHOR: canvas
/// A rendered picture with its light, row by row from the top, each row from the left.
pub struct Canvas {
    /// Width and height, in pixels.
    pub size: UVec2,
    /// Linear light: red, green and blue, where 1 is white.
    pub radiance: Vec<Vec3>,
    /// The same light encoded for a screen: sRGB levels, 0 to 255.
    pub levels: Vec<[u8; 3]>,
    /// The number of rays traced for it.
    pub rays: u64,
}

impl Canvas {
    /// Returns a canvas on which every pixel is black.
    pub fn black(size: UVec2) -> Self {
        let pixels = size.x as usize * size.y as usize;
        Self {
            size,
            radiance: vec![Vec3::ZERO; pixels],
            levels: vec![[0; 3]; pixels],
            rays: 0,
        }
    }

    /// Renders `picture` on all cores. The result does not depend on their number. A size
    /// of 0 in either direction gives an empty canvas.
    pub fn render(picture: &Picture, size: UVec2) -> Self {
        let mut canvas = Self::black(size);
        // A chunk of 0 pixels is not allowed, not even of nothing.
        let width = size.x.max(1) as usize;
        let rows = canvas.radiance.par_chunks_mut(width);
        let rows = rows.zip(canvas.levels.par_chunks_mut(width)).enumerate();
        canvas.rays = rows
            .map(|(y, (radiance, levels))| {
                let y = y as u32;
                rows::render_row(picture, Pixel { x: 0, y, size }, radiance, levels)
            })
            .sum();
        canvas
    }
}
// ANCHOR_END: canvas
