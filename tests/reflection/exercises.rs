//! The exercises' checks. Yours are judged by name:
//! `cargo test --test reflection exercise_1 -- --ignored`.

use crate::solutions;
use ::canvas::{Picture, Pixel};
use ::ray_casting::Ray;
use ::ray_casting::scene::still_life_camera;
use ::reflection::scene::still_life_mirrors;
use ::reflection::views::picture_of;
use ::reflection::{MAX_DEPTH, Mirror, PathBudget, STAGE, exercises, trace};
use ::shadows::Scene;
use ::shadows::scene::lit_still_life;
use glam::{UVec2, Vec3};
use harness::{
    Numbers, SMALL, assert_close, check_solution, judge, render_at, triple,
    with_separators,
};

/// The tint of gold, as glTF's materials have it.
const GOLD: Vec3 = Vec3::new(1.0, 0.77, 0.34);

fn check_1(mirrors: fn() -> [Mirror; 6]) {
    let [yours, ours] = [mirrors(), still_life_mirrors()];
    assert_eq!(yours[0].reflectivity, 0.3, "the floor's reflectivity");
    assert_eq!(yours[0].phong, ours[0].phong, "the rest of the floor");
    assert_eq!(yours[1..], ours[1..], "the balls");
}

/// The function that traces a ray between tinted mirrors.
type TraceTinted = fn(&Scene<Mirror>, &[Vec3], &Ray, PathBudget) -> Vec3;

fn check_2(trace_tinted: TraceTinted) {
    let scene = lit_still_life(solutions::still_life_on_a_mirror());
    let mut tints = vec![Vec3::ZERO; 6];
    tints[0] = Vec3::new(0.1, 0.3, 0.5);
    tints[2] = 0.8 * GOLD;
    let to_the_end = PathBudget {
        min_throughput: 0.0,
        ..PathBudget::new(4)
    };
    // Each channel is that of mirrors which reflect as much of all light.
    let by_channel = |channel: usize, ray: &Ray| {
        let mut scene = scene.clone();
        for (object, tint) in scene.objects.iter_mut().zip(&tints) {
            object.material.reflectivity = tint[channel];
        }
        trace(&scene, ray, to_the_end)[channel]
    };
    let camera = still_life_camera();
    for pixel in Pixel::all(UVec2::new(32, 24)) {
        let ray = camera.ray(pixel.centre());
        let right = Vec3::from_array([0, 1, 2].map(|channel| by_channel(channel, &ray)));
        let yours = trace_tinted(&scene, &tints, &ray, to_the_end);
        assert_close(&format!("{pixel:?}"), yours, right);
    }
    // The floor reflects but a tenth of the red light. The blue matters all the same.
    let picky = PathBudget {
        min_throughput: 0.45,
        ..PathBudget::new(1)
    };
    let straight_down = Ray {
        origin: Vec3::new(3.0, 2.0, -5.0),
        direction: Vec3::NEG_Y,
    };
    let yours = trace_tinted(&scene, &tints, &straight_down, picky);
    let without = trace(&scene, &straight_down, PathBudget::new(0));
    let what =
        "a floor that reflects half of the blue, where less than 0.45 is not followed";
    assert_close(what, yours, without + tints[0] * scene.background);
}

fn check_3(differing: impl Fn(&[[u8; 3]], &[[u8; 3]]) -> Vec<usize>) {
    let first = [[1, 2, 3], [4, 5, 6], [7, 8, 9], [0; 3]];
    assert_eq!(
        differing(&first, &first),
        Vec::<usize>::new(),
        "the same picture"
    );
    for channel in 0..3 {
        let mut second = first;
        second[1][channel] += 1;
        second[3][channel] = 200;
        assert_eq!(differing(&first, &second), [1, 3], "channel {channel}");
    }
}

#[test]
#[ignore = "an exercise for you"]
fn exercise_1() {
    check_1(exercises::still_life_on_a_mirror);
}

#[test]
#[ignore = "an exercise for you"]
fn exercise_2() {
    check_2(exercises::trace_tinted);
}

#[test]
#[ignore = "an exercise for you"]
fn exercise_3() {
    check_3(exercises::differing_pixels);
}

#[test]
fn the_exercises_are_judged_rightly() {
    let source = include_str!("../../chapters/06-reflection/src/exercises.rs");
    judge(source, "still_life_on_a_mirror", exercise_1, || {
        check_1(solutions::still_life_on_a_mirror);
    });
    judge(source, "trace_tinted", exercise_2, || {
        check_2(solutions::trace_tinted);
    });
    judge(source, "differing_pixels", exercise_3, || {
        check_3(solutions::differing_pixels);
    });
}

#[test]
fn the_solutions_are_those_in_the_book() {
    let camera = still_life_camera();
    let scene = lit_still_life(solutions::still_life_on_a_mirror());
    let on_a_mirror = picture_of(scene, camera, MAX_DEPTH as f32);
    check_solution(&STAGE, "exercise-1", &on_a_mirror);

    let scene = lit_still_life(still_life_mirrors());
    let mirrors = scene.objects.iter().map(|it| it.material.reflectivity);
    let mut tints: Vec<Vec3> = mirrors.map(Vec3::splat).collect();
    tints[2] *= GOLD;
    let gold = Picture::new(move |pixel| {
        let ray = camera.ray(pixel.centre());
        let budget = PathBudget::new(MAX_DEPTH);
        solutions::trace_tinted(&scene, &tints, &ray, budget)
    });
    check_solution(&STAGE, "exercise-2", &gold);

    let mut numbers = Numbers::default();
    let levels = |view: &str, depth: f32| render_at(&STAGE, view, depth, SMALL).levels;
    let differing = ["bouncing", "facing-mirrors"].map(|view| {
        let [one, two] = [1.0, 2.0].map(|depth| levels(view, depth));
        solutions::differing_pixels(&one, &two)
    });
    numbers.note("gold", triple(GOLD));
    for (anchor, pixels) in ["still-life", "facing"].iter().zip(&differing) {
        numbers.note(anchor, with_separators(pixels.len() as u64));
    }
    numbers.check("06-reflection-exercises");
    let [still_life, _] = differing;
    let mask = Picture::new(move |pixel| {
        let index = (pixel.x + SMALL.x * pixel.y) as usize;
        Vec3::splat(f32::from(still_life.contains(&index)))
    });
    check_solution(&STAGE, "exercise-3", &mask);
}
