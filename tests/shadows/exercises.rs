//! The exercises' checks. Yours are judged by name:
//! `cargo test --test shadows exercise_1 -- --ignored`.

use crate::solutions;
use ::canvas::{Picture, Pixel};
use ::plane_hit::scene::STILL_LIFE_COLOURS;
use ::plane_hit::{Texture, nearest};
use ::ray_casting::Ray;
use ::ray_casting::scene::still_life_camera;
use ::shadows::scene::lit_still_life;
use ::shadows::{Interaction, PointLight, STAGE, Scene, exercises, is_visible, trace};
use glam::{UVec2, Vec3};
use harness::{Numbers, SMALL, assert_close, check_solution, judge, with_separators};

const TINY: UVec2 = UVec2::new(40, 30);

/// The still life's camera rays, for a picture of some size.
fn rays(size: UVec2) -> impl Iterator<Item = Ray> {
    let camera = still_life_camera();
    Pixel::all(size).map(move |pixel| camera.ray(pixel.centre()))
}

fn check_1(still_life: fn([Texture; 6]) -> Scene<Texture>) {
    let ours = lit_still_life(STILL_LIFE_COLOURS);
    let yours = still_life(STILL_LIFE_COLOURS);
    assert_eq!(yours.objects, ours.objects, "its objects");
    assert_eq!(yours.lights.len(), 3, "its lights");
    for light in ours.lights {
        assert!(yours.lights.contains(&light), "{light:?} is gone");
    }
    let headlamp = PointLight {
        position: still_life_camera().eye,
        intensity: 0.3,
    };
    assert!(yours.lights.contains(&headlamp), "there is no {headlamp:?}");
}

fn check_2(trace_coloured: fn(&Scene<Texture>, &[Vec3], &Ray) -> Vec3) {
    let scene = lit_still_life(STILL_LIFE_COLOURS);
    let colours = [Vec3::new(0.9, 0.2, 0.0), Vec3::new(0.0, 0.3, 0.7)];
    for ray in rays(TINY) {
        // The light of two lights is the sum of that of either.
        let by_one = |i: usize| {
            let light = PointLight {
                intensity: 1.0,
                ..scene.lights[i]
            };
            let scene = Scene {
                lights: vec![light],
                background: Vec3::ZERO,
                ..scene.clone()
            };
            colours[i] * trace(&scene, &ray, is_visible)
        };
        let right = match nearest(&scene.objects, &ray) {
            Some(_) => by_one(0) + by_one(1),
            None => scene.background,
        };
        let yours = trace_coloured(&scene, &colours, &ray);
        assert_close(&format!("{ray:?}"), yours, right);
    }
}

fn check_4(faded: fn(&PointLight, Vec3) -> f32) {
    let position = Vec3::new(1.0, 2.0, 3.0);
    for intensity in [0.5, 40.0] {
        let light = PointLight {
            position,
            intensity,
        };
        for (distance, part) in [(1.0, 1.0), (2.0, 0.25), (10.0, 0.01), (0.5, 4.0)] {
            for direction in [Vec3::X, Vec3::NEG_Y, Vec3::new(0.6, 0.0, -0.8)] {
                let yours = faded(&light, position + distance * direction);
                let what = format!("{intensity} at a distance of {distance}");
                assert_close(&what, Vec3::splat(yours), Vec3::splat(intensity * part));
            }
        }
    }
}

#[test]
#[ignore = "an exercise for you"]
fn exercise_1() {
    check_1(exercises::still_life_with_headlamp);
}

#[test]
#[ignore = "an exercise for you"]
fn exercise_2() {
    check_2(exercises::trace_coloured);
}

#[test]
#[ignore = "an exercise for you"]
fn exercise_4() {
    check_4(exercises::faded);
}

#[test]
fn the_exercises_are_judged_rightly() {
    let source = include_str!("../../chapters/04-shadows/src/exercises.rs");
    judge(source, "still_life_with_headlamp", exercise_1, || {
        check_1(solutions::still_life_with_headlamp);
    });
    judge(source, "trace_coloured", exercise_2, || {
        check_2(solutions::trace_coloured);
    });
    judge(source, "faded", exercise_4, || check_4(solutions::faded));
}

#[test]
fn the_solutions_are_those_in_the_book() {
    let camera = still_life_camera();
    let scene = solutions::still_life_with_headlamp(STILL_LIFE_COLOURS);
    let hits = |scene: &Scene<Texture>| {
        let interaction = |ray| {
            let hit = nearest(&scene.objects, &ray)?;
            Some(Interaction::new(&scene.objects, &ray, hit))
        };
        rays(SMALL).filter_map(interaction).collect::<Vec<_>>()
    };
    let in_shadow = |scene: &Scene<Texture>, light: &PointLight| {
        let hits = hits(scene);
        let dark = hits.iter().filter(|at| !is_visible(scene, at, light));
        with_separators(dark.count() as u64)
    };
    let mut numbers = Numbers::default();
    numbers.note("shadow-of-headlamp", in_shadow(&scene, &scene.lights[2]));
    numbers.note("shadow-of-first", in_shadow(&scene, &scene.lights[0]));
    let with_headlamp =
        Picture::new(move |pixel| trace(&scene, &camera.ray(pixel.centre()), is_visible));
    check_solution(&STAGE, "exercise-1", &with_headlamp);

    let scene = lit_still_life(STILL_LIFE_COLOURS);
    let coloured = Picture::new(move |pixel| {
        let colours = [Vec3::new(0.6, 0.0, 0.0), Vec3::new(0.0, 0.6, 0.0)];
        solutions::trace_coloured(&scene, &colours, &camera.ray(pixel.centre()))
    });
    check_solution(&STAGE, "exercise-2", &coloured);

    let lit_from = |position| {
        let scene = lit_still_life(STILL_LIFE_COLOURS);
        let light = PointLight::new(position, 1.0).expect("a light");
        let hits = hits(&scene);
        let lit = hits.iter().filter(|at| is_visible(&scene, at, &light));
        with_separators(lit.count() as u64)
    };
    numbers.note("lit-from-above", lit_from(Vec3::new(0.0, 5.0, 0.0)));
    numbers.note("lit-from-below", lit_from(Vec3::new(0.0, -1.0, 0.0)));
    numbers.note("lit-from-the-red-ball", lit_from(Vec3::new(-2.2, 0.8, 1.0)));
    let scene = lit_still_life(STILL_LIFE_COLOURS);
    let mut lights = scene.lights.iter();
    let mut squared = || lights.next().map(|it| it.position.length_squared());
    numbers.note("first-squared", squared().expect("a light"));
    numbers.note("second-squared", squared().expect("a light"));
    numbers.check("04-shadows-exercises");
}
