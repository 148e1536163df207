//! Pictures to be sampled, for which every pixel's mean is known.

use crate::scenes::plain_scene;
use anti_aliasing::{Sampler, jittered};
use canvas::{Canvas, Picture, Pixel};
use glam::{DVec3, UVec2, Vec2, Vec3};
use plane_hit::is_even;
use ray_casting::Camera;
use rayon::prelude::*;
use reflection::{MAX_DEPTH, PathBudget};
use refraction::Material;
use shadow_acne::{from_eye, from_surface, trace};
use shadows::Scene;
use std::cell::RefCell;
use std::sync::Arc;

/// A picture of the radiance at every point of the image plane, and its mean in every pixel.
pub struct Subject {
    /// Its name.
    pub name: &'static str,
    /// Its width and height, in pixels.
    pub size: UVec2,
    /// The radiance at a point of the image plane; counts its rays.
    pub radiance: Arc<dyn Fn(Vec2) -> Vec3 + Send + Sync>,
    /// The mean in every pixel, row by row from the top.
    pub means: Vec<DVec3>,
    /// The largest n whose n × n samples these means are exact enough for.
    pub finest: u32,
}

/// Returns the pictures of the [`PATTERNS`], and the still life.
#[must_use]
pub fn subjects() -> Vec<Subject> {
    let patterns = PATTERNS.iter().map(Subject::of);
    patterns.chain([Subject::still_life()]).collect()
}

impl Subject {
    fn of(pattern: &Pattern) -> Self {
        let light = pattern.light;
        Self {
            name: pattern.name,
            size: UVec2::splat(SIDE as u32),
            radiance: Arc::new(move |point| {
                canvas::count_ray();
                Vec3::splat(light((point + Vec2::ONE) * SIDE / 2.0))
            }),
            means: pattern.means().into_iter().map(DVec3::splat).collect(),
            finest: 32,
        }
    }

    /// Returns the still life; its means are those of 64 × 64 jittered samples.
    fn still_life() -> Self {
        let (scene, camera) = plain_scene("still-life");
        let budget = PathBudget::new(MAX_DEPTH);
        let start = from_eye(&scene.objects, camera.eye);
        let mut subject = Self {
            name: "still life",
            size: UVec2::new(32, 24),
            radiance: Arc::new(move |point| {
                trace(&scene, &start(camera.ray(point)), budget, from_surface)
            }),
            means: Vec::new(),
            finest: 16,
        };
        let means = subject.render(jittered, 64).radiance;
        subject.means = means.into_iter().map(Vec3::as_dvec3).collect();
        subject
    }

    /// Returns the picture by n × n samples per pixel.
    #[must_use]
    pub fn render(&self, sampler: Sampler, n: u32) -> Canvas {
        let radiance = self.radiance.clone();
        let picture = Picture::new(move |pixel| sampler(pixel, n, &*radiance));
        Canvas::render(&picture, self.size)
    }
}

/// Returns the mean of n × n jittered samples if of 2 × 2 two differ by more than 0.05 of linear
/// light in any channel, and otherwise that of these: the usual threshold, which is blind in the
/// dark, where 0.05 is 63 levels.
#[must_use]
pub fn adaptive_linear(pixel: Pixel, n: u32, radiance: &dyn Fn(Vec2) -> Vec3) -> Vec3 {
    let samples = RefCell::new(Vec::new());
    let mean = jittered(pixel, 2, &|point| {
        let sample = radiance(point);
        samples.borrow_mut().push(sample);
        sample
    });
    let samples = samples.into_inner();
    let differ = |a: &Vec3| samples.iter().any(|b| (*a - *b).abs().max_element() > 0.05);
    if samples.iter().any(differ) {
        jittered(pixel, n, radiance)
    } else {
        mean
    }
}

/// Returns the picture of a scene by 16 × 16 samples per pixel, traced in packets and added up
/// in f64, so that pixels of a single radiance keep that to the last bit.
#[must_use]
pub fn finely_sampled(
    scene: Scene<Material>,
    camera: Camera,
    budget: PathBudget,
) -> Picture {
    const N: u32 = 16;
    Picture::from_spans(move |first, span| {
        let mut sums = vec![DVec3::ZERO; span.len()];
        for i in 0..N * N {
            packets::render_sample(&scene, &camera, budget, [N, i], first, span);
            for (sum, radiance) in sums.iter_mut().zip(&*span) {
                *sum += radiance.as_dvec3();
            }
        }
        for (out, sum) in span.iter_mut().zip(sums) {
            *out = (sum / f64::from(N * N)).as_vec3();
        }
    })
}

/// A pattern in a picture of [`SIDE`] by [`SIDE`] pixels, as a function of a point: in pixels to
/// the right of its lower left corner and above that.
pub struct Pattern {
    /// Its name.
    pub name: &'static str,
    /// The light at a point, from 0 to 1.
    light: fn(Vec2) -> f32,
    /// The exact mean along the line from (x, y) to (x + 1, y).
    mean: fn(f64, f64) -> f64,
}

/// The edge of a disc of radius 23.7, a checkered floor as far as its horizon, and a smooth
/// ramp.
pub const PATTERNS: [Pattern; 3] = [
    Pattern {
        name: "edge",
        light: |p| one_if(p.distance(CENTRE) < RADIUS),
        mean: |x, y| chord(x - f64::from(CENTRE.x), y - f64::from(CENTRE.y)),
    },
    Pattern {
        name: "horizon",
        light: |p| one_if(is_even(HEIGHT * Vec2::new(p.x, SIDE) / (SIDE - p.y))),
        mean: floor,
    },
    Pattern {
        name: "ramp",
        light: |p| p.length_squared() / (2.0 * SIDE * SIDE),
        mean: |x, y| (x * x + x + 1.0 / 3.0 + y * y) / (2.0 * f64::from(SIDE * SIDE)),
    },
];

/// The width and height of the patterns' pictures, in pixels. The floor's horizon is their
/// upper edge, and the eye is as far from the image plane as that is wide.
pub const SIDE: f32 = 64.0;
/// The eye's height above the floor, in squares.
const HEIGHT: f32 = 4.0;
/// The disc.
const CENTRE: Vec2 = Vec2::new(31.4, 32.3);
const RADIUS: f32 = 23.7;

fn one_if(is_light: bool) -> f32 {
    f32::from(u8::from(is_light))
}

/// Returns the length of the part of a row from x to x + 1 that is within the disc.
fn chord(x: f64, y: f64) -> f64 {
    let radius = f64::from(RADIUS);
    let half = (radius * radius - y * y).max(0.0).sqrt();
    (x + 1.0).clamp(-half, half) - x.clamp(-half, half)
}

fn floor(x: f64, y: f64) -> f64 {
    let per_pixel = f64::from(HEIGHT) / (f64::from(SIDE) - y);
    // The length of the part from 0 to u that is in even squares.
    let even = |u: f64| (u / 2.0).floor() + (u % 2.0).min(1.0);
    let part = (even((x + 1.0) * per_pixel) - even(x * per_pixel)) / per_pixel;
    let is_even = (f64::from(SIDE) * per_pixel).floor() % 2.0 == 0.0;
    if is_even { part } else { 1.0 - part }
}

/// The number of lines whose mean is a pixel's.
const LINES: u32 = 4096;

impl Pattern {
    /// Returns the mean light of every pixel, row by row from the top: within 15 pixels of the
    /// horizon to some 10⁻⁴, elsewhere to 10⁻⁵.
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
