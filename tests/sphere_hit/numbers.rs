//! The numbers that the chapter's page quotes. They guard the page, not the truth: the code
//! under test has written them.

use ::ray_casting::Ray;
use ::sphere_hit::{STAGE, Sphere, T_MAX};
use glam::Vec3;
use harness::{Numbers, table};
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
    numbers.check(STAGE.name);
}
