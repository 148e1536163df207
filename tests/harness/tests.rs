//! The harness can fail: each of its checks, given something that is almost right.

use canvas::{Knob, Picture, STAGE, Scale, Stage, View};
use glam::Vec3;
use harness::{Numbers, check_pictures, check_solution, check_threads, judge};
use std::hash::{DefaultHasher, Hash, Hasher};
use std::process::Command;
use std::thread;

/// The canvas's first picture, but for one pixel that is a level too blue.
fn one_pixel_off() -> Picture {
    let right = (STAGE.hero().picture)(0.0);
    Picture::new(move |pixel| {
        let radiance = right.radiance(pixel);
        if (pixel.x, pixel.y) == (3, 5) {
            radiance + 0.004 * Vec3::Z
        } else {
            radiance
        }
    })
}

fn stage(views: &'static [View]) -> Stage {
    Stage {
        hero: "gradient",
        views,
        ..STAGE
    }
}

#[test]
fn a_picture_is_checked_that_is_right() {
    check_pictures(&STAGE);
    check_threads(&STAGE);
}

#[test]
#[should_panic = "1 of 480000 pixels differ"]
fn a_pixel_that_is_a_level_off_is_seen() {
    check_pictures(&stage(&[View {
        name: "gradient",
        caption: "",
        knob: None,
        picture: |_| one_pixel_off(),
    }]));
}

#[test]
#[should_panic = "the book has no such picture yet"]
fn a_solutions_picture_that_the_book_has_not_is_seen() {
    check_solution(&STAGE, "exercise-0", &one_pixel_off());
}

/// What a reader starts with, and what one has written.
const EXERCISES: &str = "
pub fn unsolved() -> u32 {
    // Yours to write.
    0
}

pub fn solved() -> u32 {
    1
}";

#[test]
fn an_exercise_is_judged_that_is_red_unsolved_and_green_solved() {
    judge(EXERCISES, "unsolved", || panic!("red"), || {});
    // Nobody is told that a reader's own solution is right, or wrong.
    judge(EXERCISES, "solved", || {}, || {});
    judge(EXERCISES, "solved", || panic!("red"), || {});
}

#[test]
#[should_panic = "the check of unsolved passes"]
fn a_check_that_lets_the_unsolved_exercise_pass_is_seen() {
    judge(EXERCISES, "unsolved", || {}, || {});
}

#[test]
#[should_panic = "green is red"]
fn a_check_that_rejects_the_solution_is_seen() {
    judge(
        EXERCISES,
        "unsolved",
        || panic!("red"),
        || panic!("green is red"),
    );
}

#[test]
#[should_panic = "there is no exercise nonsense"]
fn an_exercise_that_is_not_there_is_seen() {
    judge(EXERCISES, "nonsense", || panic!("red"), || {});
}

#[test]
#[should_panic = "the book has no such picture yet"]
fn a_picture_that_the_book_has_not_is_seen_at_every_setting() {
    check_pictures(&stage(&[View {
        name: "gradient",
        caption: "",
        knob: Some(Knob {
            name: "",
            unit: "",
            min: 0.0,
            max: 1.0,
            default: 0.0,
            scale: Scale::Whole,
            snapshot_settings: &[1.0],
        }),
        picture: |_| (STAGE.hero().picture)(0.0),
    }]));
}

#[test]
#[should_panic = "assertion `left == right` failed"]
fn a_picture_that_depends_on_its_thread_is_seen() {
    check_threads(&stage(&[View {
        name: "gradient",
        caption: "",
        knob: None,
        picture: |_| {
            Picture::new(|_| {
                let mut hasher = DefaultHasher::new();
                thread::current().id().hash(&mut hasher);
                Vec3::splat((hasher.finish() % 1000) as f32)
            })
        },
    }]));
}

#[test]
#[should_panic = "the numbers are not those of 00-canvas"]
fn a_number_that_is_not_the_books_is_seen() {
    let mut numbers = Numbers::default();
    numbers.note("levels", "another number");
    numbers.check(STAGE.name);
}

/// Runs another of these tests, and returns all that it says.
fn said_by(test: &str) -> String {
    let program = std::env::current_exe().expect("the test's own path");
    let arguments = ["--exact", test, "--nocapture"];
    let output = Command::new(program).args(arguments).output();
    let output = output.expect("the test runs");
    let bytes = [output.stdout, output.stderr].concat();
    String::from_utf8(bytes).expect("UTF-8")
}

#[test]
fn what_differs_is_shown_with_advice_that_works() {
    for (test, words) in [
        (
            "a_number_that_is_not_the_books_is_seen",
            "+another number\n",
        ),
        (
            "a_pixel_that_is_a_level_off_is_seen",
            "1 of 480000 pixels differ",
        ),
        (
            "a_picture_that_the_book_has_not_is_seen_at_every_setting",
            "no such picture yet",
        ),
    ] {
        let said = said_by(test);
        let advice = format!(
            "INSTA_UPDATE=always cargo test --test {}\n",
            env!("CARGO_CRATE_NAME")
        );
        assert!(said.contains(words) && said.contains(&advice), "{said}");
        // Nobody needs it, and it would find nothing.
        assert!(!said.contains("cargo insta"), "{said}");
    }
}
