use super::*;
use ::canvas::{Pixel, decode, encode};

#[test]
fn the_numbers_are_those_in_the_book() {
    let mut numbers = Numbers::default();
    let level = |light| encode(Vec3::splat(light))[0];
    numbers.note("half", level(0.5));
    let is_dark = |&level: &u8| decode(level) < 0.1;
    numbers.note("levels-below-a-tenth", (0..=255).filter(is_dark).count());
    let lights = [0.0, 0.003_130_8, 0.1, 0.25, 0.5, 0.75, 1.0];
    numbers.note(
        "levels",
        table(lights.map(|light: f32| [light.to_string(), level(light).to_string()])),
    );
    let corner = |x, y| vector(&Pixel { x, y, size: HERO }.centre().to_array());
    numbers.note(
        "corners",
        format!("{} and {}", corner(0, 0), corner(799, 599)),
    );
    let stage = &::canvas::STAGE;
    let right = paint(stage, "half-light", SMALL).light[SMALL.x as usize - 1];
    assert_eq!(encode(right), [128; 3]);
    numbers.note("light-of-128", percent((1e6 * right.x) as usize, 1_000_000));
    numbers.note(
        "truncated",
        (0..=255).filter(|&level| changes(level)).count(),
    );
    numbers.check("00-canvas");
}

/// Whether a level, decoded to linear f32 light and encoded again, changes if it is not rounded.
#[expect(clippy::disallowed_methods, reason = "f64 is the judge here")]
fn changes(level: u8) -> bool {
    let encoded = f64::from(level) / 255.0;
    let light = if level <= 10 {
        encoded / 12.92
    } else {
        ((encoded + 0.055) / 1.055).powf(2.4)
    };
    let light = f64::from(light as f32);
    let again = if level <= 10 {
        12.92 * light
    } else {
        1.055 * light.powf(1.0 / 2.4) - 0.055
    };
    (255.0 * again) as u8 != level
}
