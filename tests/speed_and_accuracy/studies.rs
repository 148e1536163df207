//! The studies, measured again, and what they measure by.

use crate::check::{check_charts, check_rows};
use harness::Numbers;
use measure::Random;
use measure::bvh::{Bvh, anywhere, cloud};
use measure::subjects::PATTERNS;
use plane_hit::nearest;
use ray_casting::Ray;
use speed_and_accuracy::STUDIES;
use speed_and_accuracy::studies::growth::FEW;
use speed_and_accuracy::study::Clock;
use std::f64::consts::PI;

macro_rules! studies {
    ($($study:ident)*) => {
        $(#[test]
        fn $study() {
            let study = &speed_and_accuracy::studies::$study::STUDY;
            check_rows(study, (study.measure)(&Clock::STOPPED), |_| true);
            check_charts(study);
        })*

        #[test]
        fn no_study_is_left_out() {
            let tested = [$(stringify!($study)),*];
            assert_eq!(tested, STUDIES.map(|study| study.name));
        }
    };
}

studies!(sphere plane bounces refraction fresnel highlight recursion sampling acne growth packets threads);

/// The yardstick of growth is none if it finds anything else.
#[test]
fn the_tree_finds_what_trying_all_spheres_finds() {
    let mut random = Random::new(1);
    let mut hits = 0;
    for count in [1, 2, 3, 10, 100, 1000] {
        let objects = cloud(count);
        let bvh = Bvh::new(&objects);
        for _ in 0..1000 {
            let origin = 2.0 * anywhere(&mut random);
            let direction = (anywhere(&mut random) - origin).normalize();
            let ray = Ray { origin, direction };
            let found = bvh.nearest(&ray);
            assert_eq!(found, nearest(&objects, &ray), "{count} spheres, {ray:?}");
            hits += u32::from(found.is_some());
        }
    }
    assert!(hits > 500, "only {hits} hits");
}

/// π 23.7² for the disc, and for the ramp (x² + y²)/(2 · 64²) the mean 1/3. The exact mean of
/// 4096 lines of a pixel may be wrong by 10⁻⁵.
#[test]
fn the_patterns_means_add_up_to_their_areas() {
    for (name, area) in [("edge", PI * 23.7 * 23.7), ("ramp", 64.0 * 64.0 / 3.0)] {
        let pattern = PATTERNS.iter().find(|pattern| pattern.name == name);
        let means = pattern.expect("a pattern").means();
        let error = means.iter().sum::<f64>() - area;
        assert!(error.abs() <= 1e-5 * means.len() as f64, "{name}: {error}");
    }
}

#[test]
fn the_numbers_are_those_in_the_book() {
    let mut numbers = Numbers::default();
    numbers.note("pixels", format!("{} × {}", FEW.x, FEW.y));
    numbers.check("14-speed-and-accuracy-growth");
}
