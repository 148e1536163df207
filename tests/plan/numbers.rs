//! The numbers that the chapter's page quotes. They guard the page, not the truth: the code
//! under test has written them.

use crate::{at_centres, half_a_level};
use ::plan::STAGE;
use canvas::{Canvas, decode};
use glam::UVec2;
use harness::{Numbers, table, three_digits, with_separators};
use measure::scenes::{SCENES, scene};

#[test]
fn the_plans_are_those_in_the_book() {
    let names = ["flat", "facing-mirrors", "planet", "still-life"];
    let rows = names.map(|name| {
        let plan = half_a_level(&scene(name).0);
        let skipped = |level| {
            let tolerance = plan.tolerance * (decode(level) - decode(level - 1));
            three_digits((tolerance / plan.max_radiance).into())
        };
        let radiance = format!("{:.2}", plan.max_radiance);
        [name.to_string(), radiance, skipped(1), skipped(255)]
    });
    let mut numbers = Numbers::default();
    numbers.note("plans", table(rows));
    numbers.check(&format!("{}-plans", STAGE.name));
}

/// The exact counts, by which a change of cost shows.
#[test]
fn the_rays_are_those_in_the_book() {
    // Large enough for a change to show, small enough for 1,024 samples.
    let size = UVec2::new(32, 24);
    let rows = SCENES.map(|scene| {
        let (model, camera) = (scene.make)();
        let plan = half_a_level(&model);
        let pictures = [at_centres(plan.clone(), camera), plan.picture(camera)];
        let [centres, planned] =
            pictures.map(|picture| with_separators(Canvas::render(&picture, size).rays));
        [scene.name.to_string(), centres, planned]
    });
    let mut numbers = Numbers::default();
    numbers.note("plans", table(rows));
    numbers.check(&format!("{}-rays", STAGE.name));
}
