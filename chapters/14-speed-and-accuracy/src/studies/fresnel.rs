//! The reflectance of an interface, exactly and roughly.

use crate::chart::{Axis, Chart, Quantity};
use crate::study::{Choice, Clock, Study, Verdict, compare};
use crate::table::Measurement;
use fresnel::{fresnel, schlick};
use measure::inputs::on_a_disc;

/// Fresnel's formulas as they stand and factored, Schlick's approximation with the classic
/// mistake and without, and a constant; for the angles in the pixels of a ball's disc, into
/// all media and out of them.
pub const STUDY: Study = Study {
    name: "fresnel",
    title: "Reflectance: Fresnel’s formulas, Schlick’s approximation, and a constant",
    measure,
    chosen: &[Choice::of("textbook")],
    charts: &[
        Chart::new("entering", INDEX, LARGEST)
            .titled("On entering, Schlick is off by hundredths for glass, by far more near an index of 1"),
        Chart::new("leaving", INDEX, LARGEST)
            .titled("On leaving, the wrong cosine makes Schlick wrong by nearly all there is"),
        Chart::new("overall", TIME, ERROR)
            .titled("Into media from 1.1 to 3, and out of them"),
    ],
};

const INDEX: Axis = (Quantity::Setting, "index of refraction, less 1");
const LARGEST: Axis = (Quantity::Max, "largest error of the reflectance");
const TIME: Axis = (Quantity::Ns, "nanoseconds per reflectance");
const ERROR: Axis = (Quantity::Rms, "RMS error of the reflectance");

/// The cosine of the angle of incidence, and the indices on this side and on the far one.
type Case = [f32; 3];

type Method = fn(&Case) -> f32;

const METHODS: [(&str, Method); 5] = [
    ("textbook", |&[c, eta_i, eta_t]| fresnel(c, eta_i, eta_t)),
    ("factored", factored),
    ("wrong Schlick", |&[c, eta_i, eta_t]| {
        schlick(c, eta_i, eta_t)
    }),
    ("Schlick", schlick_by_larger_angle),
    ("constant", normal_incidence),
];

/// Returns the reflectance by Fresnel's formulas in c = cosθᵢ and g = ηₜ/ηᵢ cosθₜ, with
/// g² − c² as a product: so nothing is lost where the indices are nearly equal.
///
/// Source: Cook and Torrance, "A Reflectance Model for Computer Graphics" (1982); g − c is
/// here (g² − c²) / (g + c).
fn factored(&[c, eta_i, eta_t]: &Case) -> f32 {
    let difference = (eta_t - eta_i) * (eta_t + eta_i) / (eta_i * eta_i);
    let g_squared = c * c + difference;
    if !(g_squared > 0.0) {
        return 1.0;
    }
    let sum = g_squared.sqrt() + c;
    let r_perp = difference / (sum * sum);
    let ratio = (c * sum - 1.0) / (c * difference / sum + 1.0);
    r_perp * r_perp * (1.0 + ratio * ratio) / 2.0
}

/// Returns Schlick's approximation in the larger of the two angles, and 1 for total
/// reflection.
fn schlick_by_larger_angle(&[cos_theta_i, eta_i, eta_t]: &Case) -> f32 {
    if eta_i <= eta_t {
        return schlick(cos_theta_i, eta_i, eta_t);
    }
    let eta = eta_i / eta_t;
    let sin2_theta_t = eta * eta * (1.0 - cos_theta_i * cos_theta_i);
    if !(sin2_theta_t < 1.0) {
        return 1.0;
    }
    schlick((1.0 - sin2_theta_t).sqrt(), eta_i, eta_t)
}

/// Returns the reflectance at normal incidence, whatever the angle.
fn normal_incidence(&[_, eta_i, eta_t]: &Case) -> f32 {
    let r = (eta_i - eta_t) / (eta_i + eta_t);
    r * r
}

fn measure(clock: &Clock) -> Vec<Measurement> {
    let (mut rows, mut all) = (Vec::new(), Vec::new());
    let verdict = |_: &_, exact: &f64, result| Verdict::difference(result, *exact);
    for less_one in [3e-4, 1e-3, 1e-2, 0.1, 0.33, 0.5, 0.8, 1.42, 2.0] {
        let index = (1.0 + less_one) as f32;
        for (scene, eta_i, eta_t) in [("entering", 1.0, index), ("leaving", index, 1.0)] {
            let cases = on_a_disc(eta_i, eta_t);
            rows.extend(compare(clock, (scene, less_one), &cases, &METHODS, verdict));
            if less_one >= 0.1 {
                all.extend(cases);
            }
        }
    }
    rows.extend(compare(clock, ("overall", 0.0), &all, &METHODS, verdict));
    rows
}
