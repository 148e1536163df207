//! The exercises' checks. Yours are judged by name:
//! `cargo test --test transparency exercise_1 -- --ignored`.

use crate::solutions;
use ::canvas::Picture;
use ::fresnel::fresnel;
use ::plane_hit::{Object, Shape};
use ::ray_casting::Camera;
use ::ray_casting::scene::still_life_camera;
use ::reflection::{MAX_DEPTH, PathBudget};
use ::refraction::Optics;
use ::refraction::scene::close_up;
use ::shadow_acne::from_eye;
use ::shadows::Scene;
use ::transparency::scene::{AMBER, absorbing_still_life, pool};
use ::transparency::{Absorbing, STAGE, between_media, exercises, trace, transmittance};
use glam::Vec3;
use harness::{Numbers, assert_close, check_solution, judge, percent, vector};

fn check_1(behind: fn(Vec3, Vec3, f32) -> Vec3) {
    let red = Vec3::new(1.0, 0.1, 0.05);
    let green = Vec3::new(2.0, 0.1, 1.5);
    assert_close("no glass", behind(red, green, 0.0), red);
    assert_close("clear glass", behind(red, Vec3::ZERO, 3.0), red);
    assert_close("no light", behind(Vec3::ZERO, green, 1.0), Vec3::ZERO);
    let one = behind(red, green, 1.0);
    // e⁻², e^−0.1 and e^−1.5.
    let right = red * Vec3::new(0.135_335_28, 0.904_837_4, 0.223_130_16);
    assert_close("red light behind green glass", one, right);
    assert_close(
        "two panes",
        behind(one, green, 1.0),
        behind(red, green, 2.0),
    );
}

fn check_2(through: fn(f32, f32) -> f32) {
    let close = |what: &str, yours: f32, right: f32| {
        let [yours, right] = [yours, right].map(Vec3::splat);
        assert_close(what, yours, right);
    };
    close("an index of 1", through(0.5, 1.0), 1.0);
    // Head-on, four hundredths are reflected, twice.
    close("head-on", through(1.0, 1.5), 0.9216);
    for eta in [1.33, 1.5, 2.42] {
        for i in 1..=20 {
            let cosine = i as f32 / 20.0;
            let sine2 = (1.0 - cosine * cosine) / (eta * eta);
            let entering = 1.0 - fresnel(cosine, 1.0, eta);
            let leaving = 1.0 - fresnel((1.0 - sine2).sqrt(), eta, 1.0);
            let yours = through(cosine, eta);
            let error = (yours - entering * leaving).abs();
            assert!(
                error < 1e-3,
                "index {eta}, cosθ = {cosine}: yours is {yours}"
            );
        }
    }
}

fn check_3(pearl: fn() -> Object<Absorbing>) {
    let pearl = pearl();
    let ball = Shape::sphere(Vec3::new(0.9, 0.6, -1.2), 0.2);
    assert_eq!(pearl.shape, ball, "its shape");
    let material = pearl.material.material;
    let opaque = Optics::Opaque { reflectivity: 0.0 };
    assert_eq!(material.optics, opaque, "its optics");
    let colour = material.phong.colour.value(glam::Vec2::ZERO);
    assert_eq!(colour, Vec3::ONE, "its colour");
    assert!(
        material.phong.diffuse > 0.5,
        "it is hardly lit: {:?}",
        material.phong
    );
    assert_eq!(material.phong.specular, 0.0, "it is matte");
}

fn check_4(water_last: fn(Vec<Object<Absorbing>>) -> Vec<Object<Absorbing>>) {
    let (scene, _) = pool();
    let right = ["ground", "red", "ice", "glass", "bubble", "water"];
    let yours = water_last(scene.objects.clone());
    let names: Vec<&str> = yours.iter().map(|object| object.name).collect();
    assert_eq!(names, right);
    for object in &yours {
        assert!(
            scene.objects.contains(object),
            "{} is another one",
            object.name
        );
    }
}

