//! The numbers that the chapter's page quotes. They guard the page, not the truth: the code
//! under test has written them.

use ::shadow_acne::STAGE as LAST_STAGE;
use ::transparency::scene::AMBER;
use ::transparency::{STAGE, transmittance};
use canvas::Stage;
use glam::Vec3;
use harness::{
    HERO, Numbers, chapter, render, render_at, table, three_digits, with_separators,
};

#[test]
fn the_numbers_are_those_in_the_book() {
    let mut numbers = Numbers::default();
    let lengths = [0.1, 0.5, 1.2, 2.4];
    numbers.note(
        "transmittance",
        table(lengths.map(|length: f32| {
            let [red, green, blue] = transmittance(AMBER, length).to_array();
            [length, red, green, blue].map(|x| three_digits(f64::from(x)))
        })),
    );
    // On the floor, in the ball's shadow.
    let (x, y) = (610, 405);
    numbers.note("shadow-pixel", format!("({x}, {y})"));
    let levels = |stage: &Stage| {
        let canvas = render(stage, "still-life", HERO);
        let [red, green, blue] = canvas.levels[(y * HERO.x + x) as usize];
        format!("{red}, {green}, {blue}")
    };
    numbers.note("shadow-levels", levels(&STAGE));
    numbers.note("shadow-levels-before", levels(&LAST_STAGE));
    let row = |name: String, rays: u64| [name, with_separators(rays)];
    let before = render(&LAST_STAGE, "still-life", HERO).rays;
    let mut rows = vec![row(chapter(&LAST_STAGE), before)];
    for absorption in [0.0, 1.0, 4.0] {
        let rays = render_at(&STAGE, "still-life", absorption, HERO).rays;
        rows.push(row(format!("absorption {absorption}"), rays));
    }
    numbers.note("rays", table(rows));
    numbers.note("exp-error", exp_error());
    numbers.check(STAGE.name);
}

/// Returns the greatest relative error of the exponential, for transmittances that are not quite
/// black.
#[expect(clippy::disallowed_methods, reason = "f64 is the reference")]
fn exp_error() -> String {
    let errors = (0..100_000).map(|i| {
        let length = i as f32 / 10_000.0;
        let exact = (-f64::from(length)).exp();
        (f64::from(transmittance(Vec3::ONE, length).x) / exact - 1.0).abs()
    });
    three_digits(errors.fold(0.0, f64::max))
}
