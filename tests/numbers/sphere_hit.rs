use super::*;
use ::ray_casting::Ray;
use ::sphere_hit::{FARTHEST, Hit, Sphere};
use oracle::exact;

type Method = fn(&Sphere, &Ray, f32) -> Option<Hit>;

const METHODS: [Method; 3] = [Sphere::hit_by_slide, Sphere::hit, Sphere::hit_in_f64];

const SPHERE: Sphere = Sphere {
    centre: Vec3::ZERO,
    radius: 1.0,
};

fn exactly(ray: &Ray) -> Option<f64> {
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
            let answer = exactly(&ray).map(|t| format!("{t:.6}"));
            let [slide, stable, in_f64] = METHODS.map(|hit| {
                or_miss(hit(&SPHERE, &ray, FARTHEST).map(|hit| hit.t.to_string()))
            });
            [
                format!("({x}, 0, {z})"),
                or_miss(answer),
                slide,
                stable,
                in_f64,
            ]
        })),
    );
    numbers.check("02-sphere-hit");
}
