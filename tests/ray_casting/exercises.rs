//! The exercises' checks. Yours are judged by name:
//! `cargo test --test ray_casting exercise_1 -- --ignored`.

use crate::solutions;
use ::canvas::{Picture, Pixel};
use ::ray_casting::scene::still_life_camera;
use ::ray_casting::views::directions;
use ::ray_casting::{Camera, GROUND, Ray, SKY, STAGE, exercises, trace};
use glam::{Vec2, Vec3};
use harness::{Numbers, SMALL, assert_close, check_solution, evenly, judge, percent};

fn check_1(camera: fn() -> Camera) {
    let camera = camera();
    assert_close("its eye", camera.eye, Vec3::new(0.0, 2.0, 7.0));
    let forward = Vec3::new(0.0, -1.1, -7.0).normalize();
    assert_close("its direction", camera.forward, forward);
    assert_close("its right", camera.right, Vec3::NEG_X);
    let focal_length = still_life_camera().focal_length;
    assert_eq!(camera.focal_length, focal_length, "its focal length");
}

fn check_2(sky: fn(Vec3) -> Vec3) {
    for direction in [Vec3::X, Vec3::Z, Vec3::new(-0.6, 0.0, 0.8)] {
        assert_close("at the horizon", sky(direction), Vec3::ONE);
    }
    assert_close("at the zenith", sky(Vec3::Y), SKY);
    // However it fades, it must do so from the one to the other.
    let rising = |y: f32| Vec3::new((1.0 - y * y).sqrt(), y, 0.0);
    let lights = (0..=50).map(|i| sky(rising(i as f32 / 50.0)));
    let lights: Vec<Vec3> = lights.collect();
    for (i, two) in lights.windows(2).enumerate() {
        let deepens = two[0].cmpge(two[1]).all() && two[0] != two[1];
        assert!(
            deepens,
            "from y = {i}/50 on: {} is followed by {}",
            two[0], two[1]
        );
    }
    let (east, north) = (rising(0.5), Vec3::new(0.0, 0.5, 0.75_f32.sqrt()));
    assert_close("the same height, elsewhere", sky(north), sky(east));
}

fn check_3(camera: fn() -> Camera) {
    let (camera, level) = (camera(), still_life_camera());
    assert_close("its eye", camera.eye, level.eye);
    assert_close("its direction", camera.forward, level.forward);
    assert_eq!(camera.focal_length, level.focal_length, "its focal length");
    let upright = Vec3::new(0.5, 1.0, 0.0);
    assert!(
        upright.dot(camera.right).abs() < 1e-6 && upright.dot(camera.up) > 0.0,
        "{upright} is not upright: right is {}, up is {}",
        camera.right,
        camera.up
    );
    assert_close("its right", camera.right, camera.up.cross(camera.forward));
}

fn check_4(parallel_ray: fn(&Camera, Vec2) -> Ray) {
    for camera in [still_life_camera(), solutions::camera_from_behind()] {
        for i in 0..100 {
            let [x, y, _] = evenly(i).map(|x| 2.0 * x as f32 - 1.0);
            let Ray { origin, direction } = parallel_ray(&camera, Vec2::new(x, y));
            assert_close("the direction", direction, camera.forward);
            let from_eye = origin - camera.eye;
            let axes = [camera.right, camera.up, camera.forward];
            let place = Vec3::from_array(axes.map(|axis| from_eye.dot(axis)));
            let what = "the origin, from the eye to the right, up and ahead";
            assert_close(what, place, Vec3::new(x, y, 0.0));
        }
    }
}

#[test]
#[ignore = "an exercise for you"]
fn exercise_1() {
    check_1(exercises::camera_from_behind);
}

#[test]
#[ignore = "an exercise for you"]
fn exercise_2() {
    check_2(exercises::sky);
}

#[test]
#[ignore = "an exercise for you"]
fn exercise_3() {
    check_3(exercises::rolled_camera);
}

#[test]
#[ignore = "an exercise for you"]
fn exercise_4() {
    check_4(exercises::parallel_ray);
}

#[test]
fn the_exercises_are_judged_rightly() {
    let source = include_str!("../../chapters/01-ray-casting/src/exercises.rs");
    judge(source, "camera_from_behind", exercise_1, || {
        check_1(solutions::camera_from_behind);
    });
    judge(source, "sky", exercise_2, || check_2(solutions::sky));
    judge(source, "rolled_camera", exercise_3, || {
        check_3(solutions::rolled_camera);
    });
    judge(source, "parallel_ray", exercise_4, || {
        check_4(solutions::parallel_ray);
    });
}

#[test]
fn the_solutions_are_those_in_the_book() {
    let behind = directions(solutions::camera_from_behind());
    check_solution(&STAGE, "exercise-1", &behind);
    let up = Vec3::new(0.0, 1.0, 2.0);
    let camera = Camera::new(Vec3::Y, up, Vec3::Y, 1.0).expect("a camera");
    let fading = Picture::new(move |pixel| {
        let direction = camera.ray(pixel.centre()).direction;
        if direction.y > 0.0 {
            solutions::sky(direction)
        } else {
            GROUND
        }
    });
    check_solution(&STAGE, "exercise-2", &fading);
    let camera = solutions::rolled_camera();
    let rolled = Picture::new(move |pixel| trace(&camera.ray(pixel.centre())));
    check_solution(&STAGE, "exercise-3", &rolled);

    let mut numbers = Numbers::default();
    let camera = still_life_camera();
    let rays = Pixel::all(SMALL)
        .map(|pixel| trace(&solutions::parallel_ray(&camera, pixel.centre())));
    let ground = rays.filter(|&radiance| radiance == GROUND).count();
    let pixels = (SMALL.x * SMALL.y) as usize;
    numbers.note("parallel-ground", percent(ground, pixels));
    numbers.check("01-ray-casting-exercises");
}
