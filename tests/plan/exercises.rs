//! The exercises' checks. Yours are judged by name:
//! `cargo test --test plan exercise_3 -- --ignored`.

use crate::solutions;
use ::plan::{Plan, exercises};
use ::reflection::scene::facing_mirrors;
use ::refraction::scene::opaque;
use canvas::decode;
use harness::{Numbers, judge, percent};

fn check_3(bounces: fn(f32, f32) -> u32) {
    for (reflectivity, least, right) in [
        (0.5, 0.5, 1),
        (0.5, 0.4, 2),
        (0.5, 1.0 / 1024.0, 10),
        (0.1, 0.05, 2),
        (0.0, 0.1, 1),
        (0.9, 2.0, 0),
    ] {
        let yours = bounces(reflectivity, least);
        assert_eq!(yours, right, "mirrors of {reflectivity}, down to {least}");
    }
    // 0.99⁶⁸ is 0.5049, and the next one 0.4998.
    assert_eq!(bounces(0.99, 0.5), 69, "mirrors of 0.99, down to 0.5");
}

fn check_4(probability: fn(f32, u32) -> f32) {
    let near = |yours: f32, right: f32, what: &str| {
        assert!(
            (yours - right).abs() < 1e-4,
            "{what}: yours is {yours}, right is {right}"
        );
    };
    near(probability(0.1, 0), 1.0, "no sample");
    near(probability(0.0, 8), 1.0, "no dot");
    near(probability(0.1, 1), 0.968_584, "one sample, a dot of 0.1");
    near(probability(0.5, 1), 0.214_602, "one sample, a dot of 0.5");
    near(probability(0.1, 8), 0.774_65, "eight samples, a dot of 0.1");
    near(
        probability(0.25, 4),
        0.417_12,
        "four samples, a dot of 0.25",
    );
}

#[test]
#[ignore = "an exercise for you"]
fn exercise_3() {
    check_3(exercises::bounces_allowed);
}

#[test]
#[ignore = "an exercise for you"]
fn exercise_4() {
    check_4(exercises::probability_of_a_miss);
}

#[test]
fn the_exercises_are_judged_rightly() {
    let source = include_str!("../../chapters/15-plan/src/exercises.rs");
    judge(source, "bounces_allowed", exercise_3, || {
        check_3(solutions::bounces_allowed);
    });
    judge(source, "probability_of_a_miss", exercise_4, || {
        check_4(solutions::probability_of_a_miss);
    });
}

#[test]
fn the_solutions_are_those_in_the_book() {
    let mut numbers = Numbers::default();
    let (scene, _) = facing_mirrors(0.9);
    let plan = Plan::with_black_shadows(scene.map(opaque), 0.5);
    // Half a level in a black pixel, as the page's table has it.
    let least = 0.5 * (decode(1) - decode(0)) / plan.max_radiance;
    numbers.note("bounces", solutions::bounces_allowed(0.9, least));
    let white = 0.5 * (decode(255) - decode(254)) / plan.max_radiance;
    numbers.note("bounces-white", solutions::bounces_allowed(0.9, white));
    for (anchor, samples) in [("eight", 8), ("twenty", 20)] {
        let missed = solutions::probability_of_a_miss(0.1, samples);
        numbers.note(anchor, percent((1000.0 * missed).round() as usize, 1000));
    }
    numbers.check("15-plan-exercises");
}
