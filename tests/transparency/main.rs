//! The tests of the chapter `transparency`: its pictures, laws and numbers.

mod agreement;
mod exercises;
mod faults;
mod laws;
mod numbers;
mod povray;
mod solutions;

use ::transparency::STAGE;

#[test]
fn every_picture_is_the_one_in_the_book() {
    harness::check_pictures(&STAGE);
}

#[test]
fn the_bits_are_the_same_on_1_2_and_7_threads() {
    harness::check_threads(&STAGE);
}
