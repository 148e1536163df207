//! Three formulas for the hit of a ray and a sphere.

use crate::chart::{Axis, Chart, Quantity};
use crate::lanes::{InLanes, costs, sphere_quadratic, sphere_stable};
use crate::study::{Choice, Clock, Study, Verdict, compare};
use crate::table::Measurement;
use glam::Vec3;
use measure::inputs::{
    SphereHit, from_afar, from_inside, sphere_rays, towards_the_ground,
};
use packets::Lanes;
use ray_casting::Ray;
use sphere_hit::{Hit, Sphere, T_MAX};
use wide::f64x8;

/// The textbook's formula, the stable one, and that in f64: from outside at all distances,
/// from inside, and on a ground that is a sphere.
///
/// Errors are those of t among the rays that pass within 0.95 radii of the centre: nearer to
/// the rim, t depends more on the ray's own rounding than on the formula.
pub const STUDY: Study = Study {
    name: "sphere",
    title: "A ray and a sphere: the textbook’s formula, the stable one, and that in f64",
    measure,
    chosen: &[Choice::of("stable")],
    charts: &[
        Chart::new("from afar", DISTANCE, WRONG)
            .titled("From afar: rays taken for hits that miss, or the other way round"),
        Chart::new("from afar", DISTANCE, LARGEST)
            .titled("From afar: where the ray meets the sphere"),
        Chart::new("lanes", TIME, ERROR)
            .titled("From all of these distances, against the cost in full registers"),
    ],
};

const DISTANCE: Axis = (Quantity::Setting, "distance, in radii");
const WRONG: Axis = (Quantity::Wrong, "wrong, in percent");
const LARGEST: Axis = (Quantity::Max, "largest error of t, in ulps");
const TIME: Axis = (Quantity::Ns, "nanoseconds per ray, in full registers");
const ERROR: Axis = (Quantity::Rms, "RMS error of t, in ulps");

type Case = (Sphere, Ray);

type Method = fn(&Case) -> Option<Hit>;
type Distance = fn(&Sphere, &Ray, f32) -> Option<f32>;

const METHODS: [(&str, Method); 3] = [
    ("textbook", |case| hit(case, Sphere::distance_quadratic)),
    ("stable", |case| hit(case, Sphere::distance)),
    ("f64", |(sphere, ray)| sphere.hit_in_f64(ray, T_MAX)),
];

fn hit((sphere, ray): &Case, distance: Distance) -> Option<Hit> {
    let t = distance(sphere, ray, T_MAX)?;
    let normal = sphere.normal(ray.at(t));
    Some(Hit { t, normal })
}

fn measure(clock: &Clock) -> Vec<Measurement> {
    let hits = |scene, setting, rays: &[_]| {
        compare(clock, (scene, setting), rays, &METHODS, verdict)
    };
    let ball = Sphere::new(Vec3::ZERO, 1.0).expect("a sphere");
    let (mut rows, mut all) = (Vec::new(), Vec::new());
    for distance in [1.5, 3.0, 10.0, 30.0, 100.0, 300.0, 1e3, 3e3, 1e4, 1e5, 1e6] {
        let rays = sphere_rays(ball, |random| from_afar(random, distance));
        rows.extend(hits("from afar", distance, &rays));
        all.extend(rays);
    }
    // What the loop, the call and the input take of each method's time.
    let nothing: [(&str, Method); 1] = [("nothing", |_| None)];
    let no_error = |_: &_, _: &_, _| Verdict::Right;
    rows.extend(compare(clock, ("loop", 0.0), &all, &nothing, no_error));
    let overall = hits("overall", 0.0, &all);
    let rays: Vec<[Vec3; 4]> = all
        .iter()
        .map(|((sphere, ray), _)| {
            let radius = Vec3::splat(sphere.radius);
            [ray.origin, ray.direction, sphere.centre, radius]
        })
        .collect();
    let formulas = vec![
        InLanes::of::<Lanes, _, _>(&rays, sphere_quadratic, sphere_quadratic),
        InLanes::of::<Lanes, _, _>(&rays, sphere_stable, sphere_stable),
        InLanes::of::<f64x8, _, _>(&rays, sphere_stable, sphere_stable),
    ];
    rows.extend(costs(clock, &overall, formulas));
    rows.extend(overall);
    rows.extend(hits("inside", 0.0, &sphere_rays(ball, from_inside)));
    for radius in [1e2, 1e3, 1e4, 1e5, 1e6, 1e7] {
        let ground = Sphere::new(radius * Vec3::NEG_Y, radius).expect("a sphere");
        let rays = sphere_rays(ground, towards_the_ground);
        rows.extend(hits("ground", radius.into(), &rays));
    }
    rows
}

fn verdict(_: &Case, exact: &SphereHit, hit: Option<Hit>) -> Verdict {
    match (exact, hit) {
        (Some((t, approach)), Some(hit)) if *approach <= 0.95 => {
            Verdict::in_ulps(hit.t, *t)
        }
        (exact, hit) => Verdict::of(exact.is_some() == hit.is_some()),
    }
}
