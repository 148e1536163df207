//! The numbers that the chapter's page quotes. They guard the page, not the truth: the code
//! under test has written them.

use ::canvas::Pixel;
use ::ray_casting::Ray;
use ::sphere_hit::scene::camera_at;
use ::sphere_hit::views::red;
use ::sphere_hit::{STAGE, Sphere, T_MAX};
use glam::Vec3;
use harness::{HERO, Numbers, SMALL, render, table, three_digits};
use oracle::exact;

const SPHERE: Sphere = Sphere {
    centre: Vec3::ZERO,
    radius: 1.0,
};

fn exact_distance(ray: &Ray) -> Option<f64> {
    let [near, _] =
        exact::sphere(ray.origin, ray.direction, SPHERE.centre, SPHERE.radius)?;
    Some(near.t)
}

#[test]
fn the_numbers_are_those_in_the_book() {
    let mut numbers = Numbers::default();
    let origins = [
        (0.0, 5.0),
        (1.0, 5.0),
        (1.0_f32.next_up(), 5.0),
        (0.5, 1e4),
        (1.5, 1e4),
        (0.5, 1e6),
    ];
    let or_miss = |t: Option<String>| t.unwrap_or("miss".to_string());
    numbers.note(
        "spots",
        table(origins.map(|(x, z)| {
            let ray = Ray {
                origin: Vec3::new(x, 0.0, z),
                direction: Vec3::NEG_Z,
            };
            let exact = exact_distance(&ray).map(|t| format!("{t:.6}"));
            let [textbook, stable, in_f64] = [
                SPHERE.distance_quadratic(&ray, T_MAX),
                SPHERE.distance(&ray, T_MAX),
                SPHERE.hit_in_f64(&ray, T_MAX).map(|hit| hit.t),
            ]
            .map(|t| or_miss(t.map(|t| t.to_string())));
            [
                format!("({x}, 0, {z})"),
                or_miss(exact),
                textbook,
                stable,
                in_f64,
            ]
        })),
    );
    let hero = render(&STAGE, "flat", HERO);
    let is_red = |(_, radiance): &(Pixel, &Vec3)| **radiance == red(Vec3::Y);
    let ball: Vec<Pixel> = Pixel::all(HERO)
        .zip(&hero.radiance)
        .filter(is_red)
        .map(|(pixel, _)| pixel)
        .collect();
    let extent = |along: fn(&Pixel) -> u32| {
        let [first, last] = [ball.iter().map(along).min(), ball.iter().map(along).max()];
        last.expect("a ball") - first.expect("a ball") + 1
    };
    let [width, height] = [extent(|pixel| pixel.x), extent(|pixel| pixel.y)];
    numbers.note("ball", format!("{width} × {height}"));
    for (name, distance) in [("1e4", 1e4), ("1e6", 1e6)] {
        let [short, discriminant] = from_afar(distance);
        numbers.note(&format!("short-from-{name}"), short);
        numbers.note(&format!("discriminant-from-{name}"), discriminant);
    }
    numbers.check(STAGE.name);
}

/// Returns by how much the directions' z is less than 1, and the textbook's discriminant, in the
/// picture of a sphere from so far that both are the same for every pixel.
fn from_afar(distance: f32) -> [String; 2] {
    let camera = camera_at(distance);
    let numbers = Pixel::all(SMALL).map(|pixel| {
        let Ray { origin, direction } = camera.ray(pixel.centre());
        let b = direction.dot(origin);
        [
            1.0 - direction.z,
            b * b - (origin.dot(origin) - SPHERE.radius),
        ]
    });
    let mut numbers: Vec<[f32; 2]> = numbers.collect();
    numbers.dedup();
    let [[short, discriminant]] = numbers[..] else {
        panic!("they are {numbers:?}");
    };
    [short, discriminant].map(|number| three_digits(f64::from(number)))
}
