//! The numbers that the chapter's page quotes. They guard the page, not the truth: the code
//! under test has written them.

use ::fresnel::{STAGE, fresnel, schlick};
use harness::{HERO, Numbers, chapter, render, table, with_separators};

#[test]
#[expect(clippy::disallowed_methods, reason = "no pixel depends on it")]
fn the_numbers_are_those_in_the_book() {
    let mut numbers = Numbers::default();
    let angles = [0.0, 30.0, 45.0, 56.31, 60.0, 80.0, 89.0_f32];
    numbers.note(
        "angles",
        table(angles.map(|angle| {
            let cos_theta_i = angle.to_radians().cos();
            [
                format!("{angle}°"),
                format!("{:.4}", fresnel(cos_theta_i, 1.0, 1.5)),
                format!("{:.4}", schlick(cos_theta_i, 1.0, 1.5)),
            ]
        })),
    );
    let rays = render(&STAGE, "still-life", HERO).rays;
    numbers.note("rays", with_separators(rays));
    let before = &::refraction::STAGE;
    let anchor = format!("rays-of-{}", chapter(before).replace(' ', "-"));
    let rays = render(before, "glass", HERO).rays;
    numbers.note(&anchor, with_separators(rays));
    numbers.check(STAGE.name);
}
