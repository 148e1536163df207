//! The still life as chapters 3 to 11 paint it, against the oracle's: in f64, without a line in common.
//!
//! The two agree to one level of a screen in every pixel but a few, where a ray passes so near an edge
//! that f32 and f64 see it on different sides:
//!
//! * in the one row of pixels next to the horizon, whose rays meet the floor some 10⁴ squares away, where
//!   the rounding of an f32 direction moves them by a good part of a square;
//! * at the edge of a shadow, which `shadows::OFFSET` moves by a fraction of a pixel;
//! * in a mirror and in glass, which show those edges once more, and smaller.

mod numbers_file;

use canvas::{Canvas, Stage};
use glam::{DVec2, DVec3, UVec2};
use numbers_file::{Numbers, percent};
use oracle::{Camera, Glass, Limit, Ray, Scene};
use rayon::prelude::*;

const SIZE: [u32; 2] = [800, 600];

/// Much farther than the chapters follow a ray, which is for 64 bounces and down to a share of 1/2048: so
/// that what they leave out counts as a difference, too.
const DEEP: Limit = Limit {
    bounces: 200,
    share: 1e-6,
};

/// The two pictures of one scene: a stage's first view, and what the oracle sees.
struct Comparison<T> {
    ours: Canvas,
    /// A pixel is the mean of n × n samples.
    n: u32,
    scene: Scene,
    camera: Camera,
    trace: T,
}

impl<T: Fn(&Scene, &Ray) -> DVec3 + Sync> Comparison<T> {
    fn new(stage: &Stage, size: [u32; 2], n: u32, scene: Scene, trace: T) -> Self {
        let view = &stage.views[0];
        let picture = (view.picture)(view.default_setting());
        Self {
            ours: Canvas::paint(&picture, UVec2::from_array(size)),
            n,
            scene,
            camera: oracle::still_life_camera(),
            trace,
        }
    }

    /// The least and the most that the oracle sees of a pixel, in levels, not rounded, if each of its
    /// samples may be moved by any one of these parts of its cell's side.
    fn levels(&self, centre: DVec2, moved: &[DVec2]) -> [[f64; 3]; 2] {
        let size = self.ours.size.to_array();
        let cells = self.n * self.n;
        let mut sums = [DVec3::ZERO; 2];
        for i in 0..cells {
            let cell = DVec2::new(f64::from(i % self.n), f64::from(i / self.n));
            let lights = moved.iter().map(|moved| {
                let within = (cell + 0.5 + moved) / f64::from(self.n);
                let ray = self.camera.ray(centre - 0.5 + within, size);
                (self.trace)(&self.scene, &ray)
            });
            let range = [DVec3::INFINITY, DVec3::NEG_INFINITY];
            let [least, most] = lights.fold(range, |[least, most], light| {
                [least.min(light), most.max(light)]
            });
            sums = [sums[0] + least, sums[1] + most];
        }
        sums.map(|sum| (sum / f64::from(cells)).to_array().map(oracle::level))
    }

    /// The pixels that are more than one level away from the oracle's: our levels, and where.
    fn differing(&self) -> Vec<([f64; 3], DVec2)> {
        let ours = self.ours.levels.par_iter().map(|ours| ours.map(f64::from));
        let centres: Vec<DVec2> =
            oracle::pixel_centres(self.ours.size.to_array()).collect();
        let differing = ours
            .zip(centres)
            .filter(|&(ours, at)| !is_between(ours, self.levels(at, &[DVec2::ZERO])));
        differing.collect()
    }

    /// Whether the oracle's answers at most a quarter of a cell away leave room for ours: where an edge
    /// passes, there is its other side among them.
    fn is_at_an_edge(&self, ours: [f64; 3], at: DVec2) -> bool {
        let step = |i| (f64::from(i) - 10.0) / 40.0;
        let moved = (0..441).map(|i| DVec2::new(step(i % 21), step(i / 21)));
        is_between(ours, self.levels(at, &moved.collect::<Vec<_>>()))
    }

