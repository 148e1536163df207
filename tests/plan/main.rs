//! The tests of the chapter `plan`: its pictures, laws and numbers.

#[path = "../speed_and_accuracy/check.rs"]
mod check;
mod exercises;
mod laws;
mod numbers;
#[path = "../benches/studies/plot.rs"]
mod plot;
mod solutions;
mod study;

use ::plan::study::plan;
use ::plan::{Plan, STAGE};
use canvas::Picture;
use glam::UVec2;
use measure::scenes::Model;
use ray_casting::Camera;

#[test]
fn every_picture_is_the_one_in_the_book() {
    harness::check_pictures(&STAGE);
}

#[test]
fn the_bits_are_the_same_on_1_2_and_7_threads() {
    harness::check_threads(&STAGE);
}

const SIZE: UVec2 = UVec2::new(160, 120);
const PIXELS: usize = 160 * 120;

/// Returns the picture of a scene by its plan, but with one sample per pixel, in its centre.
fn at_centres(plan: Plan, camera: Camera) -> Picture {
    Picture::new(move |pixel| plan.trace(camera.ray(pixel.centre())).radiance)
}

/// Returns the plan for a scene and half a level.
fn half_a_level(model: &Model) -> Plan {
    plan(model.clone(), 0.5)
}
