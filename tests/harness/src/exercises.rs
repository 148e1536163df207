//! Exercises: their checks, and what the checks say.

use canvas::{Canvas, Picture, Stage};
use glam::Vec3;
use std::panic::{AssertUnwindSafe, catch_unwind};

use crate::SMALL;
use crate::snapshots::check_picture_in;

/// What the body of an exercise's function begins with, until a reader has written it.
const UNSOLVED: &str = "// Yours to write.";

/// Checks that an exercise's check passes on the book's solution, and fails on the function
/// with this name in the chapter's `source`, as long as nobody has written that.
///
/// # Panics
/// If it does not, or if the source has no such function.
pub fn judge(source: &str, name: &str, yours: impl FnOnce(), solution: impl FnOnce()) {
    solution();
    let (_, body) = source
        .split_once(&format!("pub fn {name}("))
        .unwrap_or_else(|| panic!("there is no exercise {name}"));
    let body = body.split("pub fn ").next().unwrap_or_default();
    if body.contains(UNSOLVED) {
        let passes = catch_unwind(AssertUnwindSafe(yours)).is_ok();
        assert!(
            !passes,
            "the check of {name} passes: if you have written it, delete the line {UNSOLVED:?}"
        );
    }
}

/// Checks that a colour or a vector is the right one, up to rounding: to a hundred-thousandth
/// of its length, or of 1 if that is more.
///
/// # Panics
/// If it is not; the message says `what` it is, and both.
pub fn assert_close(what: &str, yours: Vec3, right: Vec3) {
    let tolerance = 1e-5 * (1.0 + right.length());
    assert!(
        (yours - right).length() <= tolerance,
        "{what}: yours is {yours}, right is {right}"
    );
}

/// Compares the picture of a chapter's solution with the one in the book.
///
/// # Panics
/// If they differ.
pub fn check_solution(stage: &Stage, exercise: &str, picture: &Picture) {
    let name = format!("{}--{exercise}", stage.name);
    let rendering = Canvas::render(picture, SMALL);
    if let Err(complaint) = check_picture_in("solutions", &name, &rendering) {
        panic!(
            "\n{name}: {complaint}{}",
            crate::snapshots::advice("book/src/pictures/solutions")
        );
    }
}
