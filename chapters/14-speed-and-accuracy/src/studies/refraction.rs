//! Refracted directions, near the critical angle and through many panes.

use crate::chart::{Axis, Chart, Quantity};
use crate::lanes::{self, InLanes, costs, refract_tangential};
use crate::study::{Choice, Clock, Study, Verdict, compare};
use crate::table::Measurement;
use glam::{DVec3, Vec3};
use measure::inputs::{Refraction, refractions};
use packets::Lanes;
use refraction::refract;
use refraction::scene::GLASS;
use wide::f64x8;

/// The textbook's formula, [`refract`] without its last step, which normalises the result,
/// and with it, and that in f64.
///
/// The inputs are unit vectors up to rounding, and the exact results are those of the very
/// unit vectors: near the critical angle that rounding counts more than the formula.
pub const STUDY: Study = Study {
    name: "refraction",
    title: "Refracted directions: the textbook’s formula, the book’s, and that in f64",
    measure,
    chosen: &[Choice::of("refract")],
    charts: &[
        Chart::new("critical angle", ANGLE, LARGEST)
            .titled("Near the critical angle of glass the law itself is steep, and f64 helps little"),
        Chart::new("panes", PANES, TURN)
            .titled("Through panes of glass: to make each direction a unit vector turns it"),
        Chart::new("lanes", TIME, ERROR)
            .titled("Into all media and out of them, at all angles"),
    ],
};

const ANGLE: Axis = (Quantity::Setting, "radians from the critical angle");
const LARGEST: Axis = (Quantity::Max, "largest error, in radians");
const PANES: Axis = (Quantity::Setting, "panes");
const TURN: Axis = (Quantity::Rms, "RMS angle, in radians");
const TIME: Axis = (Quantity::Ns, "nanoseconds per direction, in full registers");
const ERROR: Axis = (Quantity::Rms, "RMS error, in radians");

type Method = fn(&Refraction) -> Option<Vec3>;

const METHODS: [(&str, Method); 4] = [
    ("textbook", refract_by_textbook),
    ("tangential", refract_unnormalized),
    ("refract", |&(i, n, eta)| refract(i, n, eta)),
    ("f64", refract_in_f64),
];

/// Returns T = η (I + cosθᵢ N) − N √(1 − η² sin²θᵢ), where sin²θᵢ = 1 − cos²θᵢ.
fn refract_by_textbook(&(incident, normal, eta): &Refraction) -> Option<Vec3> {
    let cos_theta_i = -normal.dot(incident);
    let cos2_theta_t = 1.0 - eta * eta * (1.0 - cos_theta_i * cos_theta_i);
    let tangential = eta * (incident + cos_theta_i * normal);
    let normal = cos2_theta_t.sqrt() * normal;
    (cos2_theta_t > 0.0).then(|| tangential - normal)
}

fn refract_unnormalized(&(incident, normal, eta): &Refraction) -> Option<Vec3> {
    let tangential = incident - normal.dot(incident) * normal;
    let sin2_theta_t = eta * eta * tangential.dot(tangential);
    let normal = (1.0 - sin2_theta_t).sqrt() * normal;
    (sin2_theta_t < 1.0).then(|| eta * tangential - normal)
}

fn refract_in_f64(&(incident, normal, eta): &Refraction) -> Option<Vec3> {
    let (incident, normal) = (incident.as_dvec3(), normal.as_dvec3());
    let tangential = f64::from(eta) * (incident - normal.dot(incident) * normal);
    let cos2_theta_t = 1.0 - tangential.dot(tangential);
    let refracted = || tangential - cos2_theta_t.sqrt() * normal;
    (cos2_theta_t > 0.0).then(|| refracted().normalize().as_vec3())
}

