//! The tests of the chapter `refraction`: its pictures, laws and numbers.

mod agreement;
mod critical;
mod exercises;
mod laws;
mod numbers;
mod solutions;

use ::refraction::STAGE;

#[test]
fn every_picture_is_the_one_in_the_book() {
    harness::check_pictures(&STAGE);
}

#[test]
fn the_bits_are_the_same_on_1_2_and_7_threads() {
    harness::check_threads(&STAGE);
}
