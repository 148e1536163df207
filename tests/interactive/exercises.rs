//! The exercises' checks. Yours are judged by name:
//! `cargo test --test interactive exercise_1 -- --ignored`.

use crate::solutions;
use ::canvas::{Picture, Pixel, encode};
use ::fresnel::{fresnel, trace};
use ::interactive::{STAGE, exercises};
use ::packets::{Lanes, sample_offsets};
use ::ray_casting::Camera;
use ::ray_casting::scene::still_life_camera;
use ::reflection::{MAX_DEPTH, PathBudget};
use ::refraction::scene::{AIR, GLASS, still_life_with_glass};
use glam::{UVec2, Vec2, Vec3};
use harness::{
    Numbers, assert_close, bits, check_solution, judge, percent, three_digits,
};

/// Returns the offset of the i-th of a pixel's n × n samples from its centre.
fn sample_offset(pixel: Pixel, n: u32, i: u32) -> Vec2 {
    let [x, y] = sample_offsets(pixel, n, Lanes::splat(i as f32));
    Vec2::new(x.to_array()[0], y.to_array()[0])
}

fn check_1(leaning: fn(&Camera, f32, f32) -> Camera) {
    let camera = still_life_camera();
    for (cos, sin) in [(1.0, 0.0), (0.8, 0.6), (0.6, -0.8), (0.0, 1.0)] {
        let yours = leaning(&camera, cos, sin);
        assert_eq!(yours.eye, camera.eye, "its eye");
        assert_close("its direction", yours.forward, camera.forward);
        assert_eq!(yours.focal_length, camera.focal_length, "its focal length");
        let what = format!("its up, cos = {cos}, sin = {sin}");
        assert_close(&what, yours.up, cos * camera.up + sin * camera.right);
        assert_close("its right", yours.right, yours.up.cross(yours.forward));
    }
}

fn check_2(middle_first: fn(u32) -> Vec<u32>) {
    for n in 1..=20 {
        let yours = middle_first(n);
        let mut sorted = yours.clone();
        sorted.sort_unstable();
        assert_eq!(
            sorted,
            (0..n * n).collect::<Vec<_>>(),
            "each sample once, n = {n}"
        );
        let size = UVec2::ONE;
        let pixel = Pixel { x: 0, y: 0, size };
        let distance = |i: &u32| sample_offset(pixel, n, *i).as_dvec2().length();
        for two in yours.windows(2) {
            // Some are equally far.
            let [nearer, farther] = [&two[0], &two[1]].map(distance);
            assert!(
                nearer <= farther + 1e-6,
                "n = {n}: {} comes before {}",
                two[0],
                two[1]
            );
        }
    }
}

#[test]
#[ignore = "an exercise for you"]
fn exercise_1() {
    check_1(exercises::leaning);
}

#[test]
#[ignore = "an exercise for you"]
fn exercise_2() {
    check_2(exercises::middle_first);
}

#[test]
fn the_exercises_are_judged_rightly() {
    let source = include_str!("../../chapters/13-interactive/src/exercises.rs");
    judge(source, "leaning", exercise_1, || {
        check_1(solutions::leaning)
    });
    judge(source, "middle_first", exercise_2, || {
        check_2(solutions::middle_first);
    });
}

#[test]
fn the_solutions_are_those_in_the_book() {
    let scene = still_life_with_glass(GLASS, AIR);
    let budget = PathBudget::new(MAX_DEPTH);
    let camera = solutions::leaning(&still_life_camera(), 0.96, 0.28);
    let leaning = {
        let scene = scene.clone();
        Picture::new(move |pixel| {
            trace(&scene, &camera.ray(pixel.centre()), budget, fresnel)
        })
    };
    check_solution(&STAGE, "exercise-1", &leaning);

    const N: u32 = 4;
    let size = UVec2::new(80, 60);
    let mean = |pixel: Pixel, order: &[u32]| {
        let sum = order.iter().fold(Vec3::ZERO, |sum, &i| {
            let point = pixel.centre() + sample_offset(pixel, N, i);
            sum + trace(&scene, &still_life_camera().ray(point), budget, fresnel)
        });
        sum / (N * N) as f32
    };
    let [rows, middle]: [Vec<u32>; 2] =
        [(0..N * N).collect(), solutions::middle_first(N)];
    let pairs = Pixel::all(size).map(|pixel| [mean(pixel, &rows), mean(pixel, &middle)]);
    let pairs: Vec<_> = pairs.collect();
    let differing = pairs.iter().filter(|[a, b]| bits(a) != bits(b)).count();
    let levels = pairs
        .iter()
        .filter(|[a, b]| encode(*a) != encode(*b))
        .count();
    let mut numbers = Numbers::default();
    numbers.note("other-bits", percent(differing, pairs.len()));
    numbers.note("other-levels", percent(levels, pairs.len()));
    // Total reflection wants a sine of 1/1.5; the ball's radius is 0.6.
    numbers.note("total-reflection", three_digits(0.6 / 1.5));
    numbers.check("13-interactive-exercises");
}
