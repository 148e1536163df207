//! The still life against POV-Ray's.

use harness::HERO;
use harness::povray::assert_radiance;
use oracle::{
    Glass, Limit, pixel_centres, still_life_camera, still_life_with_glass, trace,
};
use rayon::prelude::*;

/// Two renderers in f64 differ by the last bit of a 16-bit file, but at the horizon, where
/// POV-Ray takes the floor to end.
#[test]
fn the_still_life_is_the_one_that_povray_renders() {
    let camera = still_life_camera();
    let scene = still_life_with_glass(Glass::Reflects);
    let size = HERO.to_array();
    assert_radiance("oracle", [0.002, 5e-5], |bounces| {
        let limit = Limit {
            bounces,
            min_throughput: 0.0,
        };
        let centres: Vec<_> = pixel_centres(size).collect();
        let radiance = |&centre| trace(&scene, &camera.ray(centre, size), limit);
        centres.par_iter().map(radiance).collect()
    });
}
