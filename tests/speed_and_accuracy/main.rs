//! The cost and the error of each method: the maps, the tables and the charts.

mod charts;
mod check;
mod exercises;
#[path = "../benches/peers/found.rs"]
mod found;
mod lanes;
mod maps;
mod peers;
#[path = "../benches/studies/plot.rs"]
mod plot;
mod solutions;
mod studies;
mod tables;
#[path = "../benches/peers/tinyraytracer.rs"]
mod tinyraytracer;

#[test]
fn every_picture_is_the_one_in_the_book() {
    harness::check_pictures(&speed_and_accuracy::STAGE);
}

#[test]
fn a_picture_does_not_depend_on_the_number_of_threads() {
    harness::check_threads(&speed_and_accuracy::STAGE);
}
