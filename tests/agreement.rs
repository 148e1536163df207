//! The still life as chapters 3 to 5 paint it, against the oracle's: in f64, without a line in common.
//!
//! The two agree to one level of a screen in every pixel but a few, where a ray passes so near an edge
//! that f32 and f64 see it on different sides:
//!
//! * in the one row of pixels next to the horizon, whose rays meet the floor some 10⁴ squares away, where
//!   the rounding of an f32 direction moves them by a good part of a square;
//! * at the edge of a shadow, which `shadows::OFFSET` moves by a fraction of a pixel.

mod numbers_file;

use canvas::{Canvas, Stage};
use glam::{DVec2, DVec3, UVec2};
use numbers_file::{Numbers, percent};
use oracle::{Camera, Ray, Scene};

type Trace = fn(&Scene, &Ray) -> DVec3;

const SIZE: [u32; 2] = [800, 600];

/// The two pictures of one scene: a stage's first view, and what the oracle sees.
struct Comparison {
    ours: Canvas,
    scene: Scene,
    camera: Camera,
    trace: Trace,
}

impl Comparison {
    fn new(stage: &Stage, trace: Trace) -> Self {
        let view = &stage.views[0];
        let picture = (view.picture)(view.default_setting());
        Self {
            ours: Canvas::paint(&picture, UVec2::from_array(SIZE)),
            scene: oracle::still_life(),
            camera: oracle::still_life_camera(),
            trace,
        }
    }

    /// The oracle's levels at a point of the picture, not rounded.
    fn levels(&self, at: DVec2) -> [f64; 3] {
        let light = (self.trace)(&self.scene, &self.camera.ray(at, SIZE));
        light.to_array().map(oracle::level)
    }

    /// The centres of the pixels that are more than one level away from the oracle's.
    fn differing(&self) -> Vec<DVec2> {
        let ours = self.ours.levels.iter().map(|levels| levels.map(f64::from));
        let pairs = oracle::pixel_centres(SIZE).zip(ours);
        let differing = pairs.filter(|&(at, ours)| !agree(ours, self.levels(at)));
        differing.map(|(at, _)| at).collect()
    }

    /// Whether the oracle itself gives another answer a quarter of a pixel away.
    fn is_edge(&self, at: DVec2) -> bool {
        let here = self.levels(at);
        let around = |i| DVec2::new(f64::from(i % 9 - 4), f64::from(i / 9 - 4)) / 16.0;
        (0..81).any(|i| !agree(here, self.levels(at + around(i))))
    }
}

fn agree(ours: [f64; 3], theirs: [f64; 3]) -> bool {
    (0..3).all(|channel| (ours[channel] - theirs[channel]).abs() <= 1.0)
}

/// At most `share` of the pixels differ, and every one of them is at an edge.
fn assert_agreement(stage: &Stage, trace: Trace, share: f64) {
    let comparison = Comparison::new(stage, trace);
    let differing = comparison.differing();
    let pixels = comparison.ours.levels.len();
    let measured = percent(differing.len(), pixels);
    assert!(
        differing.len() as f64 <= share * pixels as f64,
        "{measured} of the pixels differ from the oracle's, the first at {}",
        differing[0]
    );
    let inside = differing.iter().find(|&&at| !comparison.is_edge(at));
    assert_eq!(inside, None, "differs from the oracle's, far from any edge");

    let mut numbers = Numbers::default();
    numbers.note("disagreement", measured);
    numbers.check(&format!("{}-agreement", stage.name));
}

mod plane_hit {
    /// All of them in the row next to the horizon.
    #[test]
    fn the_flat_still_life_agrees_with_the_oracle() {
        super::assert_agreement(&::plane_hit::STAGE, oracle::trace_flat, 1e-4);
    }
}

mod shadows {
    /// In the row next to the horizon, and at the edges of shadows.
    #[test]
    fn the_still_life_with_shadows_agrees_with_the_oracle() {
        super::assert_agreement(&::shadows::STAGE, oracle::trace_shadows, 3e-4);
    }
}

mod shading {
    /// In the same places.
    #[test]
    fn the_shaded_still_life_agrees_with_the_oracle() {
        super::assert_agreement(&::shading::STAGE, oracle::trace_shaded, 3e-4);
    }
}
