//! The exercises' checks. Yours are judged by name:
//! `cargo test --test speed_and_accuracy exercise_3 -- --ignored`.

use crate::solutions;
use canvas::{Picture, Pixel};
use fresnel::views::picture_of;
use fresnel::{fresnel, schlick};
use glam::{UVec2, Vec3};
use harness::{
    Numbers, SMALL, check_solution, judge, percent, three_digits, with_separators,
};
use ray_casting::scene::still_life_camera;
use refraction::scene::{AIR, GLASS};
use speed_and_accuracy::error_map::{error_map, level_error};
use speed_and_accuracy::{STAGE, exercises};

fn check_3(map: fn() -> Picture) {
    let camera = still_life_camera();
    let by_fresnel = picture_of(GLASS, AIR, camera, fresnel);
    // A single colour, which a map of no errors has as well: black.
    let none = error_map(
        Picture::new(|_| Vec3::splat(0.5)),
        Picture::new(|_| Vec3::splat(0.5)),
    );
    let yours = map();
    let mut wrong = 0;
    for pixel in Pixel::all(UVec2::new(80, 60)) {
        let by_schlick = picture_of(GLASS, AIR, camera, schlick).radiance(pixel);
        let right = by_fresnel.radiance(pixel);
        let error = level_error(by_schlick, right.as_dvec3());
        let levels = error_map(
            Picture::new(move |_| by_schlick),
            Picture::new(move |_| right),
        );
        let colour = yours.radiance(pixel);
        assert_eq!(colour, levels.radiance(pixel), "{pixel:?}, {error} levels");
        wrong += usize::from(colour != none.radiance(pixel));
    }
    assert!(wrong > 50, "it is black: only {wrong} pixels are not");
}

#[test]
#[ignore = "an exercise for you"]
fn exercise_3() {
    check_3(exercises::map_of_schlick);
}

#[test]
fn the_exercises_are_judged_rightly() {
    let source = include_str!("../../chapters/14-speed-and-accuracy/src/exercises.rs");
    judge(source, "map_of_schlick", exercise_3, || {
        check_3(solutions::map_of_schlick);
    });
}

#[test]
fn the_solutions_are_those_in_the_book() {
    check_solution(&STAGE, "exercise-3", &solutions::map_of_schlick());
    let mut numbers = Numbers::default();
    // Where the square of a distance, in radii, has no digit left for a difference of 1.
    let lost = |epsilon: f64| with_separators((1.0 / epsilon).sqrt().round() as u64);
    numbers.note("lost-in-f32", lost(f64::from(f32::EPSILON)));
    numbers.note("lost-in-f64", lost(f64::EPSILON));
    let view = STAGE.view("bias-error").expect("a view");
    let size = SMALL / 2;
    let any = Pixel { x: 0, y: 0, size };
    // The colour of errors from one level on; that of larger ones is brighter.
    let two_levels = error_map(
        Picture::new(|_| Vec3::splat(canvas::decode(102))),
        Picture::new(|_| Vec3::splat(canvas::decode(100))),
    );
    let limit = two_levels.radiance(any).element_sum();
    let wrong = |bias: f32| {
        let map = (view.picture)(bias);
        let is_wrong = |pixel: &Pixel| map.radiance(*pixel).element_sum() >= 0.99 * limit;
        Pixel::all(size).filter(is_wrong).count()
    };
    let biases = [1e-5, 1e-4, 1e-3, 1e-2, 1e-1].map(|bias: f32| {
        [
            three_digits(f64::from(bias)),
            percent(wrong(bias), (size.x * size.y) as usize),
        ]
    });
    numbers.note("biases", harness::table(biases));
    numbers.check("14-speed-and-accuracy-exercises");
}