    /// At most `share` of the pixels differ, and every one of them is at an edge.
    fn assert_agreement(&self, stage: &Stage, share: f64) {
        let differing = self.differing();
        let pixels = self.ours.levels.len();
        let measured = percent(differing.len(), pixels);
        assert!(
            differing.len() as f64 <= share * pixels as f64,
            "{measured} of the pixels differ from the oracle's"
        );
        let elsewhere = differing
            .par_iter()
            .find_any(|(ours, at)| !self.is_at_an_edge(*ours, *at));
        assert_eq!(
            elsewhere, None,
            "differs from the oracle's, far from any edge"
        );

        let mut numbers = Numbers::default();
        numbers.note("disagreement", measured);
        numbers.check(&format!("{}-agreement", stage.name));
    }
}

/// Whether our levels are between the least and the most of the oracle's, or at most one off.
fn is_between(ours: [f64; 3], [least, most]: [[f64; 3]; 2]) -> bool {
    (0..3).all(|i| (least[i] - 1.0..=most[i] + 1.0).contains(&ours[i]))
}

/// Chapters 3 to 5: the still life of plastic.
fn assert_plastic(stage: &Stage, trace: fn(&Scene, &Ray) -> DVec3, share: f64) {
    let comparison = Comparison::new(stage, SIZE, 1, oracle::still_life(), trace);
    comparison.assert_agreement(stage, share);
}

/// Chapters 6 to 11: rays that go on.
fn assert_deep(stage: &Stage, size: [u32; 2], n: u32, scene: Scene, share: f64) {
    let trace = |scene: &Scene, ray: &Ray| oracle::trace(scene, ray, DEEP);
    Comparison::new(stage, size, n, scene, trace).assert_agreement(stage, share);
}

mod plane_hit {
    /// All of them in the row next to the horizon. Measured: 0.00729 %.
    #[test]
    fn the_flat_still_life_agrees_with_the_oracle() {
        super::assert_plastic(&::plane_hit::STAGE, oracle::trace_flat, 1e-4);
    }
}

mod shadows {
    /// In the row next to the horizon, and at the edges of shadows. Measured: 0.00958 %.
    #[test]
    fn the_still_life_with_shadows_agrees_with_the_oracle() {
        super::assert_plastic(&::shadows::STAGE, oracle::trace_shadows, 2e-4);
    }
}

mod shading {
    /// In the same places. Measured: 0.00937 %.
    #[test]
    fn the_shaded_still_life_agrees_with_the_oracle() {
        super::assert_plastic(&::shading::STAGE, oracle::trace_shaded, 2e-4);
    }
}

mod reflection {
    use super::*;

    /// In the same places, and in their images in the mirror. Measured: 0.0154 %.
    #[test]
    fn the_still_life_with_its_mirror_agrees_with_the_oracle() {
        let scene = oracle::still_life_with_mirrors();
        assert_deep(&::reflection::STAGE, SIZE, 1, scene, 3e-4);
    }
}

mod refraction {
    use super::*;

    /// And in the glass, where all the world is small. Measured: 0.0385 %.
    #[test]
    fn the_still_life_with_bending_glass_agrees_with_the_oracle() {
        let scene = oracle::still_life_with_glass(Glass::Bends);
        assert_deep(&::refraction::STAGE, SIZE, 1, scene, 6e-4);
    }
}

mod fresnel {
    use super::*;

    /// And in all that goes to and fro in the glass: at its rim, where a ray runs around just under the
    /// surface, the offset counts at every bounce. Measured: 0.0773 %.
    #[test]
    fn the_complete_still_life_agrees_with_the_oracle() {
        let scene = oracle::still_life_with_glass(Glass::Mirrors);
        assert_deep(&::fresnel::STAGE, SIZE, 1, scene, 1e-3);
    }
}

mod anti_aliasing {
    use super::*;

    /// The mean of sixteen samples, each of which may be at an edge: in a smaller picture, of which the
    /// horizon's row is a larger part. Measured: 0.367 %.
    #[test]
    fn the_smoothed_still_life_agrees_with_the_oracle() {
        let scene = oracle::still_life_with_glass(Glass::Mirrors);
        assert_deep(&::anti_aliasing::STAGE, [320, 240], 4, scene, 5e-3);
    }
}

