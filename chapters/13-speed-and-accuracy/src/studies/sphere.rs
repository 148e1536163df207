//! Chapter 2: three formulas for a ray and a sphere.

use crate::chart::{Axis, Chart, Quantity};
use crate::study::{self, Clock, Measurement, Study, Verdict, direction, ulp};
use glam::{DVec3, Vec3};
use oracle::exact;
use ray_casting::Ray;
use sphere_hit::{FARTHEST, Hit, Sphere};

/// The slide's formula, the stable one, and that in f64, from near and from far, from
/// within, from just above the surface, and on a ground that is a sphere; "overall" is from
/// all the distances.
pub const STUDY: Study = Study {
    name: "sphere",
    title: "A ray and a sphere: the slide’s formula, the stable one, and that in f64",
    measure,
    charts: &[
        Chart {
            title: "From afar: rays taken for hits that miss, or the other way round",
            scene: "from afar",
            x: Axis::new(Quantity::Setting, "distance, in radii"),
            y: Axis::new(Quantity::Wrong, "wrong, in percent"),
            front: false,
        },
        Chart {
            title: "From afar: where the ray meets the sphere",
            scene: "from afar",
            x: Axis::new(Quantity::Setting, "distance, in radii"),
            y: Axis::new(Quantity::Max, "largest error of t, in ulps"),
            front: false,
        },
        Chart {
            title: "From all of these distances, against the cost",
            scene: "overall",
            x: Axis::new(Quantity::Ns, "nanoseconds for one hit"),
            y: Axis::new(Quantity::Rms, "RMS error of t, in ulps"),
            front: true,
        },
    ],
    table: include_str!("../../../../book/src/studies/sphere.csv"),
};

type Method = fn(&Sphere, &Ray, f32) -> Option<Hit>;

const METHODS: [(&str, Method); 3] = [
    ("slide", Sphere::hit_by_slide),
    ("stable", Sphere::hit),
    ("f64", Sphere::hit_in_f64),
];

const RAYS: usize = 2000;

fn measure(clock: &Clock) -> Vec<Measurement> {
    let unit = Sphere {
        centre: Vec3::ZERO,
        radius: 1.0,
    };
    let (mut rows, mut all) = (Vec::new(), Vec::new());
    for distance in [1.5, 3.0, 10.0, 30.0, 100.0, 300.0, 1e3, 3e3, 1e4, 1e5, 1e6] {
        let rays = rays(|random| from_afar(random, distance));
        rows.extend(compare(clock, "from afar", distance, unit, &rays));
        all.extend(rays);
    }
    rows.extend(compare(clock, "overall", 0.0, unit, &all));
    rows.extend(compare(clock, "inside", 0.0, unit, &rays(from_within)));
    for height in [1.0, 1e-2, 1e-4, 1e-6] {
        let rays = rays(|random| from_above(random, height));
        rows.extend(compare(clock, "just above", height, unit, &rays));
    }
    for radius in [1e2, 1e3, 1e4, 1e5, 1e6, 1e7] {
        let ground = Sphere {
            centre: Vec3::new(0.0, -radius as f32, 0.0),
            radius: radius as f32,
        };
        rows.extend(compare(
            clock,
            "ground",
            radius,
            ground,
            &rays(towards_the_ground),
        ));
    }
    rows
}

/// The same rays every time.
fn rays(ray: impl Fn(&mut fastrand::Rng) -> (DVec3, DVec3)) -> Vec<Ray> {
    let mut random = fastrand::Rng::with_seed(2);
    let ray = |_| {
        let (origin, target) = ray(&mut random);
        Ray {
            origin: origin.as_vec3(),
            direction: (target - origin).as_vec3().normalize(),
        }
    };
    (0..RAYS).map(ray).collect()
}

/// Aimed evenly at a disc of one and a half radii about the centre.
fn from_afar(random: &mut fastrand::Rng, distance: f64) -> (DVec3, DVec3) {
    let out = direction(random);
    let across = out.cross(direction(random)).normalize();
    (distance * out, 1.5 * random.f64().sqrt() * across)
}

fn from_within(random: &mut fastrand::Rng) -> (DVec3, DVec3) {
    let origin = 0.99 * random.f64() * direction(random);
    (origin, origin + direction(random))
}

/// From a height above the surface, down, at up to some 80° from the vertical.
fn from_above(random: &mut fastrand::Rng, height: f64) -> (DVec3, DVec3) {
    let up = direction(random);
    let along = up.cross(direction(random)).normalize();
    let down = -(0.15 + 0.85 * random.f64());
    let origin = (1.0 + height) * up;
    (
        origin,
        origin + down * up + (1.0 - down * down).sqrt() * along,
    )
}

/// From an eye at a height of 1 to a place on the ground 1 to 30 away.
fn towards_the_ground(random: &mut fastrand::Rng) -> (DVec3, DVec3) {
    let angle = direction(random) * DVec3::new(1.0, 0.0, 1.0);
    let away = 1.0 + 29.0 * random.f64();
    (DVec3::Y, away * angle.normalize())
}

/// Each method's errors in t, in ulps of the right answer, among the rays that pass
/// within 0.95 radii of the centre: nearer to the rim, t depends more on the ray's own
/// rounding than on the formula. And its wrong decisions among all.
fn compare(
    clock: &Clock,
    scene: &str,
    setting: f64,
    sphere: Sphere,
    rays: &[Ray],
) -> Vec<Measurement> {
    let exactly = |ray: &Ray| {
        let both =
            exact::sphere(ray.origin, ray.direction, sphere.centre, sphere.radius)?;
        both.into_iter().map(|meeting| meeting.t).find(|&t| t > 0.0)
    };
    let rays: Vec<_> = rays.iter().map(|ray| (*ray, exactly(ray))).collect();
    let methods =
        METHODS.map(|(name, hit)| (name, move |ray: &Ray| hit(&sphere, ray, FARTHEST)));
    study::compare(
        clock,
        (scene, setting),
        &rays,
        &methods,
        |ray, exact, hit| match (hit, exact) {
            (Some(hit), &Some(t)) => {
                let approach = exact::approach(
                    ray.origin,
                    ray.direction,
                    sphere.centre,
                    sphere.radius,
                );
                if approach <= 0.95 {
                    Verdict::Off((f64::from(hit.t) - t) / ulp(t))
                } else {
                    Verdict::Right
                }
            }
            (None, None) => Verdict::Right,
            _ => Verdict::Wrong,
        },
    )
}
