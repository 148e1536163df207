//! The oracle's pictures against POV-Ray's.

use harness::povray::{assert_radiance, assert_water};
use harness::{HERO, SMALL};
use oracle::{
    Glass, Limit, pixel_centres, still_life_camera, still_life_with_glass, trace, water,
    water_camera,
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

/// The two differ by the last bit of a 16-bit file, but at a few edges. If the first of the
/// bodies at a place were its medium, the mean would be 6.3 levels; if the index outside were always that of
/// air, 1.7.
#[test]
fn glass_in_the_water_is_as_povray_renders_it() {
    let (camera, scene) = (water_camera(), water());
    let size = SMALL.to_array();
    let limit = Limit {
        bounces: 100,
        min_throughput: 1e-6,
    };
    let centres: Vec<_> = pixel_centres(size).collect();
    let radiance = |&centre| trace(&scene, &camera.ray(centre, size), limit);
    let ours: Vec<_> = centres.par_iter().map(radiance).collect();
    assert_water("oracle", [0.0015, 1.5e-4], &ours);
}
