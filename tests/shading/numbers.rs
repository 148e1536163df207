//! The numbers that the chapter's page quotes. They guard the page, not the truth: the code
//! under test has written them.

use ::plane_hit::Texture;
use ::shading::scene::still_life_surfaces;
use ::shading::{Phong, STAGE, powi};
use ::shadows::scene::lit_still_life;
use glam::Vec3;
use harness::{HERO, Numbers, ray_counts, render, table, three_digits};

#[test]
fn the_numbers_are_those_in_the_book() {
    let mut numbers = Numbers::default();
    let objects = lit_still_life(still_life_surfaces()).objects;
    numbers.note(
        "surfaces",
        table(objects.iter().map(|object| {
            let Phong {
                colour,
                ambient,
                diffuse,
                specular,
                shininess,
            } = object.material;
            [
                object.name.to_string(),
                in_words(colour),
                ambient.to_string(),
                diffuse.to_string(),
                specular.to_string(),
                shininess.to_string(),
            ]
        })),
    );
    let powers = [(0.9, 10), (0.99, 50), (0.99, 200), (0.5, 200), (-0.9, 10)];
    numbers.note(
        "powers",
        table(powers.map(|(x, n): (f32, u32)| {
            let shown = three_digits(f64::from(powi(x, n)));
            [x.to_string().replace('-', "−"), n.to_string(), shown]
        })),
    );
    let next_to_1 = [200, 10_000_000].map(|n| powi(1.0_f32.next_up(), n));
    numbers.note("next-to-1", 1.0_f32.next_up());
    numbers.note("next-to-1-to-200", next_to_1[0]);
    numbers.note("next-to-1-to-1e7", three_digits(f64::from(next_to_1[1])));
    let specular = STAGE.view("specular").expect("a view");
    numbers.note("shininess", specular.default_setting());
    let hero = render(&STAGE, "combined", HERO);
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
    let views = STAGE.views.iter().map(|view| view.name);
    numbers.note("rays", ray_counts(&STAGE, views));
    numbers.check(STAGE.name);
}

/// Returns the colour of an even square, and that of an odd one if it is another.
fn in_words(colour: Texture) -> String {
    let rgb = |colour: Vec3| format!("({}, {}, {})", colour.x, colour.y, colour.z);
    match colour {
        Texture::Solid(colour) => rgb(colour),
        Texture::Checker(even, odd) => format!("{} and {}", rgb(even), rgb(odd)),
    }
}
