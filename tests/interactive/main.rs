//! The tests of the chapter `interactive`, without its window: its pictures, the pose of its
//! camera, its frames and their thread; what is explained of a ray, and where it is drawn.

mod exercises;
mod explain;
mod overlay;
mod render_thread;
mod solutions;
mod walk;

use ::interactive::STAGE;

#[test]
fn every_picture_is_the_one_in_the_book() {
    harness::check_pictures(&STAGE);
}

#[test]
fn the_bits_are_the_same_on_1_2_and_7_threads() {
    harness::check_threads(&STAGE);
}
