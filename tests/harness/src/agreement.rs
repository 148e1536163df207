//! A chapter's picture of the still life against the oracle's, which is calculated in f64
//! and shares no code with it.
//!
//! The two agree to within one level in every pixel but a few, where a ray passes so near an
//! edge that f32 and f64 put it on different sides:
//!
//! * in the one row of pixels next to the horizon, whose rays hit the floor some thousand squares
//!   away, where the rounding of an f32 direction moves the hit by a good part of a square;
//! * at the edge of a shadow, which the shadow bias moves by a fraction of a pixel;
//! * in a mirror and in glass, which show those edges once more, and smaller.

use crate::{Numbers, percent};
use canvas::{Canvas, Pixel, Stage};
use glam::{DVec2, DVec3, UVec2};
use oracle::{Camera, Limit, Ray, Scene};
use rayon::prelude::*;

/// A limit far beyond that of the chapters, which is 64 bounces and a throughput of 1/2048:
/// rays that they do not trace count as a difference, too.
const DEEP: Limit = Limit {
    bounces: 200,
    min_throughput: 1e-6,
};

/// Compares a chapter's first view with the still life of plastic, traced by `trace`.
///
/// # Panics
/// If more than `fraction` of the pixels differ, or one that is not at an edge.
pub fn assert_plastic(stage: &Stage, trace: fn(&Scene, &Ray) -> DVec3, fraction: f64) {
    let comparison = Comparison::new(stage, crate::HERO, 1, oracle::still_life(), trace);
    assert_agreement([comparison], fraction, stage.name);
}

/// Compares a chapter's first view, of n × n samples per pixel, with a scene in which light
/// is reflected and refracted.
///
/// # Panics
/// If more than `fraction` of the pixels differ, or one that is not at an edge.
pub fn assert_deep(stage: &Stage, size: UVec2, n: u32, scene: Scene, fraction: f64) {
    let trace = |scene: &Scene, ray: &Ray| oracle::trace(scene, ray, DEEP);
    let comparison = Comparison::new(stage, size, n, scene, trace);
    assert_agreement([comparison], fraction, stage.name);
}

/// Compares pictures, of one sample per pixel, with the oracle's of these scenes, in which light is reflected and
/// refracted. In both, rays beyond the `limit` are black.
///
/// # Panics
/// If more than `fraction` of all pixels differ, or one that is not at an edge.
pub fn assert_scenes(
    name: &str,
    pictures: impl IntoIterator<Item = (Canvas, Scene, Camera)>,
    limit: Limit,
    fraction: f64,
) {
    let comparisons = pictures
        .into_iter()
        .map(|(ours, scene, camera)| Comparison {
            ours,
            n: 1,
            scene,
            camera,
            trace: move |scene: &Scene, ray: &Ray| oracle::trace(scene, ray, limit),
        });
    assert_agreement(comparisons, fraction, name);
}

/// Two pictures of one scene: ours, and the oracle's.
struct Comparison<T> {
    ours: Canvas,
    /// A pixel is the mean of n × n samples.
    n: u32,
    scene: Scene,
    camera: Camera,
    trace: T,
}

impl<T: Fn(&Scene, &Ray) -> DVec3 + Sync> Comparison<T> {
    fn new(stage: &Stage, size: UVec2, n: u32, scene: Scene, trace: T) -> Self {
        Self {
            ours: crate::render(stage, stage.hero, size),
            n,
            scene,
            camera: oracle::still_life_camera(),
            trace,
        }
    }

    /// Returns the oracle's least and greatest levels of a pixel, not rounded, if each of its
    /// samples may be moved by any one of these fractions of its cell's side.
    fn levels(&self, pixel: Pixel, moved: &[DVec2]) -> [[f64; 3]; 2] {
        let corner = DVec2::new(f64::from(pixel.x), f64::from(pixel.y));
        let cells = self.n * self.n;
        let mut sums = [DVec3::ZERO; 2];
        for i in 0..cells {
            let cell = DVec2::new(f64::from(i % self.n), f64::from(i / self.n));
            let samples = moved.iter().map(|moved| {
                let within = (cell + 0.5 + moved) / f64::from(self.n);
                let ray = self.camera.ray(corner + within, pixel.size.to_array());
                (self.trace)(&self.scene, &ray)
            });
            let range = [DVec3::INFINITY, DVec3::NEG_INFINITY];
            let [least, most] = samples.fold(range, |[least, most], radiance| {
                [least.min(radiance), most.max(radiance)]
            });
            sums = [sums[0] + least, sums[1] + most];
        }
        sums.map(|sum| (sum / f64::from(cells)).to_array().map(oracle::level))
    }

    /// Returns the pixels that are more than one level away from the oracle's, and our levels.
    fn differing(&self) -> Vec<([f64; 3], Pixel)> {
        let ours = self.ours.levels.par_iter().map(|ours| ours.map(f64::from));
        let pixels: Vec<Pixel> = Pixel::all(self.ours.size).collect();
        let differing = ours.zip(pixels).filter(|&(ours, pixel)| {
            !is_between(ours, self.levels(pixel, &[DVec2::ZERO]))
        });
        differing.collect()
    }

    /// Returns whether our levels are among the oracle's for samples at most a quarter of a
    /// cell away: at an edge, those are on both of its sides.
    fn is_at_an_edge(&self, ours: [f64; 3], pixel: Pixel) -> bool {
        let step = |i| (f64::from(i) - 10.0) / 40.0;
        let moved = (0..441).map(|i| DVec2::new(step(i % 21), step(i / 21)));
        is_between(ours, self.levels(pixel, &moved.collect::<Vec<_>>()))
    }
}

fn assert_agreement<T: Fn(&Scene, &Ray) -> DVec3 + Sync>(
    comparisons: impl IntoIterator<Item = Comparison<T>>,
    fraction: f64,
    name: &str,
) {
    let (mut differ, mut pixels, mut elsewhere) = (0, 0, Vec::new());
    for (scene, comparison) in comparisons.into_iter().enumerate() {
        let differing = comparison.differing();
        differ += differing.len();
        pixels += comparison.ours.levels.len();
        let apart = differing
            .par_iter()
            .find_any(|(ours, pixel)| !comparison.is_at_an_edge(*ours, *pixel));
        elsewhere.extend(apart.map(|&apart| (scene, apart)));
    }
    let measured = percent(differ, pixels);
    assert!(
        differ as f64 <= fraction * pixels as f64,
        "{measured} of the pixels differ from the oracle's"
    );
    assert_eq!(elsewhere, [], "differ from the oracle's, far from any edge");

    let mut numbers = Numbers::default();
    numbers.note("disagreement", measured);
    numbers.check(&format!("{name}-agreement"));
}

/// Returns whether our levels are between the oracle's least and greatest, or at most one
/// level off.
fn is_between(ours: [f64; 3], [least, most]: [[f64; 3]; 2]) -> bool {
    (0..3).all(|i| (least[i] - 1.0..=most[i] + 1.0).contains(&ours[i]))
}
