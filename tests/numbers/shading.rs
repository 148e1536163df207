use super::*;
use ::shading::{STAGE, power};

#[test]
fn the_numbers_are_those_in_the_book() {
    let mut numbers = Numbers::default();
    let powers = [(0.9, 10), (0.99, 50), (0.99, 200), (0.5, 200), (-0.9, 10)];
    numbers.note(
        "powers",
        table(powers.map(|(x, n): (f32, u32)| {
            let shown = three_digits(f64::from(power(x, n)));
            [x.to_string().replace('-', "−"), n.to_string(), shown]
        })),
    );
    let hero = paint(&STAGE, "combined", HERO);
    let pixels = [
        (400, 10, "sky"),
        (390, 224, "the grey ball's highlight"),
        (130, 290, "the red ball"),
        (470, 420, "the glass ball's dark side"),
        (400, 590, "the floor"),
    ];
    numbers.note(
        "pixels",
        table(pixels.map(|(x, y, what)| {
            let [red, green, blue] = hero.levels[(y * HERO.x + x) as usize];
            [
                format!("({x}, {y})"),
                what.to_string(),
                format!("{red}, {green}, {blue}"),
            ]
        })),
    );
    numbers.note("power-errors", table([10, 50, 100, 200].map(power_errors)));
    let views = STAGE.views.iter().map(|view| view.name);
    numbers.note("rays", ray_counts(&STAGE, views));
    numbers.check("05-shading");
}

/// An exponent, its multiplications, and the largest error for bases from 0 to 1.
#[expect(clippy::disallowed_methods, reason = "f64 is the judge here")]
fn power_errors(n: u32) -> [String; 4] {
    let multiplications = n.ilog2() + 1 + n.count_ones();
    let errors = (0..=10_000).map(|i| {
        let x = i as f32 / 10_000.0;
        (f64::from(power(x, n)) - f64::from(x).powi(n as i32)).abs()
    });
    let largest = errors.fold(0.0, f64::max);
    [
        n.to_string(),
        multiplications.to_string(),
        three_digits(largest),
        three_digits(255.0 * largest),
    ]
}
