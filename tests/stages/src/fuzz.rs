//! One random scene, traced in every way there is.

use crate::tracers::{BRANCHED, FIRST_HIT, OFFSET, PLANNED, Tracer, UNBRANCHED};
use canvas::Canvas;
use glam::UVec2;
use measure::random_scenes::extreme;
use reflection::{MAX_DEPTH, MIN_THROUGHPUT, PathBudget};

const SIZE: UVec2 = UVec2::new(3, 2);

/// The most rays of a plan's sample, shadow rays aside, as the plan has it.
const MAX_PLANNED: u64 = 1 << 10;

/// Renders the extreme scene with this seed in every way there is; of those that offset a
/// ray's start one, in turns.
///
/// No ray branches before the chapters about Fresnel's formulas: there a pixel takes a camera
/// ray and [`MAX_DEPTH`] more at most. Where rays branch, the throughputs of one pixel's rays at
/// any depth add up to 1 at most, and each is more than [`MIN_THROUGHPUT`]: there are fewer than
/// its inverse. From every hit there is one more ray to each light. Where bodies displace each
/// other, a ray may meet every surface twice and go straight on, and counts once more each time.
///
/// # Panics
/// If any pixel is not finite, or takes more rays.
pub fn check(seed: u32) {
    let (scene, camera) = extreme(seed);
    let at_a_hit = 1 + scene.lights.len() as u64;
    let straight_on = 2 * scene.objects.len() as u64;
    let check = |(name, tracer): (&str, Tracer), most: u64| {
        let picture = tracer(&scene, camera, PathBudget::new(MAX_DEPTH));
        let canvas = Canvas::render(&picture, SIZE);
        let is_finite = canvas.radiance.iter().all(|radiance| radiance.is_finite());
        assert!(is_finite, "{name}, scene {seed}: {:?}", canvas.radiance);
        let most = most * u64::from(SIZE.element_product());
        assert!(
            canvas.rays <= most,
            "{name}, scene {seed}: {} rays",
            canvas.rays
        );
    };
    let depth = u64::from(MAX_DEPTH);
    let widest = (1.0 / MIN_THROUGHPUT) as u64;
    for tracer in FIRST_HIT {
        check(tracer, at_a_hit);
    }
    for tracer in UNBRANCHED {
        check(tracer, (1 + depth) * at_a_hit);
    }
    let branched = 1 + depth * widest;
    for tracer in BRANCHED {
        check(tracer, branched * (at_a_hit + straight_on));
    }
    check(OFFSET[seed as usize % OFFSET.len()], branched * at_a_hit);
    check(PLANNED, MAX_PLANNED * (at_a_hit + straight_on));
}
