//! The intersection of a ray and a plane, and the squares of a checkered floor.

use crate::chart::{Axis, Chart, Quantity};
use crate::lanes::{self, InLanes, costs, plane_by_offset};
use crate::study::{Choice, Clock, Study, Verdict, compare};
use crate::table::Measurement;
use glam::{Vec2, Vec3};
use measure::Random;
use measure::inputs::{floor_point, plane_ray};
use packets::Lanes;
use plane_hit::{Plane, is_even, is_even_in_space};
use ray_casting::Ray;
use sphere_hit::T_MAX;
use wide::f64x8;

/// The textbook's formula, that with a stored offset, and the textbook's in f64, for planes
/// near and far; and a floor's squares by two coordinates or by three.
///
/// Of a plane far from the origin, the textbook's formula is the better one as long as the
/// point that is stored is near the eye: far from that, no f32 is exact enough for the
/// height.
pub const STUDY: Study = Study {
    name: "plane",
    title: "A ray and a plane: the textbook’s formula, a stored offset, and f64; and the floor’s squares",
    measure,
    chosen: &[Choice::of("textbook"), Choice::of("in the plane")],
    charts: &[
        Chart::new("grazing", COSINE, LARGEST).titled(
            "A plane 1,000 away from the origin: a grazing ray’s d·n is mostly rounding",
        ),
        Chart::new("squares", DISTANCE, WRONG)
            .titled("Squares of a floor at height −1 that have the wrong colour"),
        Chart::new("lanes", TIME, ERROR)
            .titled("Planes up to a million away, at angles down to half a degree"),
    ],
};

const COSINE: Axis = (
    Quantity::Setting,
    "|d·n|: 1 straight on, 0 beside the plane",
);
const LARGEST: Axis = (Quantity::Max, "largest error of t, in ulps");
const DISTANCE: Axis = (Quantity::Setting, "distance, in squares");
const WRONG: Axis = (Quantity::Wrong, "wrong, in percent");
const TIME: Axis = (Quantity::Ns, "nanoseconds per ray, in full registers");
const ERROR: Axis = (Quantity::Rms, "RMS error of t, in ulps");

/// A plane, its offset h = x₀·n, and a ray.
type Case = (Plane, f32, Ray);

type Method = fn(&Case) -> Option<f32>;
type IsEven = fn(&Vec3) -> bool;

const METHODS: [(&str, Method); 3] = [
    ("textbook", |(plane, _, ray)| plane.distance(ray, T_MAX)),
    ("stored offset", distance_by_offset),
    ("f64", distance_in_f64),
];

/// At the floor's odd height the cubes' colours have changed places.
const CHECKERS: [(&str, IsEven); 2] = [
    ("in the plane", |point| is_even(Vec2::new(point.x, point.z))),
    ("in space", |&point| !is_even_in_space(point)),
];

/// Returns t = (h − n·o) / (n·d).
///
/// Source: the plane's Hesse normal form, as in Ericson, Real-Time Collision Detection
/// (2005), 5.3.1.
fn distance_by_offset((plane, offset, ray): &Case) -> Option<f32> {
    let normal = plane.normal;
    let t = (offset - normal.dot(ray.origin)) / normal.dot(ray.direction);
    (t > 0.0 && t < T_MAX).then_some(t)
}

fn distance_in_f64((plane, _, ray): &Case) -> Option<f32> {
    let normal = plane.normal.as_dvec3();
    let to_point = plane.point.as_dvec3() - ray.origin.as_dvec3();
    let t = (to_point.dot(normal) / ray.direction.as_dvec3().dot(normal)) as f32;
    (t > 0.0 && t < T_MAX).then_some(t)
}

fn measure(clock: &Clock) -> Vec<Measurement> {
    let hits = |scene, setting, rays: &[_]| {
        compare(clock, (scene, setting), rays, &METHODS, |_, t, hit| {
            hit.map_or(Verdict::Wrong, |hit| Verdict::in_ulps(hit, *t))
        })
    };
    let mut random = Random::new(3);
    let mut rays = |distance, aside, d_dot_n| -> Vec<(Case, f64)> {
        let ray = |_| {
            let ((plane, ray), t) = plane_ray(&mut random, [distance, aside, d_dot_n]);
            ((plane, plane.point.dot(plane.normal), ray), t)
        };
        (0..2000).map(ray).collect()
    };
    let (mut rows, mut all) = (Vec::new(), Vec::new());
    for d_dot_n in [0.9, 0.3, 0.1, 3e-2, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6] {
        let grazing = rays(1e3, 0.0, d_dot_n);
        rows.extend(hits("grazing", d_dot_n, &grazing));
        all.extend(grazing.into_iter().filter(|_| d_dot_n >= 1e-2));
    }
    for distance in [1.0, 10.0, 1e2, 1e3, 1e4, 1e5, 1e6] {
        all.extend(rays(distance, 0.0, 0.5));
        let aside = rays(0.0, distance, 0.5);
        rows.extend(hits("far from its point", distance, &aside));
    }
    // What the loop, the call and the input take of each method's time.
    let nothing: [(&str, Method); 1] = [("nothing", |_| None)];
    let no_error = |_: &_, _: &_, _| Verdict::Right;
    rows.extend(compare(clock, ("loop", 0.0), &all, &nothing, no_error));
    let overall = hits("overall", 0.0, &all);
    let by_point =
        |(plane, _, ray): &Case| [ray.origin, ray.direction, plane.point, plane.normal];
    let by_offset = |(plane, offset, ray): &Case| {
        [
            ray.origin,
            ray.direction,
            Vec3::splat(*offset),
            plane.normal,
        ]
    };
    let of_all = |case: fn(&Case) -> [Vec3; 4]| -> Vec<[Vec3; 4]> {
        all.iter().map(|(ray, _)| case(ray)).collect()
    };
    let (by_point, by_offset) = (of_all(by_point), of_all(by_offset));
    let formulas = vec![
        InLanes::of::<Lanes, _, _>(&by_point, lanes::plane, lanes::plane),
        InLanes::of::<Lanes, _, _>(&by_offset, plane_by_offset, plane_by_offset),
        InLanes::of::<f64x8, _, _>(&by_point, lanes::plane, lanes::plane),
    ];
    rows.extend(costs(clock, &overall, formulas));
    rows.extend(overall);
    for distance in [10.0, 30.0, 1e2, 3e2, 1e3, 1e4, 1e5, 1e6, 3e6, 1e7] {
        let point = |_| floor_point(&mut random, distance);
        let points: Vec<_> = (0..10_000).map(point).collect();
        let verdict = |_: &_, exact: &bool, result| Verdict::of(result == *exact);
        rows.extend(compare(
            clock,
            ("squares", distance),
            &points,
            &CHECKERS,
            verdict,
        ));
    }
    rows
}
