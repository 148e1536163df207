//! Rows, rendered one by one: into a canvas, in the background, for a window to show, or for
//! a file that is larger than the memory.

use crate::srgb::encode;
use crate::{Canvas, Picture, Pixel, rays_so_far};
use glam::{UVec2, Vec3};
use rayon::prelude::*;
use std::sync::mpsc::{Receiver, channel};

// ANCHOR: row
/// Renders the row that begins with the `first` pixel; returns the number of rays traced.
pub(crate) fn render_row(
    picture: &Picture,
    first: Pixel,
    radiance: &mut [Vec3],
    levels: &mut [[u8; 3]],
) -> u64 {
    let rays_before = rays_so_far();
    picture.render_span(first, radiance);
    debug_assert!(
        radiance.iter().all(|radiance| radiance.is_finite()),
        "row {} has a pixel that is not finite",
        first.y
    );
    for (level, radiance) in levels.iter_mut().zip(radiance) {
        *level = encode(*radiance);
    }
    rays_so_far() - rays_before
}

/// One rendered row of a picture.
pub struct Row {
    /// Its number, from 0 at the top.
    pub y: u32,
    /// Linear light, from left to right.
    pub radiance: Vec<Vec3>,
    /// The same light as sRGB levels, 0 to 255.
    pub levels: Vec<[u8; 3]>,
    /// The number of rays traced for it.
    pub rays: u64,
}

impl Canvas {
    /// Copies a rendered row into the canvas.
    ///
    /// # Panics
    /// If the row is not as wide as the canvas, or below its last row.
    pub fn write_row(&mut self, row: &Row) {
        let start = row.y as usize * self.size.x as usize;
        let pixels = start..start + self.size.x as usize;
        self.radiance[pixels.clone()].copy_from_slice(&row.radiance);
        self.levels[pixels].copy_from_slice(&row.levels);
        self.rays += row.rays;
    }
}
// ANCHOR_END: row

// ANCHOR: background
/// Renders `picture` in the background; rows arrive in the order in which they are done.
///
/// Rendering stops when the receiver is dropped, or when every row has been sent.
pub fn spawn_render(picture: Picture, size: UVec2) -> Receiver<Row> {
    let (sender, rows) = channel();
    rayon::spawn(move || {
        // An error means that the receiver is gone: then it is right to stop.
        let _ = (0..size.y)
            .into_par_iter()
            .try_for_each_with(sender, |sender, y| {
                let mut radiance = vec![Vec3::ZERO; size.x as usize];
                let mut levels = vec![[0; 3]; size.x as usize];
                let first = Pixel { x: 0, y, size };
                let rays = render_row(&picture, first, &mut radiance, &mut levels);
                sender.send(Row {
                    y,
                    radiance,
                    levels,
                    rays,
                })
            });
    });
    rows
}
// ANCHOR_END: background

/// The number of rows that [`Picture::render_rows`] keeps in memory.
const BAND: u32 = 64;

impl Picture {
    /// Renders the picture on all cores, and gives `write` the levels of a few whole rows at a
    /// time, in order from the top. No more of the picture is ever in memory. A picture without
    /// a pixel has no rows.
    ///
    /// # Errors
    /// Those of `write`; nothing more is then rendered.
    pub fn render_rows<E>(
        &self,
        size: UVec2,
        mut write: impl FnMut(&[[u8; 3]]) -> Result<(), E>,
    ) -> Result<(), E> {
        if size.x == 0 {
            return Ok(());
        }
        let width = size.x as usize;
        let mut band = vec![[0; 3]; width * BAND.min(size.y) as usize];
        for top in (0..size.y).step_by(BAND as usize) {
            let rows = BAND.min(size.y - top) as usize;
            let levels = &mut band[..rows * width];
            levels
                .par_chunks_mut(width)
                .zip(top..top + rows as u32)
                .for_each_init(
                    || vec![Vec3::ZERO; width],
                    |radiance, (levels, y)| {
                        render_row(self, Pixel { x: 0, y, size }, radiance, levels);
                    },
                );
            write(levels)?;
        }
        Ok(())
    }
}
