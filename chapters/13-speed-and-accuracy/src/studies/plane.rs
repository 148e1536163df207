//! Chapter 3: where a ray meets a plane, and on which square of a chequered floor.

use crate::chart::{Axis, Chart, Quantity};
use crate::study::{Clock, Measurement, Study, Verdict, compare, direction, ulp};
use glam::{DVec3, Vec2, Vec3};
use oracle::exact;
use plane_hit::{Plane, is_even, is_even_in_space};
use ray_casting::Ray;
use sphere_hit::{FARTHEST, Hit};

/// The slide's formula, that with the plane's offset multiplied out beforehand, and the
/// slide's in f64; and a floor's squares by two coordinates or by three.
///
/// Of a plane far from the origin, the slide's formula is the better one as long as the
/// point that is kept of it is near the eye: far from that, no f32 knows the height.
pub const STUDY: Study = Study {
    name: "plane",
    title: "A ray and a plane: the slide’s formula, a stored offset, and f64; and the floor’s squares",
    measure,
    charts: &[
        Chart {
            title: "A plane 1000 away from the origin: a grazing ray’s d·n is mostly rounding",
            scene: "grazing",
            x: Axis::new(
                Quantity::Setting,
                "|d·n|: 1 straight on, 0 beside the plane",
            ),
            y: Axis::new(Quantity::Max, "largest error of t, in ulps"),
            front: false,
        },
        Chart {
            title: "Squares of a floor at height −1 that have the wrong colour",
            scene: "squares",
            x: Axis::new(Quantity::Setting, "distance, in squares"),
            y: Axis::new(Quantity::Wrong, "wrong, in percent"),
            front: false,
        },
        Chart {
            title: "Planes up to a million away, at angles down to half a degree",
            scene: "overall",
            x: Axis::new(Quantity::Ns, "nanoseconds for one hit"),
            y: Axis::new(Quantity::Rms, "RMS error of t, in ulps"),
            front: true,
        },
    ],
    table: include_str!("../../../../book/src/studies/plane.csv"),
};

/// A plane, the same as a normal and an offset, and a ray.
struct Case {
    plane: Plane,
    offset: f32,
    ray: Ray,
}

type Method = fn(&Case) -> Option<Hit>;
type IsEven = fn(&Vec3) -> bool;

const METHODS: [(&str, Method); 3] = [
    ("slide", |case| case.plane.hit(&case.ray, FARTHEST)),
    ("stored offset", hit_by_stored_offset),
    ("f64", hit_in_f64),
];

/// At the floor's odd height the cubes' colours have changed places.
const CHECKERS: [(&str, IsEven); 2] = [
    ("in the plane", |point| is_even(Vec2::new(point.x, point.z))),
    ("in space", |&point| !is_even_in_space(point)),
];

/// t = (h − n·o) / (n·d), where h = x₀·n is all that is kept of the plane's point.
///
/// Source: the plane's Hesse normal form, as in Ericson, Real-Time Collision Detection
/// (2005), 5.3.1.
fn hit_by_stored_offset(case: &Case) -> Option<Hit> {
    let Case { plane, offset, ray } = case;
    let normal = plane.normal;
    hit_at(
        (offset - normal.dot(ray.origin)) / normal.dot(ray.direction),
        normal,
    )
}

/// The slide's formula in f64.
fn hit_in_f64(case: &Case) -> Option<Hit> {
    let Case { plane, ray, .. } = case;
    let normal = plane.normal.as_dvec3();
    let to_point = plane.point.as_dvec3() - ray.origin.as_dvec3();
    let t = to_point.dot(normal) / ray.direction.as_dvec3().dot(normal);
    hit_at(t as f32, plane.normal)
}

fn hit_at(t: f32, normal: Vec3) -> Option<Hit> {
    (t > 0.0 && t < FARTHEST).then_some(Hit { t, normal })
}

