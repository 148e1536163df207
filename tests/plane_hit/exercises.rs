//! The exercises' checks. Yours are judged by name:
//! `cargo test --test plane_hit exercise_1 -- --ignored`.

use crate::solutions;
use ::canvas::{Picture, Pixel};
use ::plane_hit::scene::{STILL_LIFE_COLOURS, still_life};
use ::plane_hit::views::flat;
use ::plane_hit::{Object, Plane, STAGE, Shape, Texture, exercises, nearest, trace};
use ::ray_casting::SKY;
use ::ray_casting::scene::still_life_camera;
use ::sphere_hit::T_MAX;
use glam::{Vec2, Vec3};
use harness::{
    HERO, Numbers, SMALL, check_solution, evenly, judge, percent, with_separators,
};

const DARK: Vec3 = Vec3::splat(0.1);
const LIGHT: Vec3 = Vec3::splat(0.9);

fn wall() -> Plane {
    Plane::new(8.0 * Vec3::Z, Vec3::NEG_Z).expect("a plane")
}

/// A wall that leans back, and to the side.
fn tilted_wall() -> Plane {
    Plane::new(8.0 * Vec3::Z, Vec3::new(0.3, 0.5, -1.0)).expect("a plane")
}

/// Checks points of a plane in the middle of its squares, as computed for a ray: it may be up
/// to a millionth off the plane.
fn check_1(is_even_on: fn(&Plane, Vec3) -> bool) {
    let point = Vec3::new(0.3, -0.6, 7.9);
    for normal in [Vec3::Y, wall().normal, tilted_wall().normal] {
        let plane = Plane::new(point, normal).expect("a plane");
        for i in 0..1000 {
            let [x, y, off] = evenly(i).map(|x| (2.0 * x - 1.0) as f32);
            let cell = (10.0 * Vec2::new(x, y)).floor();
            let uv = cell + Vec2::new(0.5, 0.5);
            let [u, v] = plane.axes;
            let point = plane.point + uv.x * u + uv.y * v + 1e-6 * off * plane.normal;
            let right = (cell.x + cell.y).rem_euclid(2.0) == 0.0;
            assert_eq!(is_even_on(&plane, point), right, "{point} on {plane:?}");
        }
    }
}

fn check_3(is_even_stripe: fn(Vec2) -> bool, is_even_ring: fn(Vec2) -> bool) {
    for i in 0..1000 {
        let [x, y, _] = evenly(i).map(|x| 20.0 * (2.0 * x - 1.0));
        let uv = Vec2::new(x as f32, y as f32);
        // On an edge, rounding decides.
        let is_clear = |at: f64| (at - at.round()).abs() > 1e-4;
        let is_even = |at: f64| at.floor().rem_euclid(2.0) == 0.0;
        if is_clear(x) {
            assert_eq!(is_even_stripe(uv), is_even(x), "the stripe at {uv}");
        }
        let radius = (x * x + y * y).sqrt();
        if is_clear(radius) {
            assert_eq!(is_even_ring(uv), is_even(radius), "the ring at {uv}");
        }
    }
}

#[test]
#[ignore = "an exercise for you"]
fn exercise_1() {
    check_1(exercises::is_even_on);
}

#[test]
#[ignore = "an exercise for you"]
fn exercise_3() {
    check_3(exercises::is_even_stripe, exercises::is_even_ring);
}

#[test]
fn the_exercises_are_judged_rightly() {
    let source = include_str!("../../chapters/03-plane-hit/src/exercises.rs");
    judge(source, "is_even_on", exercise_1, || {
        check_1(solutions::is_even_on);
    });
    judge(source, "is_even_stripe", exercise_3, || {
        check_3(solutions::is_even_stripe, solutions::is_even_ring);
    });
    judge(
        source,
        "is_even_ring",
        || check_3(solutions::is_even_stripe, exercises::is_even_ring),
        || {},
    );
}

/// The still life before a wall, with the floor's pattern as `is_even_on` has it.
fn before_a_wall(wall: Plane, is_even_on: fn(&Plane, Vec3) -> bool) -> Picture {
    let camera = still_life_camera();
    let mut objects = still_life(STILL_LIFE_COLOURS);
    objects.push(Object {
        name: "wall",
        shape: Shape::Plane(wall),
        material: Texture::Solid(LIGHT),
    });
    let last = objects.len() - 1;
    Picture::new(move |pixel| {
        let ray = camera.ray(pixel.centre());
        match nearest(&objects, &ray) {
            Some((index, t)) if index == last && is_even_on(&wall, ray.at(t)) => DARK,
            _ => trace(&objects, &ray),
        }
    })
}

/// A pattern by two of the world's coordinates, as the exercise begins with.
fn is_even_in_the_world(_: &Plane, point: Vec3) -> bool {
    ::plane_hit::is_even(Vec2::new(point.x, point.z))
}

/// Returns the picture of the last object in a list that each ray hits: what a search finds
/// that forgets `t_max`.
fn picture_of_last(objects: Vec<Object<Texture>>) -> Picture {
    let camera = still_life_camera();
    Picture::new(move |pixel| {
        let ray = camera.ray(pixel.centre());
        let mut hits = objects.iter().filter_map(
            |Object {
                 shape, material, ..
             }| {
                let t = shape.distance(&ray, T_MAX)?;
                Some(material.value(shape.uv(ray.at(t))))
            },
        );
        hits.next_back().unwrap_or(SKY)
    })
}

#[test]
fn the_solutions_are_those_in_the_book() {
    let speckled = before_a_wall(wall(), is_even_in_the_world);
    check_solution(&STAGE, "exercise-1-world", &speckled);
    let clean = before_a_wall(wall(), solutions::is_even_on);
    check_solution(&STAGE, "exercise-1", &clean);
    let tilted = before_a_wall(tilted_wall(), solutions::is_even_on);
    check_solution(&STAGE, "exercise-1-tilted", &tilted);
    let camera = still_life_camera();
    let floor = Plane::new(Vec3::ZERO, Vec3::Y).expect("a plane");
    let rings = Picture::new(move |pixel| {
        let ray = camera.ray(pixel.centre());
        match floor.distance(&ray, T_MAX) {
            Some(t) if solutions::is_even_ring(floor.uv(ray.at(t))) => DARK,
            Some(_) => LIGHT,
            None => SKY,
        }
    });
    check_solution(&STAGE, "exercise-3", &rings);

    let objects = still_life(STILL_LIFE_COLOURS);
    let reversed = objects.iter().cloned().rev().collect();
    let [last, last_reversed] = [objects, reversed].map(picture_of_last);
    check_solution(&STAGE, "exercise-2", &last_reversed);

    let mut numbers = Numbers::default();
    let differing = |a: &Picture, b: &Picture, size| {
        let is_other = |pixel: &Pixel| a.radiance(*pixel) != b.radiance(*pixel);
        Pixel::all(size).filter(is_other).count()
    };
    let wrong = differing(&speckled, &clean, HERO);
    numbers.note("speckles", with_separators(wrong as u64));
    let first = flat(camera);
    let wrong =
        |last| percent(differing(last, &first, SMALL), (SMALL.x * SMALL.y) as usize);
    numbers.note("last", wrong(&last));
    numbers.note("last-reversed", wrong(&last_reversed));
    numbers.check("03-plane-hit-exercises");
}
