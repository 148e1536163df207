//! Chapter 7: bent directions, near the critical angle and through many panes.

use crate::chart::{Axis, Chart, Quantity};
use crate::study::{Clock, Measurement, Study, Verdict, compare, direction};
use glam::{DVec3, Vec3};
use oracle::Border;
use refraction::refract;

/// The slide's formula, the chapter's without its last step, which makes the result a unit
/// vector, and with it, and that in f64.
///
/// What they take are unit vectors up to rounding, and right is what belongs to the very
/// unit vectors: near the critical angle that rounding counts more than the formula.
pub const STUDY: Study = Study {
    name: "refraction",
    title: "Bent directions: the slide’s formula, the chapter’s, and that in f64",
    measure,
    charts: &[
        Chart {
            title: "Near the critical angle of glass the law itself is steep, and f64 helps little",
            scene: "critical angle",
            x: Axis::new(Quantity::Setting, "radians from the critical angle"),
            y: Axis::new(Quantity::Max, "largest error, in radians"),
            front: false,
        },
        Chart {
            title: "Through panes of glass: to make each direction a unit vector turns it",
            scene: "panes",
            x: Axis::new(Quantity::Setting, "panes"),
            y: Axis::new(Quantity::Rms, "RMS angle, in radians"),
            front: false,
        },
        Chart {
            title: "Into all media and out of them, at all angles",
            scene: "overall",
            x: Axis::new(Quantity::Ns, "nanoseconds for one direction"),
            y: Axis::new(Quantity::Rms, "RMS error, in radians"),
            front: true,
        },
    ],
    table: include_str!("../../../../book/src/studies/refraction.csv"),
};

/// What [`refract`] takes: two directions, of which the second is the normal and faces the
/// first, and η = η₁/η₂.
type Case = (Vec3, Vec3, f32);

type Method = fn(&Case) -> Option<Vec3>;

const METHODS: [(&str, Method); 4] = [
    ("slide", refract_by_slide),
    ("tangential", refract_without_normalising),
    ("refract", |&(incident, normal, eta)| {
        refract(incident, normal, eta)
    }),
    ("f64", refract_in_f64),
];

/// T = η (I + cosθ₁ N) − N √(1 − η² sin²θ₁), where sin²θ₁ = 1 − cos²θ₁.
///
/// Source: the talk's "Refractions" slide.
fn refract_by_slide(&(incident, normal, eta): &Case) -> Option<Vec3> {
    let cos_theta_i = -normal.dot(incident);
    let cos2_theta_t = 1.0 - eta * eta * (1.0 - cos_theta_i * cos_theta_i);
    if !(cos2_theta_t > 0.0) {
        return None;
    }
    Some(eta * (incident + cos_theta_i * normal) - cos2_theta_t.sqrt() * normal)
}

/// [`refract`] but for its last step.
fn refract_without_normalising(&(incident, normal, eta): &Case) -> Option<Vec3> {
    let along = incident - normal.dot(incident) * normal;
    let sin2_theta_t = eta * eta * along.dot(along);
    if !(sin2_theta_t < 1.0) {
        return None;
    }
    Some(eta * along - (1.0 - sin2_theta_t).sqrt() * normal)
}

/// [`refract`] in f64.
fn refract_in_f64(&(incident, normal, eta): &Case) -> Option<Vec3> {
    let [incident, normal] = [incident, normal].map(|vector| vector.as_dvec3());
    let eta = f64::from(eta);
    let along = incident - normal.dot(incident) * normal;
    let sin2_theta_t = eta * eta * along.dot(along);
    if !(sin2_theta_t < 1.0) {
        return None;
    }
    let refracted = eta * along - (1.0 - sin2_theta_t).sqrt() * normal;
    Some(refracted.normalize().as_vec3())
}

/// Through parallel panes, and out of the last.
fn through(panes: u32, &(incident, normal, _): &Case, refract: Method) -> Option<Vec3> {
    (0..panes).try_fold(incident, |incident, _| {
        let within = refract(&(incident, normal, 1.0 / GLASS))?;
        refract(&(within, normal, GLASS))
    })
}