fn measure(clock: &Clock) -> Vec<Measurement> {
    let mut random = fastrand::Rng::with_seed(3);
    let mut cases = |distance, aside, d_dot_n| -> Vec<(Case, f64)> {
        let case = |_| above(&mut random, distance, aside, d_dot_n);
        (0..2000).map(case).collect()
    };
    let (mut rows, mut all) = (Vec::new(), Vec::new());
    for d_dot_n in [0.9, 0.3, 0.1, 3e-2, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6] {
        let grazing = cases(1e3, 0.0, d_dot_n);
        rows.extend(hits(clock, ("grazing", d_dot_n), &grazing));
        if d_dot_n >= 1e-2 {
            all.extend(grazing);
        }
    }
    for distance in [1.0, 10.0, 1e2, 1e3, 1e4, 1e5, 1e6] {
        let far = cases(distance, 0.0, 0.5);
        rows.extend(hits(clock, ("far from the origin", distance), &far));
        all.extend(far);
        let aside = cases(0.0, distance, 0.5);
        rows.extend(hits(clock, ("far from its point", distance), &aside));
    }
    rows.extend(hits(clock, ("overall", 0.0), &all));
    for distance in [10.0, 30.0, 1e2, 3e2, 1e3, 1e4, 1e5, 1e6, 3e6, 1e7] {
        rows.extend(squares(clock, distance));
    }
    rows
}

/// A tilted plane at a `distance` from the origin of the world, and a ray from an eye
/// that is 1 above it, whose t is returned as well; the point that is kept of the plane is
/// so far `aside` of the eye.
fn above(
    random: &mut fastrand::Rng,
    distance: f64,
    aside: f64,
    d_dot_n: f64,
) -> (Case, f64) {
    let normal = direction(random);
    let mut along = |normal: DVec3| normal.cross(direction(random)).normalize();
    let [below, aside] = [distance * along(DVec3::Y), aside * along(normal)];
    let plane = Plane::new((below + aside).as_vec3(), normal.as_vec3());
    let plane = plane.expect("a plane");
    let down = (1.0 - d_dot_n * d_dot_n).sqrt() * along(normal) - d_dot_n * normal;
    let ray = Ray {
        origin: (below + normal).as_vec3(),
        direction: down.as_vec3(),
    };
    let offset = plane.point.dot(plane.normal);
    let t = exact::plane(ray.origin, ray.direction, plane.point, plane.normal);
    (Case { plane, offset, ray }, t.expect("a hit"))
}

fn hits(clock: &Clock, scene: (&str, f64), cases: &[(Case, f64)]) -> Vec<Measurement> {
    compare(clock, scene, cases, &METHODS, |_, t, hit| match hit {
        Some(hit) => Verdict::Off((f64::from(hit.t) - t) / ulp(*t)),
        None => Verdict::Wrong,
    })
}

/// By two coordinates or by three: points of a floor at height −1, at about a `distance`,
/// as an eye sees them that is 3 above it.
fn squares(clock: &Clock, distance: f64) -> Vec<Measurement> {
    let mut random = fastrand::Rng::with_seed(3);
    let floor = Plane::new(Vec3::NEG_Y, Vec3::Y).expect("a plane");
    let point = |_| {
        let away = distance * (0.5 + random.f64());
        let along = DVec3::Y.cross(direction(&mut random)).normalize();
        let ray = Ray {
            origin: 2.0 * Vec3::Y,
            direction: (away * along - 3.0 * DVec3::Y).as_vec3().normalize(),
        };
        let hit = floor.hit(&ray, FARTHEST).expect("a hit");
        let t = exact::plane(ray.origin, ray.direction, floor.point, floor.normal);
        let exact = t.expect("a hit") * ray.direction.as_dvec3();
        let is_even = (exact.x.floor() + exact.z.floor()) % 2.0 == 0.0;
        (ray.at(hit.t), is_even)
    };
    let points: Vec<_> = (0..10_000).map(point).collect();
    let judge = |_: &_, exact: &bool, answer| Verdict::of(answer == *exact);
    compare(clock, ("squares", distance), &points, &CHECKERS, judge)
}
