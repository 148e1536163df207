//! What is sampled: pictures whose every pixel's mean is known.

use crate::pictures::sight;
use anti_aliasing::jittered;
use canvas::{Canvas, Picture, Pixel};
use glam::{DVec3, UVec2, Vec2, Vec3};
use plane_hit::is_even;
use rayon::prelude::*;
use reflection::{MAX_DEPTH, Reach};
use std::sync::Arc;

/// From a pixel, n, and what is seen at a point of the image plane, to the mean of some
/// n × n samples.
pub type Sampler = fn(Pixel, u32, &dyn Fn(Vec2) -> Vec3) -> Vec3;

/// What is seen at every point of the image plane, and on average in every pixel.
pub struct Subject {
    /// Its name.
    pub name: &'static str,
    /// Of the picture, in pixels.
    pub size: UVec2,
    /// Linear light; it counts its rays.
    pub light: Arc<dyn Fn(Vec2) -> Vec3 + Send + Sync>,
    /// Every pixel's mean, row by row from the top.
    pub means: Vec<DVec3>,
    /// The largest n whose n × n samples these means are good enough for.
    pub finest: u32,
}

impl Subject {
    /// A pattern's picture.
    #[must_use]
    pub fn of(pattern: &Pattern) -> Self {
        let light = pattern.light;
        Self {
            name: pattern.name,
            size: UVec2::splat(SIDE as u32),
            light: Arc::new(move |point| {
                canvas::count_ray();
                Vec3::splat(light((point + Vec2::ONE) * SIDE / 2.0))
            }),
            means: pattern.means().into_iter().map(DVec3::splat).collect(),
            finest: 32,
        }
    }

    /// The still life, its means those of 64 × 64 jittered samples.
    #[must_use]
    pub fn still_life() -> Self {
        let (model, camera) = sight("still-life");
        let reach = Reach::new(MAX_DEPTH);
        let mut subject = Self {
            name: "still life",
            size: UVec2::new(32, 24),
            light: Arc::new(move |point| model.trace(camera.ray(point), reach)),
            means: Vec::new(),
            finest: 16,
        };
        let many = subject.paint(jittered, 64);
        subject.means = many.light.iter().map(|light| light.as_dvec3()).collect();
        subject
    }

    /// The picture by n × n samples for a pixel.
    #[must_use]
    pub fn paint(&self, sampler: Sampler, n: u32) -> Canvas {
        let light = self.light.clone();
        let picture = Picture::new(move |pixel| sampler(pixel, n, &*light));
        Canvas::paint(&picture, self.size)
    }
}

/// A pattern in a picture of [`SIDE`] by [`SIDE`] pixels: what is seen at a point, in
/// pixels to the right of its lower left corner and above that.
pub struct Pattern {
    /// Its name.
    pub name: &'static str,
    /// The light at a point, from 0 to 1.
    pub light: fn(Vec2) -> f32,
    /// The exact mean along the line from (x, y) to (x + 1, y).
    mean: fn(f64, f64) -> f64,
}

/// A disc's edge, a chequered floor as far as its horizon, dots, and a smooth ramp.
pub const PATTERNS: [Pattern; 4] = [
    Pattern {
        name: "edge",
        light: |p| one_if(p.distance(CENTRE) < RADIUS),
        mean: |x, y| chord(RADIUS, x - f64::from(CENTRE.x), y - f64::from(CENTRE.y)),
    },
    Pattern {
        name: "horizon",
        light: |p| one_if(is_even(HEIGHT * Vec2::new(p.x, SIDE) / (SIDE - p.y))),
        mean: floor,
    },
    Pattern {
        name: "dots",
        light: |p| one_if(p.distance(APART * (p / APART).round()) < DOT),
        mean: dots,
    },
    Pattern {
        name: "ramp",
        light: |p| p.length_squared() / (2.0 * SIDE * SIDE),
        mean: |x, y| (x * x + x + 1.0 / 3.0 + y * y) / (2.0 * f64::from(SIDE * SIDE)),
    },
];

/// The width and height of the patterns' pictures, in pixels. The floor's horizon is their
/// upper border, and the eye is as far from the image plane as that is wide.
pub const SIDE: f32 = 64.0;
/// The eye's height above the floor, in squares.
const HEIGHT: f32 = 4.0;
/// The disc.
const CENTRE: Vec2 = Vec2::new(31.4, 32.3);
const RADIUS: f32 = 23.7;
/// The dots' radius and distance: chapter 9's.
const DOT: f32 = 0.25;
const APART: f32 = 8.3;

fn one_if(is_light: bool) -> f32 {
    f32::from(u8::from(is_light))
}

/// How much of a row from x to x + 1 is within a disc about the origin.
fn chord(radius: f32, x: f64, y: f64) -> f64 {
    let radius = f64::from(radius);
    let half = (radius * radius - y * y).max(0.0).sqrt();
    (x + 1.0).clamp(-half, half) - x.clamp(-half, half)
}

/// A pixel never holds parts of more than two dots of a row.
fn dots(x: f64, y: f64) -> f64 {
    let nearest = |x: f64| f64::from(APART) * (x / f64::from(APART)).round();
    let covered = |dot: f64| chord(DOT, x - dot, y - nearest(y));
    let (left, right) = (nearest(x), nearest(x + 1.0));
    covered(left) + if right > left { covered(right) } else { 0.0 }
}

fn floor(x: f64, y: f64) -> f64 {
    let per_pixel = f64::from(HEIGHT) / (f64::from(SIDE) - y);
    // How much of the way from 0 to u is in even squares.
    let even = |u: f64| (u / 2.0).floor() + (u % 2.0).min(1.0);
    let share = (even((x + 1.0) * per_pixel) - even(x * per_pixel)) / per_pixel;
    let is_even = (f64::from(SIDE) * per_pixel).floor() % 2.0 == 0.0;
    if is_even { share } else { 1.0 - share }
}

/// A pixel's mean is that of so many lines.
const LINES: u32 = 4096;

impl Pattern {
    /// Every pixel's mean light, row by row from the top: within 15 pixels of the horizon
    /// to some 10⁻⁴, elsewhere to 10⁻⁵.
    #[must_use]
    pub fn means(&self) -> Vec<f64> {
        let side = SIDE as u32;
        let mean = |i| {
            let (x, y) = (f64::from(i % side), f64::from(side - 1 - i / side));
            let lines = (0..LINES).map(|line| (f64::from(line) + 0.5) / f64::from(LINES));
            let sum: f64 = lines.map(|line| (self.mean)(x, y + line)).sum();
            sum / f64::from(LINES)
        };
        (0..side * side).into_par_iter().map(mean).collect()
    }
}