fn check_5(through_fog: fn(Vec3, Vec3, f32, f32) -> Vec3) {
    let (light, sky) = (Vec3::new(0.9, 0.1, 0.2), Vec3::new(0.2, 0.5, 0.8));
    let fog = |light, distance| through_fog(light, sky, 0.1, distance);
    assert_close("from nearby", fog(light, 0.0), light);
    assert_close("from very far", fog(light, 1e4), sky);
    assert_close("the sky itself", fog(sky, 5.0), sky);
    // e^−0.5.
    let part = 0.606_530_67;
    let right = part * light + (1.0 - part) * sky;
    assert_close("from 5, with a density of 0.1", fog(light, 5.0), right);
    let in_two_steps = fog(fog(light, 2.0), 3.0);
    assert_close("2 behind 3", in_two_steps, right);
}

#[test]
#[ignore = "an exercise for you"]
fn exercise_1() {
    check_1(exercises::light_behind_glass);
}

#[test]
#[ignore = "an exercise for you"]
fn exercise_2() {
    check_2(exercises::through_two_interfaces);
}

#[test]
#[ignore = "an exercise for you"]
fn exercise_3() {
    check_3(exercises::pearl);
}

#[test]
#[ignore = "an exercise for you"]
fn exercise_4() {
    check_4(exercises::water_last);
}

#[test]
#[ignore = "an exercise for you"]
fn exercise_5() {
    check_5(exercises::through_fog);
}

#[test]
fn the_exercises_are_judged_rightly() {
    let source = include_str!("../../chapters/11-transparency/src/exercises.rs");
    judge(source, "light_behind_glass", exercise_1, || {
        check_1(solutions::light_behind_glass);
    });
    judge(source, "through_two_interfaces", exercise_2, || {
        check_2(solutions::through_two_interfaces);
    });
    judge(source, "pearl", exercise_3, || check_3(solutions::pearl));
    judge(source, "water_last", exercise_4, || {
        check_4(solutions::water_last)
    });
    judge(source, "through_fog", exercise_5, || {
        check_5(solutions::through_fog)
    });
}

fn picture_of(scene: Scene<Absorbing>, camera: Camera) -> Picture {
    let budget = PathBudget::new(MAX_DEPTH);
    Picture::new(move |pixel| {
        let ray = from_eye(&scene.objects, camera.eye)(camera.ray(pixel.centre()));
        trace(&scene, &ray, budget, between_media)
    })
}

#[test]
fn the_solutions_are_those_in_the_book() {
    let mut with_pearl = absorbing_still_life(AMBER);
    with_pearl.objects.push(solutions::pearl());
    let pearl = picture_of(with_pearl, close_up());
    check_solution(&STAGE, "exercise-3", &pearl);
    let (mut scene, camera) = pool();
    scene.objects = solutions::water_last(scene.objects);
    check_solution(&STAGE, "exercise-4", &picture_of(scene, camera));
    let scene = absorbing_still_life(AMBER);
    let camera = still_life_camera();
    let foggy = Picture::new(move |pixel| {
        let ray = from_eye(&scene.objects, camera.eye)(camera.ray(pixel.centre()));
        let light = trace(&scene, &ray, PathBudget::new(MAX_DEPTH), between_media);
        let distance = ray
            .intersect(&scene.objects)
            .map_or(f32::INFINITY, |at| at.t);
        solutions::through_fog(light, scene.background, 0.1, distance)
    });
    check_solution(&STAGE, "exercise-5", &foggy);

    let mut numbers = Numbers::default();
    let green = Vec3::new(2.5, 0.1, 2.5);
    let red = Vec3::new(1.0, 0.1, 0.1);
    let left = solutions::light_behind_glass(red, green, 1.2);
    numbers.note("red-behind-green", vector(&left.to_array()));
    for (anchor, cosine) in [("head-on", 1.0), ("slanting", 0.5), ("grazing", 0.1)] {
        let through = solutions::through_two_interfaces(cosine, 1.5);
        numbers.note(
            anchor,
            percent((10_000.0 * through).round() as usize, 10_000),
        );
    }
    // To the pearl and back, in the middle: four tenths of amber, twice.
    let amber = transmittance(AMBER, 0.8);
    numbers.note("amber", vector(&amber.to_array()));
    numbers.check("11-transparency-exercises");
}