fn measure(clock: &Clock) -> Vec<Measurement> {
    let mut rows = Vec::new();
    let glass = f64::from(GLASS);
    let critical_cosine = (1.0 - 1.0 / (glass * glass)).sqrt();
    for delta in [1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7] {
        let cases = refractions(|random| {
            let delta = if random.bool() { delta } else { -delta };
            // cos(a − δ), where δ is small.
            let cosine = critical_cosine * (1.0 - delta * delta / 2.0) + delta / glass;
            (cosine, GLASS)
        });
        let scene = ("critical angle", delta);
        rows.extend(compare(clock, scene, &cases, &METHODS, direction_error));
    }
    let mut panes = refractions(|random| (0.1 + 0.9 * random.f64(), 1.0 / GLASS));
    for ((incident, ..), exact) in &mut panes {
        *exact = Some(incident.as_dvec3().normalize());
    }
    for count in [1, 3, 10, 30, 100] {
        let methods = METHODS.map(|(name, refract)| {
            (name, move |case: &Refraction| {
                through(count, *case, refract)
            })
        });
        let setting = f64::from(count);
        let turns = compare(clock, ("panes", setting), &panes, &methods, direction_error);
        rows.extend(turns.into_iter().map(|row| row.per_step(2 * count)));
        let scene = ("length after panes", setting);
        let clock = Clock::STOPPED;
        rows.extend(compare(&clock, scene, &panes, &methods, length_error));
    }
    let cases = refractions(|random| {
        let [eta_i, eta_t] = [0, 1].map(|_| random.between(1.0, 3.0));
        (random.f64(), eta_i / eta_t)
    });
    // What the loop, the call and the input take of each method's time.
    let nothing: [(&str, Method); 1] = [("nothing", |_| None)];
    let no_error = |_: &_, _: &_, _| Verdict::Right;
    rows.extend(compare(clock, ("loop", 0.0), &cases, &nothing, no_error));
    let overall = ("overall", 0.0);
    let overall = compare(clock, overall, &cases, &METHODS, direction_error);
    let scene = ("length", 0.0);
    let stopped = Clock::STOPPED;
    rows.extend(compare(&stopped, scene, &cases, &METHODS, length_error));
    let cases: Vec<[Vec3; 3]> = cases
        .iter()
        .map(|((incident, normal, eta), _)| [*incident, *normal, Vec3::splat(*eta)])
        .collect();
    let formulas = vec![
        InLanes::of::<Lanes, _, _>(
            &cases,
            lanes::refract_by_textbook,
            lanes::refract_by_textbook,
        ),
        InLanes::of::<Lanes, _, _>(&cases, refract_tangential, refract_tangential),
        InLanes::of::<Lanes, _, _>(&cases, lanes::refract, lanes::refract),
        InLanes::of::<f64x8, _, _>(&cases, lanes::refract, lanes::refract),
    ];
    rows.extend(costs(clock, &overall, formulas));
    rows.extend(overall);
    rows
}

/// Returns the direction behind some parallel panes of glass, each entered and left.
fn through(panes: u32, case: Refraction, refract: Method) -> Option<Vec3> {
    let (incident, normal, _) = case;
    (0..panes).try_fold(incident, |incident, _| {
        let within = refract(&(incident, normal, 1.0 / GLASS))?;
        refract(&(within, normal, GLASS))
    })
}

/// Returns the angle between a result and the exact direction, as the chord: small angles
/// are as long.
fn direction_error(
    _: &Refraction,
    exact: &Option<DVec3>,
    result: Option<Vec3>,
) -> Verdict {
    match (result, exact) {
        (Some(result), Some(exact)) => {
            Verdict::Error(result.as_dvec3().normalize().distance(*exact))
        }
        (result, exact) => Verdict::of(result.is_some() == exact.is_some()),
    }
}

/// Returns the error of a result's length, which should be 1.
fn length_error(_: &Refraction, _: &Option<DVec3>, result: Option<Vec3>) -> Verdict {
    result.map_or(Verdict::Wrong, |result| {
        Verdict::Error(result.as_dvec3().length() - 1.0)
    })
}
