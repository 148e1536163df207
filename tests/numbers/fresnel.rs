use super::*;
use ::fresnel::{Reflectance, STAGE, fresnel, schlick};

/// The shares that are mirrored at each border, by f64 and the definition.
fn exactly(cos_theta_i: f64, eta_i: f64, eta_t: f64) -> f64 {
    let eta = eta_i / eta_t;
    let sin2_theta_t = eta * eta * (1.0 - cos_theta_i * cos_theta_i);
    if sin2_theta_t >= 1.0 {
        return 1.0;
    }
    let cos_theta_t = (1.0 - sin2_theta_t).sqrt();
    let (a, b) = (eta_i * cos_theta_i, eta_t * cos_theta_t);
    let (c, d) = (eta_t * cos_theta_i, eta_i * cos_theta_t);
    let square = |x: f64| x * x;
    (square((a - b) / (a + b)) + square((c - d) / (c + d))) / 2.0
}

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
    let pairs = [
        (1.0, 1.33),
        (1.0, 1.5),
        (1.0, 2.42),
        (1.33, 1.0),
        (1.5, 1.0),
        (2.42, 1.0),
    ];
    numbers.note("errors", table(pairs.map(errors)));
    numbers.note("rays", paint(&STAGE, "still-life", HERO).rays);
    let before = paint(&::refraction::STAGE, "glass", HERO).rays;
    numbers.note("rays-of-chapter-7", before);
    numbers.check("08-fresnel");
}

/// The largest errors over all angles, of the exact formula, of Schlick's, and of a constant.
fn errors((eta_i, eta_t): (f32, f32)) -> [String; 4] {
    let largest = |method: Reflectance| {
        let errors = (1..=10_000).map(|i| {
            let cos_theta_i = i as f32 / 10_000.0;
            let exact = exactly(cos_theta_i.into(), eta_i.into(), eta_t.into());
            (f64::from(method(cos_theta_i, eta_i, eta_t)) - exact).abs()
        });
        three_digits(errors.fold(0.0, f64::max))
    };
    [
        format!("{eta_i} → {eta_t}"),
        largest(fresnel),
        largest(schlick),
        largest(|_, eta_i, eta_t| fresnel(1.0, eta_i, eta_t)),
    ]
}
