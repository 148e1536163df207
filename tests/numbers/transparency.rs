use super::*;
use ::transparency::views::AMBER;
use ::transparency::{STAGE, transmittance};

#[test]
fn the_numbers_are_those_in_the_book() {
    let mut numbers = Numbers::default();
    let ways = [0.1, 0.5, 1.2, 2.4];
    numbers.note(
        "transmittance",
        table(ways.map(|way: f32| {
            let [red, green, blue] = transmittance(AMBER, way).to_array();
            [way, red, green, blue].map(|x| three_digits(f64::from(x)))
        })),
    );
    // On the floor, in the ball's shadow.
    let (x, y) = (610, 405);
    numbers.note("shadow-pixel", format!("({x}, {y})"));
    let levels = |stage: &Stage| {
        let canvas = paint(stage, "still-life", HERO);
        let [red, green, blue] = canvas.levels[(y * HERO.x + x) as usize];
        format!("{red}, {green}, {blue}")
    };
    numbers.note("shadow-levels", levels(&STAGE));
    numbers.note("shadow-levels-before", levels(&::shadow_acne::STAGE));
    let of_11 = |absorption| {
        let rays = Canvas::paint(&(STAGE.views[0].picture)(absorption), HERO).rays;
        [format!("absorption {absorption}"), rays.to_string()]
    };
    let of_10 = paint(&::shadow_acne::STAGE, "still-life", HERO).rays;
    numbers.note(
        "rays",
        table([
            ["chapter 10".to_string(), of_10.to_string()],
            of_11(0.0),
            of_11(1.0),
            of_11(4.0),
        ]),
    );
    numbers.note("exp-error", exp_error());
    numbers.check("11-transparency");
}

/// The largest relative error of the exponential, for transmittances that are not quite black.
#[expect(clippy::disallowed_methods, reason = "f64 is the judge here")]
fn exp_error() -> String {
    let errors = (0..100_000).map(|i| {
        let way = i as f32 / 10_000.0;
        let exact = (-f64::from(way)).exp();
        (f64::from(transmittance(Vec3::ONE, way).x) / exact - 1.0).abs()
    });
    three_digits(errors.fold(0.0, f64::max))
}
