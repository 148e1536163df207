//! The exercises' checks. Yours are judged by name:
//! `cargo test --test fresnel exercise_1 -- --ignored`.

use crate::solutions;
use ::canvas::{Picture, Pixel};
use ::fresnel::views::picture_of;
use ::fresnel::{STAGE, exercises, fresnel, scatter, schlick, trace};
use ::plane_hit::nearest;
use ::ray_casting::Ray;
use ::reflection::{MAX_DEPTH, PathBudget};
use ::refraction::scene::{AIR, GLASS, close_up, still_life_with_glass};
use ::refraction::{Material, spawn_ray};
use ::shadows::{Interaction, Scene};
use glam::{UVec2, Vec3};
use harness::{Numbers, assert_close, check_solution, judge, three_digits};

/// Cosines from 1 to nearly 0.
fn cosines() -> impl Iterator<Item = f32> {
    (1..=100).map(|i| i as f32 / 100.0)
}

fn assert_near(what: &str, yours: f32, right: f64) {
    let error = (f64::from(yours) - right).abs();
    assert!(error < 1e-5, "{what}: yours is {yours}, right is {right}");
}

fn check_1(mended: fn(f32, f32, f32) -> f32) {
    for eta in [1.33_f32, 1.5, 2.42] {
        let critical = (1.0 - 1.0 / (eta * eta)).sqrt();
        for cosine in cosines() {
            let entering = f64::from(schlick(cosine, 1.0, eta));
            let what = format!("entering an index of {eta}, cosθᵢ = {cosine}");
            assert_near(&what, mended(cosine, 1.0, eta), entering);
            // The ray that goes the same way backwards has the same reflectance.
            let sine2 =
                (1.0 - f64::from(cosine) * f64::from(cosine)) / f64::from(eta * eta);
            let backwards = (1.0 - sine2).sqrt() as f32;
            // Near the critical angle the formula itself multiplies the rounding of this.
            if cosine > 0.05 {
                let yours = f64::from(mended(backwards, eta, 1.0));
                let what = format!("leaving an index of {eta}, cosθᵢ = {backwards}");
                assert!(
                    (yours - entering).abs() < 1e-3,
                    "{what}: yours is {yours}, right is {entering}"
                );
            }
            if cosine < 0.99 * critical {
                let what = format!("total reflection, index {eta}, cosθᵢ = {cosine}");
                assert_near(&what, mended(cosine, eta, 1.0), 1.0);
            }
        }
    }
}

fn check_2(brewster_cosine: fn(f32, f32) -> f32) {
    for (eta_i, eta_t) in [(1.0, 1.5), (1.5, 1.0), (1.33, 1.5), (1.0, 2.42), (1.0, 1.0)] {
        let (i, t) = (f64::from(eta_i), f64::from(eta_t));
        let cosine = f64::from(brewster_cosine(eta_i, eta_t));
        let sine_t = i / t * (1.0 - cosine * cosine).sqrt();
        let cosine_t = (1.0 - sine_t * sine_t).sqrt();
        let amplitude = (t * cosine - i * cosine_t) / (t * cosine + i * cosine_t);
        assert!(
            amplitude.abs() < 1e-5,
            "from {eta_i} to {eta_t}, cosθᵢ = {cosine}: r∥ is {amplitude}"
        );
    }
}

fn check_3(polarised: fn(f32, f32, f32) -> [f32; 2]) {
    for (eta_i, eta_t) in [(1.0, 1.5), (1.5, 1.0), (1.0, 2.42), (1.5, 1.5)] {
        for cosine in cosines() {
            let [parallel, perpendicular] = polarised(cosine, eta_i, eta_t);
            let what = format!("from {eta_i} to {eta_t}, cosθᵢ = {cosine}");
            let mean = f64::from(fresnel(cosine, eta_i, eta_t));
            assert_near(
                &format!("the mean, {what}"),
                (parallel + perpendicular) / 2.0,
                mean,
            );
            assert!(
                parallel <= perpendicular + 1e-5 && parallel >= 0.0,
                "parallel is {parallel}, perpendicular {perpendicular}, {what}"
            );
        }
        let brewster = solutions::brewster_cosine(eta_i, eta_t);
        let [parallel, _] = polarised(brewster, eta_i, eta_t);
        assert_near("parallel, at Brewster's angle", parallel, 0.0);
    }
}

/// The function that traces a ray with a tint for what is reflected and one for the rest.
type TraceSplit = fn(&Scene<Material>, &Ray, PathBudget, [Vec3; 2]) -> Vec3;

