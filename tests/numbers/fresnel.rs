use super::*;
use ::fresnel::{STAGE, fresnel, schlick};

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
    numbers.note("rays", paint(&STAGE, "still-life", HERO).rays);
    let before = paint(&::refraction::STAGE, "glass", HERO).rays;
    numbers.note("rays-of-chapter-7", before);
    numbers.check("08-fresnel");
}
