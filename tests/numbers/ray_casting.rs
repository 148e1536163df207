use super::*;
use ::canvas::Pixel;
use ::ray_casting::views::{STILL_LIFE_FOCAL_LENGTH, still_life_camera};
use ::ray_casting::{SKY, STAGE};

#[test]
fn the_numbers_are_those_in_the_book() {
    let mut numbers = Numbers::default();
    let camera = still_life_camera(STILL_LIFE_FOCAL_LENGTH);
    let direction = |x, y| camera.ray(Pixel { x, y, size: HERO }.centre()).direction;
    let pixels = [(0, 0), (799, 0), (400, 300), (0, 599), (799, 599)];
    numbers.note(
        "directions",
        table(
            pixels.map(|(x, y)| {
                [format!("({x}, {y})"), vector(&direction(x, y).to_array())]
            }),
        ),
    );
    let canvas = paint(&STAGE, "sky-and-ground", HERO);
    numbers.note("rays", canvas.rays);
    let last_sky = canvas.light.iter().rposition(|&light| light == SKY);
    numbers.note("horizon", last_sky.expect("some sky") / HERO.x as usize);
    let errors = (0..HERO.y).flat_map(|y| (0..HERO.x).map(move |x| (x, y)));
    let errors = errors.map(|(x, y)| (direction(x, y).as_dvec3().length() - 1.0).abs());
    numbers.note("length-error", three_digits(errors.fold(0.0, f64::max)));
    numbers.note("epsilon", three_digits(f64::from(f32::EPSILON)));
    numbers.check("01-ray-casting");
}
