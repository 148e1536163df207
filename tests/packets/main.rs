//! The tests of the chapter `packets`: its pictures, laws and numbers.

mod exercises;
mod laws;
mod solutions;

use ::packets::STAGE;

#[test]
fn every_picture_is_the_one_in_the_book() {
    harness::check_pictures(&STAGE);
}

#[test]
fn the_bits_are_the_same_on_1_2_and_7_threads() {
    harness::check_threads(&STAGE);
}