fn check_4(trace_split: TraceSplit) {
    let scene = still_life_with_glass(GLASS, AIR);
    let tints = [Vec3::new(1.0, 0.5, 0.0), Vec3::new(0.0, 0.2, 1.0)];
    let none = PathBudget::new(0);
    for pixel in Pixel::all(UVec2::new(24, 18)) {
        let ray = close_up().ray(pixel.centre());
        let deep = PathBudget::new(6);
        let what = |case| format!("{case}, {pixel:?}");
        let untinted = trace(&scene, &ray, deep, fresnel);
        let yours = trace_split(&scene, &ray, deep, [Vec3::ONE; 2]);
        assert_close(&what("without a tint"), yours, untinted);
        let own = trace(&scene, &ray, none, fresnel);
        let yours = trace_split(&scene, &ray, none, tints);
        assert_close(&what("without a bounce"), yours, own);
        // With some bounces: the surface's own light, and that of two rays with one less.
        for budget in [1, 2, 3].map(PathBudget::new) {
            let mut right = own;
            if let Some(hit) = nearest(&scene.objects, &ray) {
                let at = Interaction::new(&scene.objects, &ray, hit);
                let optics = &scene.objects[at.index].material.optics;
                let rays = scatter(optics, &at, fresnel).into_iter().zip(tints);
                for (scattered, tint) in rays {
                    let Some((weight, direction)) = scattered else {
                        continue;
                    };
                    if let Some(budget) = budget.attenuated(weight) {
                        let next = spawn_ray(&at, direction);
                        right +=
                            weight * tint * trace_split(&scene, &next, budget, tints);
                    }
                }
            }
            let yours = trace_split(&scene, &ray, budget, tints);
            assert_close(&what("with tints"), yours, right);
        }
    }
}

#[test]
#[ignore = "an exercise for you"]
fn exercise_1() {
    check_1(exercises::mended_schlick);
}

#[test]
#[ignore = "an exercise for you"]
fn exercise_2() {
    check_2(exercises::brewster_cosine);
}

#[test]
#[ignore = "an exercise for you"]
fn exercise_3() {
    check_3(exercises::polarised);
}

#[test]
#[ignore = "an exercise for you"]
fn exercise_4() {
    check_4(exercises::trace_split);
}

#[test]
fn the_exercises_are_judged_rightly() {
    let source = include_str!("../../chapters/08-fresnel/src/exercises.rs");
    judge(source, "mended_schlick", exercise_1, || {
        check_1(solutions::mended_schlick);
    });
    judge(source, "brewster_cosine", exercise_2, || {
        check_2(solutions::brewster_cosine);
    });
    judge(source, "polarised", exercise_3, || {
        check_3(solutions::polarised)
    });
    judge(source, "trace_split", exercise_4, || {
        check_4(solutions::trace_split);
    });
}

#[test]
fn the_solutions_are_those_in_the_book() {
    let parallel = |cosine, eta_i, eta_t| solutions::polarised(cosine, eta_i, eta_t)[0];
    let filtered = picture_of(GLASS, AIR, close_up(), parallel);
    check_solution(&STAGE, "exercise-3", &filtered);
    let unfiltered = picture_of(GLASS, AIR, close_up(), fresnel);
    check_solution(&STAGE, "exercise-3-both", &unfiltered);
    let scene = still_life_with_glass(GLASS, AIR);
    let split = Picture::new(move |pixel| {
        let ray = close_up().ray(pixel.centre());
        let [red, blue] = [Vec3::new(1.0, 0.1, 0.1), Vec3::new(0.2, 0.3, 1.0)];
        let budget = PathBudget::new(MAX_DEPTH);
        solutions::trace_split(&scene, &ray, budget, [red, blue])
    });
    check_solution(&STAGE, "exercise-4", &split);

    let mut numbers = Numbers::default();
    let worst = |schlick: fn(f32, f32, f32) -> f32| {
        let errors = (0..=10_000).map(|i| {
            let cosine = i as f32 / 10_000.0;
            let right = fresnel(cosine, GLASS, AIR);
            f64::from((schlick(cosine, GLASS, AIR) - right).abs())
        });
        three_digits(errors.fold(
            0.0,
            |worst, error| if error > worst { error } else { worst },
        ))
    };
    numbers.note("worst-schlick", worst(schlick));
    numbers.note("worst-mended", worst(solutions::mended_schlick));
    let brewster = solutions::brewster_cosine(AIR, GLASS);
    let degrees = f64::from(brewster).acos().to_degrees();
    numbers.note("brewster", format!("{}°", three_digits(degrees)));
    let perpendicular = solutions::polarised(brewster, AIR, GLASS)[1];
    numbers.note("perpendicular", three_digits(f64::from(perpendicular)));
    numbers.check("08-fresnel-exercises");
}
