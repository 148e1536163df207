// ANCHOR: head
//! A walk through the still life while it is traced: coarse while we move, exact while we
//! stand.

mod command_line;
pub mod explain;
pub mod overlay;
mod painter;
mod shot;
mod tree;
pub mod views;
mod window;
pub use command_line::obey;
pub use views::STAGE;

use canvas::{Picture, Pixel};
use glam::{UVec2, Vec2, Vec3};
use ray_casting::Camera;
use ray_casting::views::STILL_LIFE_FOCAL_LENGTH;
use std::fmt;
use std::str::FromStr;
use std::sync::{Arc, Mutex};
use std::time::Duration;
// ANCHOR_END: head

// ANCHOR: walker
/// Who walks: where the eye is, where it looks, and by which focal length.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Walker {
    eye: Vec3,
    forward: Vec3,
    focal_length: f32,
}

/// How far the walker gets from the still life, in each direction.
pub const WORLD: f32 = 1000.0;

/// The shortest and the longest focal length.
pub const FOCAL_LENGTHS: [f32; 2] = [0.25, 16.0];

/// How steeply the walker can look up or down: the largest y of a unit vector.
const STEEPEST: f32 = 0.99;

impl Walker {
    /// Before the still life, where the book's camera stands.
    pub const START: Self = Self {
        eye: Vec3::new(0.0, 2.0, -7.0),
        forward: Vec3::new(0.0, -1.1, 7.0),
        focal_length: STILL_LIFE_FOCAL_LENGTH,
    };

    /// None beyond the [`WORLD`]'s end, outside of the [`FOCAL_LENGTHS`], for a direction
    /// that is none or too steep, and for what is not finite.
    #[must_use]
    pub fn new(eye: Vec3, forward: Vec3, focal_length: f32) -> Option<Self> {
        let is_in = eye.abs().max_element() <= WORLD;
        let [shortest, longest] = FOCAL_LENGTHS;
        let is_long = (shortest..=longest).contains(&focal_length);
        let camera = Camera::new(eye, forward, Vec3::Y, focal_length)?;
        let is_steep = camera.forward.y.abs() > STEEPEST;
        (is_in && is_long && !is_steep).then_some(Self {
            eye,
            forward,
            focal_length,
        })
    }

    /// What the walker sees by.
    #[must_use]
    pub fn camera(&self) -> Camera {
        Camera::new(self.eye, self.forward, Vec3::Y, self.focal_length)
            .expect("`new` has tried it")
    }

    /// So many steps to the right, up, and ahead; ahead is level, wherever we look.
    /// Leaves out those that lead beyond the world's end.
    #[must_use]
    pub fn moved(self, steps: Vec3) -> Self {
        let right = self.camera().right;
        let ahead = right.cross(Vec3::Y);
        // One by one: who cannot go on ahead can still go aside.
        let steps = [steps.x * right, steps.y * Vec3::Y, steps.z * ahead];
        steps.into_iter().fold(self, |walker, step| {
            let eye = walker.eye + step;
            Self::new(eye, self.forward, self.focal_length).unwrap_or(walker)
        })
    }

    /// Turned so that what was seen at a `point` of the image plane is in its middle; only
    /// to the side, where that would be too steep.
    #[must_use]
    pub fn turned(self, point: Vec2) -> Self {
        let towards = |point| {
            let forward = self.camera().ray(point).direction;
            Self::new(self.eye, forward, self.focal_length)
        };
        let aside = Vec2::new(point.x, 0.0);
        towards(point).or_else(|| towards(aside)).unwrap_or(self)
    }

    /// Closer by a `factor`, through the lens alone. Stays where there is no such lens.
    #[must_use]
    pub fn zoomed(self, factor: f32) -> Self {
        let focal_length = factor * self.focal_length;
        Self::new(self.eye, self.forward, focal_length).unwrap_or(self)
    }
}
// ANCHOR_END: walker

// ANCHOR: numbers
/// Seven numbers: eye, forward, focal length. Read again, they are the same walker to the
/// last bit.
impl fmt::Display for Walker {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        let [eye, forward] = [self.eye, self.forward].map(|v| v.to_array());
        for number in eye.iter().chain(&forward) {
            write!(f, "{number},")?;
        }
        write!(f, "{}", self.focal_length)
    }
}

impl FromStr for Walker {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let numbers: Result<Vec<f32>, _> = text
            .split(',')
            .map(|number| number.trim().parse())
            .collect();
        let walker = match numbers.as_deref() {
            Ok(&[x, y, z, right, up, ahead, focal_length]) => {
                let forward = Vec3::new(right, up, ahead);
                Self::new(Vec3::new(x, y, z), forward, focal_length)
            }
            _ => None,
        };
        walker.ok_or_else(|| {
            let [shortest, longest] = FOCAL_LENGTHS;
            format!(
                "'{text}' is no camera; write seven numbers, like {}: the eye, up to \
                 {WORLD} from 0, the direction, not straight up or down, and the focal \
                 length, {shortest} to {longest}",
                Self::START
            )
        })
    }
}
// ANCHOR_END: numbers

// ANCHOR: coarse
/// The most often that a frame's sides are halved.
pub const MOST_HALVINGS: u32 = 5;

/// The size of a frame that stands for a picture of `size`, its sides halved so often.
#[must_use]
pub fn halved(size: UVec2, halvings: u32) -> UVec2 {
    let block = 1 << halvings;
    UVec2::new(size.x.div_ceil(block), size.y.div_ceil(block))
}

/// The pixel of the halved frame that is shown in place of `pixel`.
#[must_use]
pub fn block_of(pixel: Pixel, halvings: u32) -> Pixel {
    Pixel {
        x: pixel.x >> halvings,
        y: pixel.y >> halvings,
        size: halved(pixel.size, halvings),
    }
}

/// How often to halve the next frame, where the last was halved so often and took so
/// long.
///
/// Twice the sides are four times the pixels. That it must fit five times leaves room, so
/// that it does not change with every frame.
#[must_use]
pub fn next_halvings(halvings: u32, took: Duration, target: Duration) -> u32 {
    if took > target && halvings < MOST_HALVINGS {
        halvings + 1
    } else if 5 * took < target && halvings > 0 {
        halvings - 1
    } else {
        halvings
    }
}
// ANCHOR_END: coarse

// ANCHOR: accumulate
/// For every pixel of a picture, row by row, the sum of its samples so far.
pub type Sums = Arc<[Mutex<Vec<Vec3>>]>;

/// No samples yet.
#[must_use]
pub fn no_sums(size: UVec2) -> Sums {
    let row = || Mutex::new(vec![Vec3::ZERO; size.x as usize]);
    (0..size.y).map(|_| row()).collect()
}

/// A picture that adds one `sample` more to every pixel's sum when it is painted, and
/// shows the mean of the `count` samples there then are.
///
/// Samples are added up in their order, and divided once: the last of n × n leaves the
/// very bits of chapter 9's mean.
#[must_use]
pub fn accumulating(sample: Picture, sums: Sums, count: u32) -> Picture {
    Picture::by_runs(move |first, run| {
        sample.paint(first, run);
        let mut row = sums[first.y as usize]
            .lock()
            .expect("nobody panics with it");
        let sums = &mut row[first.x as usize..];
        for (sum, place) in sums.iter_mut().zip(run) {
            *sum += *place;
            *place = *sum / count as f32;
        }
    })
}
// ANCHOR_END: accumulate
