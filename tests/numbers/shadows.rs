use super::*;
use ::canvas::Pixel;
use ::plane_hit::views::STILL_LIFE_COLOURS;
use ::plane_hit::{Object, Plane, Shape};
use ::ray_casting::SKY;
use ::ray_casting::views::{STILL_LIFE_FOCAL_LENGTH, still_life_camera};
use ::shadows::views::lit_still_life;
use ::shadows::{PointLight, STAGE, Scene, light_reaches, light_reaches_buggy, trace};
use ::sphere_hit::Sphere;

#[test]
fn the_numbers_are_those_in_the_book() {
    let mut numbers = Numbers::default();
    numbers.note("differing-still-life", differing_still_life());
    let [buggy, cured] =
        ["lamp-buggy", "lamp"].map(|view| paint(&STAGE, view, SMALL).light);
    let differing = buggy.iter().zip(&cured).filter(|(a, b)| a != b).count();
    numbers.note("differing-lamp", format!("{differing} of {}", cured.len()));
    numbers.note("exact-radius", format!("{:.4}", 1.25_f64.sqrt()));
    let scales = [1e-3, 1e-2, 0.1, 1.0, 1e3];
    numbers.note(
        "scales",
        table(scales.map(|scale: f32| {
            let radius = f64::from(shadow_radius(scale)) / f64::from(scale);
            [scale.to_string(), format!("{radius:.4}")]
        })),
    );
    numbers.note("rays", ray_counts(&STAGE, ["none", "hard"]));
    let hard = paint(&STAGE, "hard", HERO).light;
    let dark = hard.iter().filter(|&&light| light == Vec3::ZERO).count();
    numbers.note("dark", percent(dark, hard.len()));
    numbers.check("04-shadows");
}

/// How many pixels of the still life the buggy shadow changes.
fn differing_still_life() -> String {
    let camera = still_life_camera(STILL_LIFE_FOCAL_LENGTH);
    let scene = lit_still_life(STILL_LIFE_COLOURS);
    let pixels = (0..HERO.y).flat_map(|y| (0..HERO.x).map(move |x| (x, y)));
    let differing = pixels.filter(|&(x, y)| {
        let ray = camera.ray(Pixel { x, y, size: HERO }.centre());
        trace(&scene, &ray, light_reaches) != trace(&scene, &ray, light_reaches_buggy)
    });
    format!("{} of {}", differing.count(), HERO.x * HERO.y)
}

/// The radius of the shadow of a ball of radius `scale` on a floor, by a lamp 10 of its radii above.
fn shadow_radius(scale: f32) -> f32 {
    let object = |shape| Object {
        name: "",
        shape,
        material: (),
    };
    let ball = Sphere::new(scale * Vec3::Y, scale).expect("a sphere");
    let floor = Plane::new(Vec3::ZERO, Vec3::Y).expect("a plane");
    let scene = Scene {
        objects: vec![object(Shape::Sphere(ball)), object(Shape::Plane(floor))],
        lights: vec![],
        background: SKY,
    };
    let light = PointLight {
        position: 10.0 * scale * Vec3::Y,
        intensity: 1.0,
    };
    let (mut dark, mut lit) = (0.0, 2.0 * scale);
    for _ in 0..30 {
        let middle = (dark + lit) / 2.0;
        if light_reaches(&scene, middle * Vec3::X, Vec3::Y, &light) {
            lit = middle;
        } else {
            dark = middle;
        }
    }
    lit
}