const GLASS: f32 = 1.5;

fn measure(clock: &Clock) -> Vec<Measurement> {
    let mut rows = Vec::new();
    for delta in [1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7] {
        let cases = cases(|random| {
            let delta = if random.bool() { delta } else { -delta };
            (near_critical(delta), GLASS)
        });
        let cases: Vec<_> = cases.map(refracted).collect();
        let scene = ("critical angle", delta);
        rows.extend(compare(clock, scene, &cases, &METHODS, turned));
    }
    let cases_of_panes = cases(|random| (0.1 + 0.9 * random.f64(), 1.0 / GLASS));
    let straight_on = |case: Case| (case, Some(unit(case.0)));
    let panes: Vec<_> = cases_of_panes.map(straight_on).collect();
    for count in [1, 3, 10, 30, 100] {
        let methods = METHODS.map(|(name, refract)| {
            (name, move |case: &Case| through(count, case, refract))
        });
        let setting = f64::from(count);
        let turns = compare(clock, ("panes", setting), &panes, &methods, turned);
        rows.extend(turns.into_iter().map(|row| row.for_one_of(2 * count)));
        let scene = ("length after panes", setting);
        rows.extend(compare(&Clock::STOPPED, scene, &panes, &methods, stretched));
    }
    let cases = cases(|random| {
        let [eta_i, eta_t] = [0, 1].map(|_| 1.0 + 2.0 * random.f32());
        (random.f64(), eta_i / eta_t)
    });
    let cases: Vec<_> = cases.map(refracted).collect();
    rows.extend(compare(clock, ("overall", 0.0), &cases, &METHODS, turned));
    let scene = ("length overall", 0.0);
    rows.extend(compare(&Clock::STOPPED, scene, &cases, &METHODS, stretched));
    rows
}

/// The cosine of an angle that is some `delta` less than glass's critical one.
fn near_critical(delta: f64) -> f64 {
    let sine = 1.0 / f64::from(GLASS);
    let cosine = (1.0 - sine * sine).sqrt();
    // cos(a − δ), where δ is small.
    cosine * (1.0 - delta * delta / 2.0) + sine * delta
}

/// Any normals, and at angles of the given cosines to them, incident directions.
fn cases(
    mut cosine_and_eta: impl FnMut(&mut fastrand::Rng) -> (f64, f32),
) -> impl Iterator<Item = Case> {
    let mut random = fastrand::Rng::with_seed(7);
    (0..5000).map(move |_| {
        let (cosine, eta) = cosine_and_eta(&mut random);
        let normal = direction(&mut random);
        let aside = normal.cross(direction(&mut random)).normalize();
        let incident = (1.0 - cosine * cosine).sqrt() * aside - cosine * normal;
        (incident.as_vec3(), normal.as_vec3(), eta)
    })
}

fn unit(vector: Vec3) -> DVec3 {
    vector.as_dvec3().normalize()
}

/// With the right answer.
fn refracted(case: Case) -> (Case, Option<DVec3>) {
    let (incident, normal, eta) = case;
    let border = Border::new(unit(incident), unit(normal), [f64::from(eta), 1.0]);
    (case, border.refracted)
}

/// By which angle an answer is off: small ones are as good as their chords.
fn turned(_: &Case, exact: &Option<DVec3>, answer: Option<Vec3>) -> Verdict {
    match (answer, exact) {
        (Some(answer), Some(exact)) => Verdict::Off(unit(answer).distance(*exact)),
        (answer, exact) => Verdict::of(answer.is_some() == exact.is_some()),
    }
}

/// By how much an answer is longer than 1, or shorter.
fn stretched(_: &Case, _: &Option<DVec3>, answer: Option<Vec3>) -> Verdict {
    match answer {
        Some(answer) => Verdict::Off(answer.as_dvec3().length() - 1.0),
        None => Verdict::Right,
    }
}
