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
    let distances = [1.5, 10.0, 100.0, 1e3, 1e4, 1e5, 1e6];
    numbers.note("distances", table(distances.map(row)));
    numbers.check("02-sphere-hit");
}

/// A distance, and each method's share of wrong answers and largest error there.
fn row(distance: f64) -> [String; 7] {
    let rays: Vec<Ray> = (0..4000).map(|i| towards_the_sphere(distance, i)).collect();
    let answers: Vec<Option<f64>> = rays.iter().map(exactly).collect();
    let columns = METHODS.map(|hit| {
        let mut wrong = 0;
        let mut error: Option<f64> = None;
        for (ray, answer) in rays.iter().zip(&answers) {
            match (hit(&SPHERE, ray, FARTHEST), answer) {
                (Some(hit), Some(t)) if approach(ray) <= 0.95 => {
                    let this = (f64::from(hit.t) - t).abs();
                    error = Some(error.map_or(this, |error| error.max(this)));
                }
                (hit, answer) => wrong += usize::from(hit.is_some() != answer.is_some()),
            }
        }
        let error = error.map_or("—".to_string(), three_digits);
        [percent(wrong, rays.len()), error]
    });
    let [slide, stable, in_f64] = columns;
    let [a, b] = slide;
    let [c, d] = stable;
    let [e, f] = in_f64;
    [distance.to_string(), a, b, c, d, e, f]
}

fn approach(ray: &Ray) -> f64 {
    exact::approach(ray.origin, ray.direction, SPHERE.centre, SPHERE.radius)
}

/// A ray from a distance, aimed evenly at a disc of one and a half radii.
fn towards_the_sphere(distance: f64, i: usize) -> Ray {
    let [out, across, _] = frame(i);
    let [.., spread] = evenly(i);
    let origin = (distance * out).as_vec3();
    let aim = 1.5 * spread.sqrt() * across;
    Ray {
        origin,
        direction: (aim.as_vec3() - origin).normalize(),
    }
}
