//! The exercises' checks. Yours are judged by name:
//! `cargo test --test packets exercise_1 -- --ignored`.

use crate::solutions;
use ::canvas::Pixel;
use ::packets::{LANES, Lanes, exercises};
use ::plane_hit::{Shape, nearest};
use ::ray_casting::Ray;
use ::ray_casting::scene::still_life_camera;
use ::refraction::scene::{AIR, GLASS, still_life_with_glass};
use glam::UVec2;
use harness::{Numbers, SMALL, judge, percent, three_digits};

fn check_1(schlick: fn(Lanes, f32, f32) -> Lanes) {
    for (eta_i, eta_t) in [(1.0, 1.5), (1.5, 1.0), (1.0, 2.42), (1.33, 1.33)] {
        for group in 0..8 {
            let cosines = std::array::from_fn(|lane| (16 * group + lane) as f32 / 127.0);
            let yours = schlick(Lanes::new(cosines), eta_i, eta_t).to_array();
            for (yours, cosine) in yours.into_iter().zip(cosines) {
                let right = ::fresnel::schlick(cosine, eta_i, eta_t);
                let what = format!("from {eta_i} to {eta_t}, cosθᵢ = {cosine}");
                assert_eq!(
                    yours.to_bits(),
                    right.to_bits(),
                    "{yours}, not {right}: {what}"
                );
            }
        }
    }
}

fn check_4(place: fn(u32) -> UVec2) {
    let places: Vec<UVec2> = (0..LANES as u32).map(place).collect();
    let rows = (0..4).flat_map(|y| (0..4).map(move |x| UVec2::new(x, y)));
    assert_eq!(places, rows.collect::<Vec<_>>());
}

#[test]
#[ignore = "an exercise for you"]
fn exercise_1() {
    check_1(exercises::schlick);
}

#[test]
#[ignore = "an exercise for you"]
fn exercise_4() {
    check_4(exercises::place_in_square);
}

#[test]
fn the_exercises_are_judged_rightly() {
    let source = include_str!("../../chapters/12-packets/src/exercises.rs");
    judge(source, "schlick", exercise_1, || {
        check_1(solutions::schlick)
    });
    judge(source, "place_in_square", exercise_4, || {
        check_4(solutions::place_in_square);
    });
}

/// Returns the camera rays of the still life's packets; the lanes of each are at these places
/// from its first pixel, and the packets are so far apart.
fn packets(place: impl Fn(u32) -> UVec2, apart: UVec2) -> Vec<Vec<Ray>> {
    let camera = still_life_camera();
    let corners =
        Pixel::all(SMALL / apart).map(|pixel| UVec2::new(pixel.x, pixel.y) * apart);
    let rays = |corner: UVec2| {
        let ray = |lane| {
            let UVec2 { x, y } = corner + place(lane);
            camera.ray(Pixel { x, y, size: SMALL }.centre())
        };
        (0..LANES as u32).map(ray).collect()
    };
    corners.map(rays).collect()
}

#[test]
fn the_solutions_are_those_in_the_book() {
    let scene = still_life_with_glass(GLASS, AIR);
    let mut numbers = Numbers::default();
    let rows = packets(|lane| UVec2::new(lane, 0), UVec2::new(16, 1));
    let squares = packets(solutions::place_in_square, UVec2::new(4, 4));
    for (anchor, packets) in [("in-rows", &rows), ("in-squares", &squares)] {
        let objects = packets.iter().map(|rays| {
            let hits = rays
                .iter()
                .map(|ray| nearest(&scene.objects, ray).map(|hit| hit.0));
            let mut hits: Vec<_> = hits.collect();
            hits.sort_unstable();
            hits.dedup();
            hits.len()
        });
        let mean = objects.sum::<usize>() as f64 / packets.len() as f64;
        numbers.note(anchor, three_digits(mean));
    }
    // Where `sphere_distance` ends for the camera's packets.
    let [mut surely, mut after_all, mut tests] = [0; 3];
    let spheres = scene
        .objects
        .iter()
        .filter_map(|object| match object.shape {
            Shape::Sphere(sphere) => Some(sphere),
            Shape::Plane(_) => None,
        });
    for sphere in spheres {
        for rays in &rows {
            let may_hit = |ray: &Ray| {
                let oc = ray.origin - sphere.centre;
                let b = ray.direction.dot(oc);
                b * b >= 0.99999 * oc.dot(oc) - sphere.radius * sphere.radius
            };
            let hits = |ray: &Ray| sphere.distance(ray, f32::INFINITY).is_some();
            tests += 1;
            if !rays.iter().any(may_hit) {
                surely += 1;
            } else if !rays.iter().any(hits) {
                after_all += 1;
            }
        }
    }
    numbers.note("first-if", percent(surely, tests));
    numbers.note("second-if", percent(after_all, tests));
    let head_on = solutions::schlick(Lanes::splat(1.0), AIR, GLASS).to_array()[0];
    numbers.note("head-on", format!("{head_on:.2}"));
    numbers.check("12-packets-exercises");
}
