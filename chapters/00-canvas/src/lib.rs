// ANCHOR: head
//! A picture is a function from a pixel to light; a canvas paints it, keeps it, and shows
//! it.

mod command_line;
mod file;
mod srgb;
mod stage;
pub mod views;
#[cfg(feature = "window")]
mod window;

pub use command_line::{
    Asked, Failure, Task, command, complain, end_with, matches, run, run_with, say,
};
pub use file::{check_destination, write_file};
pub use srgb::{decode, encode};
pub use stage::{Knob, Scale, Stage, View};
pub use views::STAGE;
#[cfg(feature = "window")]
pub use window::{digit, size_on_screen};

use glam::{UVec2, Vec2, Vec3};
use rayon::prelude::*;
use std::cell::Cell;
use std::sync::mpsc::{Receiver, channel};
// ANCHOR_END: head

// ANCHOR: pixel
/// One pixel of a picture of `size` pixels; `x` counts from the left, `y` from the top.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pixel {
    /// Column, from 0 at the left.
    pub x: u32,
    /// Row, from 0 at the top.
    pub y: u32,
    /// Width and height of the whole picture, in pixels.
    pub size: UVec2,
}

impl Pixel {
    /// The pixel's centre on the image plane: x to the right, y up, the origin in the
    /// middle.
    ///
    /// The image plane is 2 high, from −1 to 1, and as wide as the picture's shape makes
    /// it.
    #[must_use]
    pub fn centre(self) -> Vec2 {
        let half = self.size.as_vec2() / 2.0;
        Vec2::new(self.x as f32 + 0.5 - half.x, half.y - (self.y as f32 + 0.5)) / half.y
    }

    /// The side of the pixel, a square, on the image plane.
    #[must_use]
    pub fn footprint(self) -> f32 {
        2.0 / self.size.y as f32
    }
}
// ANCHOR_END: pixel

// ANCHOR: picture
/// What to paint: a pure function from a pixel to linear light, red, green and blue; 1 is
/// white.
pub struct Picture(Box<PaintRun>);

type PaintRun = dyn Fn(Pixel, &mut [Vec3]) + Send + Sync;

impl Picture {
    /// A picture from its function.
    ///
    /// The light must be finite. What is below 0 is shown as black, what is above 1 as
    /// full.
    pub fn new(light: impl Fn(Pixel) -> Vec3 + Send + Sync + 'static) -> Self {
        Self::by_runs(move |first, run| {
            for (x, place) in (first.x..).zip(run) {
                *place = light(Pixel { x, ..first });
            }
        })
    }

    /// A picture from what paints a run of pixels: the first, and those to the right of
    /// it, as many as there are places for their light.
    ///
    /// The light of a pixel must not depend on the run that it is painted in.
    pub fn by_runs(paint: impl Fn(Pixel, &mut [Vec3]) + Send + Sync + 'static) -> Self {
        Self(Box::new(paint))
    }

    /// Paints the first pixel and those to the right of it, as many as fit into `run`.
    pub fn paint(&self, first: Pixel, run: &mut [Vec3]) {
        (self.0)(first, run);
    }

    /// The light of one pixel.
    #[must_use]
    pub fn light(&self, pixel: Pixel) -> Vec3 {
        let mut light = [Vec3::ZERO];
        self.paint(pixel, &mut light);
        light[0]
    }
}
// ANCHOR_END: picture

// ANCHOR: rays
thread_local! {
    static RAYS: Cell<u64> = const { Cell::new(0) };
}

/// Counts one ray. Called wherever a ray is cast; a painted [`Row`] knows how many it
/// took.
pub fn count_ray() {
    count_rays(1);
}

/// Counts so many rays at once.
pub fn count_rays(rays: u32) {
    RAYS.set(RAYS.get() + u64::from(rays));
}

/// How many rays this thread has counted so far.
#[must_use]
pub fn rays_so_far() -> u64 {
    RAYS.get()
}
// ANCHOR_END: rays

// ANCHOR: row
/// One painted row of a picture.
pub struct Row {
    /// Which row, from 0 at the top.
    pub y: u32,
    /// Linear light, from left to right.
    pub light: Vec<Vec3>,
    /// The same as a screen wants it: sRGB-encoded, 0 to 255.
    pub levels: Vec<[u8; 3]>,
    /// How many rays it took.
    pub rays: u64,
}

impl Row {
    fn paint(picture: &Picture, size: UVec2, y: u32) -> Self {
        let mut light = vec![Vec3::ZERO; size.x as usize];
        let mut levels = vec![[0; 3]; size.x as usize];
        let rays = paint_row(picture, size, y, &mut light, &mut levels);
        Self {
            y,
            light,
            levels,
            rays,
        }
    }
}

/// Paints a row into its place; returns how many rays it took.
fn paint_row(
    picture: &Picture,
    size: UVec2,
    y: u32,
    light: &mut [Vec3],
    levels: &mut [[u8; 3]],
) -> u64 {
    let rays_before = rays_so_far();
    picture.paint(Pixel { x: 0, y, size }, light);
    debug_assert!(
        light.iter().all(|light| light.is_finite()),
        "row {y} has a pixel that is not finite"
    );
    for (level, light) in levels.iter_mut().zip(light) {
        *level = encode(*light);
    }
    rays_so_far() - rays_before
}
// ANCHOR_END: row

// ANCHOR: canvas
/// A painted picture in memory, row by row from the top, each row from the left.
pub struct Canvas {
    /// Width and height, in pixels.
    pub size: UVec2,
    /// Linear light, red, green and blue; 1 is white.
    pub light: Vec<Vec3>,
    /// The same as a screen wants it: sRGB-encoded, 0 to 255.
    pub levels: Vec<[u8; 3]>,
    /// How many rays it took.
    pub rays: u64,
}

impl Canvas {
    /// A canvas with nothing on it: black.
    #[must_use]
    pub fn black(size: UVec2) -> Self {
        let pixels = size.x as usize * size.y as usize;
        Self {
            size,
            light: vec![Vec3::ZERO; pixels],
            levels: vec![[0; 3]; pixels],
            rays: 0,
        }
    }

    /// Paints `picture` on all cores. The result does not depend on how many there are.
    #[must_use]
    pub fn paint(picture: &Picture, size: UVec2) -> Self {
        let mut canvas = Self::black(size);
        let width = size.x as usize;
        let rows = canvas.light.par_chunks_mut(width);
        let rows = rows.zip(canvas.levels.par_chunks_mut(width)).enumerate();
        canvas.rays = rows
            .map(|(y, (light, levels))| paint_row(picture, size, y as u32, light, levels))
            .sum();
        canvas
    }

    /// Puts a painted row in its place.
    pub fn put(&mut self, row: &Row) {
        let start = row.y as usize * self.size.x as usize;
        let place = start..start + row.light.len();
        self.light[place.clone()].copy_from_slice(&row.light);
        self.levels[place].copy_from_slice(&row.levels);
        self.rays += row.rays;
    }
}
// ANCHOR_END: canvas

// ANCHOR: background
/// Paints `picture` in the background; rows arrive in whatever order they are done.
///
/// The painting stops when the receiver is dropped, or when every row has been sent.
#[must_use]
pub fn paint_in_background(picture: Picture, size: UVec2) -> Receiver<Row> {
    let (sender, rows) = channel();
    rayon::spawn(move || {
        // An error means that nobody waits for the rows any more: stopping is right.
        let _ = (0..size.y)
            .into_par_iter()
            .try_for_each_with(sender, |sender, y| {
                sender.send(Row::paint(&picture, size, y))
            });
    });
    rows
}
// ANCHOR_END: background
