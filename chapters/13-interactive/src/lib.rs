// ANCHOR: head
//! A walk through the still life while it is traced: coarse while we move, exact while we
//! stand.

pub mod explain;
pub mod overlay;
mod pose;
mod render_thread;
mod tree;
pub use pose::{CameraPose, FOCAL_LENGTHS, PoseError, WORLD};
pub use render_thread::{Frame, RenderRequest, RenderThread};

use canvas::srgb::encode;
use canvas::{Canvas, Pixel};
use glam::{UVec2, Vec3};
use rayon::prelude::*;
use std::time::Duration;
// ANCHOR_END: head

// ANCHOR: coarse
/// The coarsest level of detail.
pub const MAX_LOD: u32 = 5;

/// Returns the size of a frame at a level of detail: at 0 the size of the whole picture, at
/// each further level half as wide and half as high, rounded up.
pub fn size_at_lod(size: UVec2, lod: u32) -> UVec2 {
    let block = 1 << lod;
    UVec2::new(size.x.div_ceil(block), size.y.div_ceil(block))
}

/// Returns the pixel of the coarser frame that covers `pixel`.
pub fn block_of(pixel: Pixel, lod: u32) -> Pixel {
    Pixel {
        x: pixel.x >> lod,
        y: pixel.y >> lod,
        size: size_at_lod(pixel.size, lod),
    }
}

/// Returns the next frame's level of detail: one coarser if the last frame took longer than
/// `target`, one finer if `target` has room for five such frames.
///
/// A finer frame has four times the pixels. The fifth frame is a margin: without it, the
/// level would change with every frame.
pub fn next_lod(lod: u32, took: Duration, target: Duration) -> u32 {
    if took > target && lod < MAX_LOD {
        lod + 1
    } else if 5 * took < target && lod > 0 {
        lod - 1
    } else {
        lod
    }
}
// ANCHOR_END: coarse

// ANCHOR: accumulate
/// The sum of the samples of every pixel.
pub struct Accumulator {
    sums: Vec<Vec3>,
    count: u32,
}

impl Accumulator {
    /// Returns an accumulator without samples, for pictures of `size` pixels.
    pub fn new(size: UVec2) -> Self {
        Self {
            sums: vec![Vec3::ZERO; size.x as usize * size.y as usize],
            count: 0,
        }
    }

    /// Adds one sample of every pixel, then replaces it by the mean of all samples so far.
    ///
    /// The samples are added in their order and divided once, so that after n × n of them
    /// the mean has the bits of [`anti_aliasing::regular`].
    pub fn add(&mut self, sample: &mut Canvas) {
        self.count += 1;
        let count = self.count as f32;
        let pixels = sample.radiance.par_iter_mut().zip(&mut sample.levels);
        pixels
            .zip(&mut self.sums)
            .for_each(|((radiance, levels), sum)| {
                *sum += *radiance;
                *radiance = *sum / count;
                *levels = encode(*radiance);
            });
    }
}
// ANCHOR_END: accumulate

// ANCHOR: ours
// The exercises; and the pictures of this page, for the window, the command line and the tests
// of this project.
pub mod exercises;
pub mod views;
pub use views::STAGE;
// ANCHOR_END: ours
