//! The exercises' checks. Yours are judged by name:
//! `cargo test --test canvas exercise_1 -- --ignored`.

use crate::solutions;
use ::canvas::{Picture, Pixel, STAGE, exercises};
use glam::{UVec2, Vec3};
use harness::{Numbers, SMALL, assert_close, check_solution, judge};

const SIZES: [UVec2; 3] = [SMALL, UVec2::new(80, 60), UVec2::new(31, 77)];

fn check_1(glow: fn(Pixel) -> Vec3) {
    let gradient = (STAGE.hero().picture)(0.0);
    for pixel in SIZES.into_iter().flat_map(Pixel::all) {
        let blue = pixel.centre().length();
        let right = gradient.radiance(pixel).with_z(blue);
        assert_close(&format!("{pixel:?}"), glow(pixel), right);
    }
}

fn check_2(of_pixels: fn(Pixel) -> Vec3, of_the_plane: fn(Pixel) -> Vec3) {
    let is_even = |sum: f64| sum.rem_euclid(2.0) == 0.0;
    for pixel in SIZES.into_iter().flat_map(Pixel::all) {
        let square = f64::from(pixel.x / 8) + f64::from(pixel.y / 8);
        let right = Vec3::splat(f32::from(is_even(square)));
        assert_eq!(of_pixels(pixel), right, "{pixel:?}, squares of pixels");

        let place = pixel.centre().as_dvec2() * 10.0;
        let from_edge = (place - place.round()).abs().min_element();
        // On an edge, rounding decides.
        if from_edge > 1e-4 {
            let square = place.floor().element_sum();
            let right = Vec3::splat(f32::from(is_even(square)));
            let yours = of_the_plane(pixel);
            assert_eq!(yours, right, "{pixel:?}, squares of the image plane");
        }
    }
}

fn check_3(shrink: fn([[u8; 3]; 4]) -> [u8; 3]) {
    for level in 0..=255 {
        let four = [[level, 255 - level, 0]; 4];
        assert_eq!(shrink(four), four[0], "four pixels that are the same");
    }
    let [black, white] = [[0; 3], [255; 3]];
    let half = shrink([white, black, black, white]);
    assert_eq!(half, [188; 3], "half the light of white");
    let quarter = shrink([black, white, black, black]);
    assert_eq!(quarter, [137; 3], "a quarter of the light of white");
    let mixed = shrink([[255, 0, 0], [0, 255, 0], [0; 3], [0; 3]]);
    assert_eq!(mixed, [137, 137, 0], "channel by channel");
}

#[test]
#[ignore = "an exercise for you"]
fn exercise_1() {
    check_1(exercises::glow);
}

#[test]
#[ignore = "an exercise for you"]
fn exercise_2() {
    check_2(
        exercises::squares_of_pixels,
        exercises::squares_of_the_plane,
    );
}

#[test]
#[ignore = "an exercise for you"]
fn exercise_3() {
    check_3(exercises::shrink);
}

#[test]
fn the_exercises_are_judged_rightly() {
    let source = include_str!("../../chapters/00-canvas/src/exercises.rs");
    judge(source, "glow", exercise_1, || check_1(solutions::glow));
    judge(source, "squares_of_pixels", exercise_2, || {
        check_2(
            solutions::squares_of_pixels,
            solutions::squares_of_the_plane,
        );
    });
    // One right half is not enough.
    judge(
        source,
        "squares_of_the_plane",
        || {
            check_2(
                solutions::squares_of_pixels,
                exercises::squares_of_the_plane,
            )
        },
        || {},
    );
    judge(source, "shrink", exercise_3, || check_3(solutions::shrink));
}

#[test]
fn the_solutions_are_those_in_the_book() {
    let picture = |radiance: fn(Pixel) -> Vec3| Picture::new(radiance);
    check_solution(&STAGE, "exercise-1", &picture(solutions::glow));
    let squares = picture(solutions::squares_of_the_plane);
    check_solution(&STAGE, "exercise-2", &squares);

    let mut numbers = Numbers::default();
    let [black, white] = [[0; 3], [255; 3]];
    let half = [white, black, black, white];
    numbers.note("half", solutions::shrink(half)[0]);
    let of_levels: u32 = half.iter().map(|levels| u32::from(levels[0])).sum();
    numbers.note("half-of-levels", of_levels / 4);
    let one = Pixel {
        x: 0,
        y: 0,
        size: UVec2::ONE,
    };
    numbers.note("centre", harness::vector(&one.centre().to_array()));
    numbers.note("footprint", one.footprint());
    numbers.check("00-canvas-exercises");
}
