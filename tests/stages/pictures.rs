//! The pictures of all chapters: for other profiles and processors. `cargo test` compares them chapter by chapter.
//!
//! `PICTURES_WITHOUT=plan,packets` leaves out chapters whose name holds one of these words.

use stages::STAGES;

#[test]
fn every_picture_is_the_one_in_the_book() {
    let left_out = std::env::var("PICTURES_WITHOUT").unwrap_or_default();
    let is_left_out = |name: &str| {
        let mut words = left_out.split(',').filter(|word| !word.is_empty());
        words.any(|word| name.contains(word))
    };
    for stage in STAGES.iter().filter(|stage| !is_left_out(stage.name)) {
        harness::check_pictures(stage);
    }
}