mod shadow_acne {
    use super::*;

    /// Without an offset a fifth of that is left, half of it in the row next to the horizon. Measured:
    /// 0.015 %.
    #[test]
    fn the_still_life_without_offsets_agrees_with_the_oracle() {
        let scene = oracle::still_life_with_glass(Glass::Mirrors);
        assert_deep(&::shadow_acne::STAGE, SIZE, 1, scene, 2e-4);
    }
}

mod transparency {
    use super::*;

    /// As without colours. Measured: 0.0135 %.
    #[test]
    fn the_still_life_with_amber_glass_agrees_with_the_oracle() {
        let amber = DVec3::new(0.1, 0.7, 2.5);
        let scene = oracle::still_life_with_glass(Glass::Tints(amber));
        assert_deep(&::transparency::STAGE, SIZE, 1, scene, 2e-4);
    }
}

/// The oracle against itself.
mod oracle_itself {
    use super::*;
    use speed_and_accuracy::scenes::{exact_camera, find};

    const SMALL: [u32; 2] = [48, 36];

    fn picture(scene: &Scene, camera: &Camera, limit: Limit, n: u32) -> Vec<DVec3> {
        let corners: Vec<DVec2> =
            oracle::pixel_centres(SMALL).map(|at| at - 0.5).collect();
        let pixel = |corner: &DVec2| {
            let samples = oracle::pixel_centres([n, n]).map(|at| {
                let ray = camera.ray(*corner + at / f64::from(n), SMALL);
                oracle::trace(scene, &ray, limit)
            });
            samples.sum::<DVec3>() / f64::from(n * n)
        };
        corners.par_iter().map(pixel).collect()
    }

    fn largest_difference(a: &[DVec3], b: &[DVec3]) -> f64 {
        let differences = a.iter().zip(b).map(|(a, b)| (*a - *b).abs().max_element());
        differences.fold(0.0, f64::max)
    }

    /// Between mirrors of 0.9 what is beyond depth D is a share of 0.9ᴰ of the rest: the picture converges,
    /// and drifts nowhere.
    #[test]
    #[expect(clippy::disallowed_methods, reason = "the bound")]
    fn facing_mirrors_converge_to_depth_100_and_beyond() {
        let (model, camera) = (find("facing-mirrors").expect("a scene").make)();
        let (scene, camera) = (model.exactly(), exact_camera(&camera));
        let at_depth = |bounces| {
            let limit = Limit {
                bounces,
                share: 0.0,
            };
            picture(&scene, &camera, limit, 1)
        };
        let deepest = at_depth(800);
        for bounces in [25, 50, 100, 200, 400] {
            let difference = largest_difference(&at_depth(bounces), &deepest);
            let bound = 0.9_f64.powi(bounces as i32);
            assert!(difference <= bound + 1e-15, "{bounces}: {difference}");
            assert!(
                difference >= 1e-3 * bound || difference < 1e-15,
                "{bounces}"
            );
        }
    }

    /// Four times the samples of an edge leave some third of the error: N^(−3/4) is 0.35.
    #[test]
    fn the_still_life_converges_with_the_samples() {
        let scene = oracle::still_life_with_glass(Glass::Mirrors);
        let camera = oracle::still_life_camera();
        let [two, four, eight, sixteen] =
            [2, 4, 8, 16].map(|n| picture(&scene, &camera, DEEP, n));
        let rms = |a: &[DVec3], b: &[DVec3]| {
            let squares = a.iter().zip(b).map(|(a, b)| a.distance_squared(*b));
            (squares.sum::<f64>() / a.len() as f64).sqrt()
        };
        let steps = [rms(&two, &four), rms(&four, &eight), rms(&eight, &sixteen)];
        for pair in steps.windows(2) {
            let ratio = pair[1] / pair[0];
            assert!((0.2..0.6).contains(&ratio), "{steps:?}");
        }
    }
}
