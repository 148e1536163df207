//! The numbers that the chapter's page quotes. They guard the page, not the truth: the code
//! under test has written them.

use ::canvas::{Pixel, STAGE, decode, encode};
use glam::Vec3;
use harness::{HERO, Numbers, SMALL, percent, render, table, vector};

#[test]
fn the_numbers_are_those_in_the_book() {
    let mut numbers = Numbers::default();
    let level = |linear| encode(Vec3::splat(linear))[0];
    numbers.note("half", level(0.5));
    let is_dark = |&level: &u8| decode(level) < 0.1;
    numbers.note("levels-below-a-tenth", (0..=255).filter(is_dark).count());
    let lights = [0.0, 0.003_130_8, 0.1, 0.25, 0.5, 0.75, 1.0];
    numbers.note(
        "levels",
        table(lights.map(|linear: f32| [linear.to_string(), level(linear).to_string()])),
    );
    let corner = |x, y| vector(&Pixel { x, y, size: HERO }.centre().to_array());
    numbers.note(
        "corners",
        format!("{} and {}", corner(0, 0), corner(799, 599)),
    );
    let right = render(&STAGE, "half-light", SMALL).radiance[SMALL.x as usize - 1];
    assert_eq!(encode(right), [128; 3]);
    numbers.note("light-of-128", percent((1e6 * right.x) as usize, 1_000_000));
    numbers.note(
        "truncated",
        (0..=255).filter(|&level| changes(level)).count(),
    );
    numbers.check(STAGE.name);
}

/// Returns whether a level, decoded to linear light in f32, is encoded to another one by the
/// formula if that is truncated instead of rounded.
#[expect(clippy::disallowed_methods, reason = "the definition, in f64")]
fn changes(level: u8) -> bool {
    let encoded = f64::from(level) / 255.0;
    let linear = if level <= 10 {
        encoded / 12.92
    } else {
        ((encoded + 0.055) / 1.055).powf(2.4)
    };
    (oracle::level(f64::from(linear as f32)) as u8) != level
}
