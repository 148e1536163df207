//! Bounce after bounce inside a mirror sphere.

use crate::chart::{Axis, Chart, Quantity};
use crate::study::{Choice, Clock, Study, Verdict, compare};
use crate::table::Measurement;
use glam::{DVec2, Vec3};
use measure::inputs::{Corner, orbits};
use plane_hit::{Object, Shape};
use ray_casting::Ray;
use reflection::{bounce_inside, reflect, reflect_unnormalized};
use shadow_acne::{exit_distance, from_surface};
use shadows::Interaction;
use sphere_hit::{Sphere, T_MAX};

/// The textbook's formulas, with the normal or the direction normalised or both, in f64, and
/// the bounce that starts on the surface itself, [`from_surface`].
///
/// The orbits are closed, so that the right answer is one of their corners. The start's
/// rounding to f32 is part of every method's error but f64's.
pub const STUDY: Study = Study {
    name: "bounces",
    title: "Bounces inside a mirror sphere: what is to be made a unit vector",
    measure,
    chosen: &[Choice::of("unit N and R")],
    charts: &[
        Chart::new("star", BOUNCES, LARGEST).titled(
            "Round a star, the textbook’s error grows 14-fold at each bounce (∞: lost)",
        ),
        Chart::new("hexagon", BOUNCES, LARGEST).titled("Round a hexagon it doubles"),
        Chart::new("overall", TIME, ERROR)
            .titled("After 16 bounces, on all the orbits (∞: lost)"),
    ],
};

const BOUNCES: Axis = (Quantity::Setting, "bounces");
const LARGEST: Axis = (Quantity::Max, "largest error, in radii");
const TIME: Axis = (Quantity::Ns, "nanoseconds per bounce");
const ERROR: Axis = (Quantity::Rms, "RMS error, in radii");

/// A function from a corner and a number of bounces to the corner after these.
type Method = fn(&(Corner, u32)) -> Corner;

const METHODS: [(&str, Method); 6] = [
    ("textbook", |start| bounce(start, reflect_unnormalized)),
    ("textbook in f64", |&(start, bounces)| {
        (0..bounces).fold(start, |corner, _| bounce_in_f64(corner))
    }),
    ("unit N", |start| bounce(start, reflect_by_unit_normal)),
    ("unit R", |start| bounce(start, reflect)),
    ("unit N and R", |start| {
        bounce(start, |i, n| reflect(i, n.normalize()))
    }),
    ("from the surface", |start| {
        in_f32(start, bounce_from_surface)
    }),
];

const MIRROR: Sphere = Sphere {
    centre: Vec3::ZERO,
    radius: 1.0,
};

fn reflect_by_unit_normal(incident: Vec3, normal: Vec3) -> Vec3 {
    reflect_unnormalized(incident, normal.normalize())
}

fn bounce(start: &(Corner, u32), reflect: fn(Vec3, Vec3) -> Vec3) -> Corner {
    in_f32(start, |ray| bounce_inside(&MIRROR, ray, reflect))
}

fn in_f32(&(start, bounces): &(Corner, u32), bounce: impl Fn(&Ray) -> Ray) -> Corner {
    let [origin, direction] = start.map(|vector| vector.as_vec3());
    let ray = (0..bounces).fold(Ray { origin, direction }, |ray, _| bounce(&ray));
    [ray.origin, ray.direction].map(|vector| vector.as_dvec3())
}

// These are not inlined, as `bounce_inside` from another crate is not: the difference in time
// is to be that of the methods.

/// Returns the next corner by the textbook's formulas; the mirror's centre is the origin,
/// its radius 1.
#[inline(never)]
fn bounce_in_f64([origin, direction]: Corner) -> Corner {
    let b = direction.dot(origin);
    let discriminant = b * b - (origin.dot(origin) - 1.0);
    let normal = origin + (-b + discriminant.sqrt()) * direction;
    [normal, direction - 2.0 * normal.dot(direction) * normal]
}

/// Returns the ray after the next bounce: from the other root of the quadratic, projected
/// onto the surface. NaN if there is no other root.
#[inline(never)]
fn bounce_from_surface(ray: &Ray) -> Ray {
    const OBJECTS: [Object<()>; 1] = [Object {
        name: "mirror",
        shape: Shape::Sphere(MIRROR),
        material: (),
    }];
    let t = exit_distance(&MIRROR, ray, T_MAX).unwrap_or(f32::NAN);
    let at = Interaction::new(&OBJECTS, ray, (0, t));
    let reflected = reflect(at.incident, at.normal);
    from_surface(&at, reflected).ray
}

fn measure(clock: &Clock) -> Vec<Measurement> {
    let root_5 = 5.0_f64.sqrt();
    // The turn about the centre from one corner to the next. The star has five corners.
    let star = DVec2::new(-(1.0 + root_5) / 4.0, ((5.0 - root_5) / 8.0).sqrt());
    let hexagon = DVec2::new(0.5, 0.75_f64.sqrt());
    let turns = [("star", star), ("square", DVec2::Y), ("hexagon", hexagon)];
    let bounced = |scene, bounces: u32, starts: &[_]| {
        let rows = compare(clock, (scene, bounces.into()), starts, &METHODS, verdict);
        rows.into_iter().map(move |row| Measurement {
            wrong: row.wrong.or(Some(0.0)),
            ..row.per_step(bounces)
        })
    };
    let mut rows = Vec::new();
    for (orbit, turn) in turns {
        for bounces in [1, 2, 3, 4, 6, 8, 12, 16, 24, 32, 64] {
            rows.extend(bounced(orbit, bounces, &orbits(turn, bounces)));
        }
    }
    let all = turns.map(|(_, turn)| orbits(turn, 16)).concat();
    rows.extend(bounced("overall", 16, &all));
    rows
}

/// Returns the error of the position. A ray is lost if its position or its direction is
/// more than a tenth off.
fn verdict(_: &(Corner, u32), exact: &Corner, end: Corner) -> Verdict {
    let [error, turned] = [0, 1].map(|i| end[i].distance(exact[i]));
    let is_lost = !(error <= 0.1 && turned <= 0.1);
    Verdict::Error(if is_lost { f64::INFINITY } else { error })
}
