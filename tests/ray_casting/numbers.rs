//! The numbers that the chapter's page quotes. They guard the page, not the truth: the code
//! under test has written them.

use ::canvas::Pixel;
use ::ray_casting::scene::still_life_camera;
use ::ray_casting::{Camera, SKY, STAGE};
use glam::Vec3;
use harness::{
    HERO, Numbers, SMALL, render, table, three_digits, vector, with_separators,
};

#[test]
fn the_numbers_are_those_in_the_book() {
    let mut numbers = Numbers::default();
    let camera = still_life_camera();
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
    let vectors = [
        ("eye", camera.eye),
        ("right", camera.right),
        ("up", camera.up),
        ("forward", camera.forward),
    ];
    numbers.note(
        "camera",
        table(vectors.map(|(name, Vec3 { x, y, z })| {
            let [x, y, z] = [x, y, z].map(|part| three_digits(f64::from(part) + 0.0));
            [name.to_string(), x, y, z]
        })),
    );
    let canvas = render(&STAGE, "sky-and-ground", HERO);
    numbers.note("rays", with_separators(canvas.rays));
    let upside_down = render(&STAGE, "upside-down", SMALL);
    numbers.note("rays-upside-down", with_separators(upside_down.rays));
    numbers.note("seen-by-a-short-lens", seen_by(0.5));
    let last_sky = canvas
        .radiance
        .iter()
        .rposition(|&radiance| radiance == SKY);
    numbers.note("horizon", last_sky.expect("some sky") / HERO.x as usize);
    let directions = Pixel::all(HERO).map(|pixel| camera.ray(pixel.centre()).direction);
    let errors = directions.map(|direction| (direction.as_dvec3().length() - 1.0).abs());
    numbers.note("length-error", three_digits(errors.fold(0.0, f64::max)));
    numbers.note("epsilon", three_digits(f64::from(f32::EPSILON)));
    numbers.check(STAGE.name);
}

/// Returns the part of all directions that the still life's camera sees with a focal length.
fn seen_by(focal_length: f32) -> String {
    let camera = Camera {
        focal_length,
        ..still_life_camera()
    };
    // A pixel's part of the unit sphere: smaller the farther it is from the eye, and the more
    // its ray is at a slant.
    let solid_angle = |pixel: Pixel| {
        let ray = camera.ray(pixel.centre());
        let side = f64::from(pixel.footprint() / focal_length);
        let cos = f64::from(ray.direction.dot(camera.forward));
        side * side * cos * cos * cos
    };
    let seen: f64 = Pixel::all(HERO).map(solid_angle).sum();
    let sphere = 4.0 * std::f64::consts::PI;
    format!("{}\u{a0}%", three_digits(100.0 * seen / sphere))
}
