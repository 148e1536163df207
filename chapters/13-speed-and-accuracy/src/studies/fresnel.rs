//! Chapter 8: how much is mirrored, exactly and roughly.

use crate::chart::{Axis, Chart, Quantity};
use crate::study::{Clock, Measurement, Study, Verdict, compare};
use fresnel::{fresnel, schlick};
use glam::DVec3;
use oracle::Border;

/// Fresnel's formulas as the slide has them and multiplied out, Schlick's approximation
/// with the classic mistake and mended, and a constant; as the pixels of a ball's disc
/// need them, into all media and out of them.
pub const STUDY: Study = Study {
    name: "fresnel",
    title: "How much is mirrored: Fresnel’s formulas, Schlick’s approximation, and a constant",
    measure,
    charts: &[
        Chart {
            title: "On entering, Schlick is off by hundredths for glass, by far more near an index of 1",
            scene: "entering",
            x: Axis::new(Quantity::Setting, "index of refraction, less 1"),
            y: Axis::new(Quantity::Max, "largest error of the share"),
            front: false,
        },
        Chart {
            title: "On leaving, the wrong cosine makes Schlick wrong by nearly all there is",
            scene: "leaving",
            x: Axis::new(Quantity::Setting, "index of refraction, less 1"),
            y: Axis::new(Quantity::Max, "largest error of the share"),
            front: false,
        },
        Chart {
            title: "Into media from 1.1 to 3, and out of them",
            scene: "overall",
            x: Axis::new(Quantity::Ns, "nanoseconds for one share"),
            y: Axis::new(Quantity::Rms, "RMS error of the share"),
            front: true,
        },
    ],
    table: include_str!("../../../../book/src/studies/fresnel.csv"),
};

/// The cosine of the angle of incidence, and the indices on this side and on the far one.
type Case = [f32; 3];

type Method = fn(&Case) -> f32;

const METHODS: [(&str, Method); 5] = [
    ("slide", |&[cosine, eta_i, eta_t]| {
        fresnel(cosine, eta_i, eta_t)
    }),
    ("factored", factored),
    ("wrong Schlick", |&[cosine, eta_i, eta_t]| {
        schlick(cosine, eta_i, eta_t)
    }),
    ("Schlick", schlick_by_larger_angle),
    ("constant", straight_on),
];

/// Fresnel's formulas by c = cosθ₁ and g = η₂/η₁ cosθ₂, with g² − c² as a product: so
/// nothing is lost where the indices are nearly equal.
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

/// Schlick's approximation in the larger of the two angles, and total reflection.
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

/// What is mirrored at no angle at all.
fn straight_on(&[_, eta_i, eta_t]: &Case) -> f32 {
    let r = (eta_i - eta_t) / (eta_i + eta_t);
    r * r
}

fn measure(clock: &Clock) -> Vec<Measurement> {
    let (mut rows, mut all) = (Vec::new(), Vec::new());
    let judge = |_: &_, exact: &f64, share| Verdict::Off(f64::from(share) - exact);
    for less_one in [3e-4, 1e-3, 1e-2, 0.1, 0.33, 0.5, 0.8, 1.42, 2.0] {
        let index = (1.0 + less_one) as f32;
        for (scene, eta_i, eta_t) in [("entering", 1.0, index), ("leaving", index, 1.0)] {
            let cases = on_a_disc(eta_i, eta_t);
            rows.extend(compare(clock, (scene, less_one), &cases, &METHODS, judge));
            if less_one >= 0.1 {
                all.extend(cases);
            }
        }
    }
    rows.extend(compare(clock, ("overall", 0.0), &all, &METHODS, judge));
    rows
}

/// All angles from 0 to 90°, each as often as on the disc that a ball is seen as: the
/// squares of their sines are evenly spaced. With the right shares.
fn on_a_disc(eta_i: f32, eta_t: f32) -> Vec<(Case, f64)> {
    let case = |i| {
        let cosine = (1.0 - f64::from(i) / 10_000.0).sqrt() as f32;
        let c = f64::from(cosine);
        let incident = DVec3::new(((1.0 - c) * (1.0 + c)).sqrt(), -c, 0.0);
        let border = Border::new(incident, DVec3::Y, [eta_i, eta_t].map(f64::from));
        ([cosine, eta_i, eta_t], border.reflectance)
    };
    (0..=10_000).map(case).collect()
}
