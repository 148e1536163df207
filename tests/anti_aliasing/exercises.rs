//! The exercises' checks. Yours are judged by name:
//! `cargo test --test anti_aliasing exercise_1 -- --ignored`.

use crate::solutions;
use ::anti_aliasing::scene::horizon_radiance;
use ::anti_aliasing::{STAGE, Sampler, exercises, jittered, regular};
use ::canvas::{Picture, Pixel};
use ::ray_casting::SKY;
use glam::{UVec2, Vec2, Vec3};
use harness::{SMALL, assert_close, check_solution, judge};

/// Returns white where a condition holds, and black elsewhere.
fn white_if(condition: bool) -> Vec3 {
    Vec3::splat(f32::from(condition))
}

fn check_1(filter: Sampler) {
    const N: u32 = 16;
    let (x, y, size) = (100, 80, SMALL);
    let pixel = Pixel { x, y, size };
    let centre = pixel.centre();
    // A radiance by the distance from the pixel's centre, in pixels.
    let filtered = |radiance: fn(Vec2) -> Vec3| {
        filter(pixel, N, &|point| {
            radiance((point - centre) / pixel.footprint())
        })
    };
    assert_close("the same light everywhere", filtered(|_| SKY), SKY);
    let slope = filtered(|at| SKY + 0.2 * (at.x - at.y));
    assert!(
        (slope - SKY).length() < 1e-3,
        "an even slope: yours is {slope}, right is {SKY}"
    );
    // The light to one side of the centre, by where its edge is: the integral of a triangle.
    for edge in [-0.75_f32, -0.5, 0.0, 0.25, 0.5, 0.875, 1.0] {
        let beyond = 1.0 - edge.abs();
        let tail = beyond * beyond / 2.0;
        let right = if edge < 0.0 { 1.0 - tail } else { tail };
        for direction in [Vec2::X, Vec2::NEG_X, Vec2::Y, Vec2::NEG_Y] {
            let yours = filter(pixel, N, &|point| {
                let at = (point - centre) / pixel.footprint();
                white_if(at.dot(direction) > edge)
            });
            assert!(
                (yours.x - right).abs() < 0.02,
                "light beyond {edge} pixels along {direction}: yours is {}, right is {right}",
                yours.x
            );
        }
    }
}

fn check_3(half_jittered: Sampler) {
    // A light that differs at every point.
    let radiance = |point: Vec2| Vec3::new(point.x, point.y, point.x * point.y);
    for pixel in Pixel::all(UVec2::new(16, 8)) {
        let sampler = if pixel.x < 8 { regular } else { jittered };
        let right = sampler(pixel, 3, &radiance);
        assert_close(
            &format!("{pixel:?}"),
            half_jittered(pixel, 3, &radiance),
            right,
        );
    }
}

/// The function that takes samples in space and time.
type InMotion = fn(Pixel, u32, &dyn Fn(Vec2, f32) -> Vec3) -> Vec3;

fn check_4(in_motion: InMotion) {
    // The mean over many pixels.
    let size = UVec2::new(20, 15);
    let mean = |radiance: &dyn Fn(Pixel, Vec2, f32) -> Vec3| {
        let pixels = Pixel::all(size);
        let sum: Vec3 = pixels
            .map(|pixel| in_motion(pixel, 8, &|point, time| radiance(pixel, point, time)))
            .sum();
        sum.x / (size.x * size.y) as f32
    };
    let near = |what: &str, yours: f32, right: f32| {
        assert!(
            (yours - right).abs() < 0.07,
            "{what}: yours is {yours}, right is {right}"
        );
    };
    for hour in [0.25, 0.5, 0.75] {
        let lit = mean(&|_, _, time| white_if(time < hour));
        near(&format!("a lamp that goes out at {hour}"), lit, hour);
    }
    let within = mean(&|_, _, time| white_if((0.0..=1.0).contains(&time)));
    near("the times from 0 to 1", within, 1.0);
    let upper = mean(&|pixel, point, _| white_if(point.y > pixel.centre().y));
    near("the upper half of each pixel", upper, 0.5);
    for direction in [Vec2::X, Vec2::Y] {
        let both = mean(&|pixel, point, time| {
            white_if((point - pixel.centre()).dot(direction) > 0.0 && time < 0.5)
        });
        near(
            &format!("half of the pixel ({direction}), half of the time"),
            both,
            0.25,
        );
    }
    for pixel in Pixel::all(size) {
        let early = in_motion(pixel, 8, &|_, time| white_if(time < 0.5)).x;
        let fills = (0.2..=0.8).contains(&early);
        assert!(
            fills,
            "{early} of the times of {pixel:?} are in the first half"
        );
    }
    let still = |point: Vec2, _: f32| Vec3::new(point.x, point.y, 0.0);
    for pixel in Pixel::all(UVec2::new(8, 6)) {
        let yours = in_motion(pixel, 8, &still).truncate();
        let error = (yours - pixel.centre()).length() / pixel.footprint();
        assert!(
            error < 0.2,
            "a still world: the mean is {error} pixels away"
        );
    }
}

#[test]
#[ignore = "an exercise for you"]
fn exercise_1() {
    check_1(exercises::triangle_filter);
}

#[test]
#[ignore = "an exercise for you"]
fn exercise_3() {
    check_3(exercises::half_jittered);
}

#[test]
#[ignore = "an exercise for you"]
fn exercise_4() {
    check_4(exercises::in_motion);
}

#[test]
fn the_exercises_are_judged_rightly() {
    let source = include_str!("../../chapters/09-anti-aliasing/src/exercises.rs");
    judge(source, "triangle_filter", exercise_1, || {
        check_1(solutions::triangle_filter);
    });
    judge(source, "half_jittered", exercise_3, || {
        check_3(solutions::half_jittered);
    });
    judge(source, "in_motion", exercise_4, || {
        check_4(solutions::in_motion);
    });
}

#[test]
fn the_solutions_are_those_in_the_book() {
    let horizon = |n: u32, sampler: Sampler| {
        let radiance = horizon_radiance();
        Picture::new(move |pixel| sampler(pixel, n, &radiance))
    };
    // As many samples per pixel's area as the other.
    let wide = horizon(16, solutions::triangle_filter);
    check_solution(&STAGE, "exercise-1", &wide);
    check_solution(&STAGE, "exercise-1-box", &horizon(8, regular));
    let half = horizon(4, solutions::half_jittered);
    check_solution(&STAGE, "exercise-3", &half);
    let moving = Picture::new(|pixel| {
        solutions::in_motion(pixel, 8, &|point, time| {
            let ball = Vec2::new(time - 0.5, 0.0);
            let lamp = Vec2::new(0.0, 0.75);
            if point.distance(ball) < 0.4 {
                Vec3::new(0.9, 0.15, 0.1)
            } else if point.distance(lamp) < 0.15 {
                Vec3::ONE
            } else {
                SKY
            }
        })
    });
    check_solution(&STAGE, "exercise-4", &moving);
}
