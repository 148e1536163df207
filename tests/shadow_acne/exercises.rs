//! The exercises' checks. Yours are judged by name:
//! `cargo test --test shadow_acne exercise_1 -- --ignored`.

use crate::solutions;
use ::canvas::{Picture, Pixel, encode};
use ::plane_hit::{Object, Shape, nearest};
use ::ray_casting::Ray;
use ::reflection::{MAX_DEPTH, PathBudget};
use ::shadow_acne::scene::balls_on_a_planet;
use ::shadow_acne::{
    STAGE, SpawnRay, SurfaceRay, exercises, from_eye, from_surface, trace,
    with_scaled_offset,
};
use ::shadows::Interaction;
use glam::Vec3;
use harness::{Numbers, SMALL, check_solution, evenly, judge, table, with_separators};

/// Returns hits on balls and planes of several sizes, each with a direction in which a ray
/// leaves.
fn hits() -> Vec<(Interaction, Vec3)> {
    let shapes = [
        Shape::sphere(Vec3::new(0.5, -1.0, 2.0), 1.0),
        Shape::sphere(Vec3::new(300.0, 20.0, -500.0), 40.0),
        Shape::plane(Vec3::new(0.0, -1.0, 3.0), Vec3::Y),
        Shape::plane(Vec3::new(40.0, 10.0, 3.0), Vec3::new(1.0, 2.0, -1.0)),
    ];
    let hits = shapes.into_iter().flat_map(|shape| {
        (0..200).filter_map(move |i| {
            let objects = [Object {
                name: "",
                shape,
                material: (),
            }];
            let (point, away) = match shape {
                Shape::Sphere(sphere) => (sphere.centre, 2.0 * sphere.radius),
                Shape::Plane(plane) => (plane.point, 10.0),
            };
            let [from, direction] = [i, i + 1000]
                .map(|i| Vec3::from_array(evenly(i).map(|x| x as f32 - 0.5)));
            let ray = Ray {
                origin: point + away * from.normalize(),
                direction: (direction - from).normalize(),
            };
            let hit = nearest(&objects, &ray)?;
            Some((Interaction::new(&objects, &ray, hit), direction.normalize()))
        })
    });
    hits.collect()
}

fn check_1(with_offset_by: fn(f32, &Interaction, Vec3) -> SurfaceRay) {
    for (at, direction) in hits() {
        let what = format!("{at:?}, {direction}");
        let four = with_offset_by(4.0, &at, direction);
        let ours = with_scaled_offset(&at, direction);
        assert_eq!(four.origin, None, "where it starts is not known: {what}");
        assert_eq!(four.ray.direction, direction, "its direction: {what}");
        let surface = from_surface(&at, direction).ray.origin;
        // How far a ray starts from the surface, in f64.
        let offset = |ray: Ray| (ray.origin.as_dvec3() - surface.as_dvec3()).length();
        let ours = offset(ours.ray);
        for factor in [1.0, 4.0, 64.0, 1000.0] {
            let yours = offset(with_offset_by(factor, &at, direction).ray);
            let right = ours * f64::from(factor) / 4.0;
            // Each is rounded, by about a float of the largest coordinate.
            let rounding = 2.0 * f64::from(f32::EPSILON * surface.abs().max_element());
            assert!(
                (yours - right).abs() < rounding * (1.0 + f64::from(factor) / 4.0),
                "by {factor}: yours starts {yours} away, right is {right}: {what}"
            );
        }
    }
}

/// The number of a float, in order: that of the next one is one more.
fn number(x: f32) -> i64 {
    let bits = i64::from(x.to_bits() & 0x7fff_ffff);
    if x.is_sign_negative() { -bits } else { bits }
}

fn check_5(with_steps_of_floats: SpawnRay) {
    for (at, direction) in hits() {
        let what = format!("{at:?}, {direction}");
        let yours = with_steps_of_floats(&at, direction);
        assert_eq!(yours.origin, None, "where it starts is not known: {what}");
        assert_eq!(yours.ray.direction, direction, "its direction: {what}");
        let side = at.outward.dot(direction);
        for axis in 0..3 {
            let steps = number(yours.ray.origin[axis]) - number(at.point[axis]);
            let towards = side * at.outward[axis];
            let right = if towards > 0.0 {
                32
            } else if towards < 0.0 {
                -32
            } else {
                0
            };
            assert_eq!(steps, right, "floats along axis {axis}: {what}");
        }
    }
}

#[test]
#[ignore = "an exercise for you"]
fn exercise_1() {
    check_1(exercises::with_offset_by);
}

#[test]
#[ignore = "an exercise for you"]
fn exercise_5() {
    check_5(exercises::with_steps_of_floats);
}

#[test]
fn the_exercises_are_judged_rightly() {
    let source = include_str!("../../chapters/10-shadow-acne/src/exercises.rs");
    judge(source, "with_offset_by", exercise_1, || {
        check_1(solutions::with_offset_by);
    });
    judge(source, "with_steps_of_floats", exercise_5, || {
        check_5(solutions::with_steps_of_floats);
    });
    assert!(hits().len() > 300);
}

fn planet_by(scale: f32, spawn: SpawnRay) -> Picture {
    let (scene, camera) = balls_on_a_planet(scale);
    Picture::new(move |pixel| {
        let ray = from_eye(&scene.objects, camera.eye)(camera.ray(pixel.centre()));
        trace(&scene, &ray, PathBudget::new(MAX_DEPTH), spawn)
    })
}

#[test]
fn the_solutions_are_those_in_the_book() {
    let by_eighth: SpawnRay =
        |at, direction| solutions::with_offset_by(0.125, at, direction);
    let by_1: SpawnRay = |at, direction| solutions::with_offset_by(1.0, at, direction);
    let by_4: SpawnRay = |at, direction| solutions::with_offset_by(4.0, at, direction);
    let by_64: SpawnRay = |at, direction| solutions::with_offset_by(64.0, at, direction);
    let by_4096: SpawnRay =
        |at, direction| solutions::with_offset_by(4096.0, at, direction);
    check_solution(&STAGE, "exercise-1", &planet_by(1.0, by_4096));
    let steps = solutions::with_steps_of_floats;
    check_solution(&STAGE, "exercise-5", &planet_by(1000.0, steps));

    let mut numbers = Numbers::default();
    let levels = |scale: f32, spawn: SpawnRay| {
        let picture = planet_by(scale, spawn);
        let light = Pixel::all(SMALL).map(|pixel| encode(picture.radiance(pixel)));
        light.collect::<Vec<_>>()
    };
    let scales = [1e-3, 1.0, 1000.0];
    let right = scales.map(|scale| levels(scale, from_surface));
    let wrong = |spawn: SpawnRay| {
        let mut right = right.iter();
        scales.map(|scale| {
            let pairs = levels(scale, spawn)
                .into_iter()
                .zip(right.next().expect("one each"));
            let wrong = pairs.filter(|(yours, right)| yours != *right).count();
            with_separators(wrong as u64)
        })
    };
    let row = |name: &str, spawn: SpawnRay| {
        let [small, one, large] = wrong(spawn);
        [name.to_string(), small, one, large]
    };
    let factors = [
        ("1/8", by_eighth),
        ("1", by_1),
        ("4", by_4),
        ("64", by_64),
        ("4096", by_4096),
    ];
    numbers.note(
        "factors",
        table(factors.map(|(name, spawn)| row(name, spawn))),
    );
    numbers.note("steps", table([row("32 floats", steps)]));
    numbers.check("10-shadow-acne-exercises");
}
