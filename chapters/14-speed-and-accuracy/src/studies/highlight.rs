//! xⁿ, which makes a highlight.

use crate::chart::{Axis, Chart, Quantity};
use crate::study::{Choice, Clock, Study, Verdict, compare};
use crate::table::Measurement;
use shading::powi;

/// Repeated squaring, the standard library's powf and 2 to the power of n log₂ x, the
/// portable powf of the libm crate, and Schlick's fraction.
pub const STUDY: Study = Study {
    name: "highlight",
    title: "A highlight’s power: by squaring, by logarithms, and by Schlick’s fraction",
    measure,
    chosen: &[Choice::of("squaring")],
    charts: &[
        Chart::new("highlight", SHININESS, LARGEST)
            .titled("Squaring is wrong by n roundings, Schlick’s fraction by a fifth"),
        Chart::new("highlight", SHININESS, TIME)
            .titled("Squaring takes longer the shinier the surface is"),
        Chart::new("overall", TIME, ERROR).titled("Powers from 1 to 10,000"),
    ],
};

const SHININESS: Axis = (Quantity::Setting, "shininess n");
const LARGEST: Axis = (Quantity::Max, "largest error, of full light");
const TIME: Axis = (Quantity::Ns, "nanoseconds per power");
const ERROR: Axis = (Quantity::Rms, "RMS error, of full light");

/// x and n.
type Case = (f32, u32);

type Method = fn(&Case) -> f32;

/// A name, the function that is timed, and the one whose errors are measured: the last bits
/// of the standard library's powers depend on the platform. Those of the libm crate are the
/// same everywhere, and as exact to within an ulp.
const METHODS: [(&str, Method, Method); 5] = [
    ("squaring", by_squaring, by_squaring),
    ("powf", by_powf, by_portable_powf),
    ("exp2 of log2", by_exp2, |&(x, n)| {
        libm::exp2f(n as f32 * libm::log2f(x))
    }),
    ("powf of libm", by_portable_powf, by_portable_powf),
    ("Schlick", schlick, schlick),
];

fn by_squaring(&(x, n): &Case) -> f32 {
    powi(x, n)
}

#[expect(clippy::disallowed_methods, reason = "it is timed, and nothing else")]
fn by_powf(&(x, n): &Case) -> f32 {
    x.powf(n as f32)
}

fn by_portable_powf(&(x, n): &Case) -> f32 {
    libm::powf(x, n as f32)
}

#[expect(clippy::disallowed_methods, reason = "it is timed, and nothing else")]
fn by_exp2(&(x, n): &Case) -> f32 {
    (n as f32 * x.log2()).exp2()
}

/// Returns x / (n − n x + x), which is as high and as steep as the power at x = 1.
///
/// Source: Schlick, "A Fast Alternative to Phong's Specular Model", Graphics Gems IV
/// (1994).
fn schlick(&(x, n): &Case) -> f32 {
    let n = n as f32;
    x / (n - n * x + x)
}

fn measure(clock: &Clock) -> Vec<Measurement> {
    let (mut rows, mut all) = (Vec::new(), Vec::new());
    for n in [1, 2, 5, 10, 20, 50, 100, 200, 500, 1000, 2000, 5000, 10_000] {
        let cases = across(n);
        rows.extend(powers(clock, ("highlight", f64::from(n)), &cases));
        all.extend(cases);
    }
    rows.extend(powers(clock, ("overall", 0.0), &all));
    rows
}

fn powers(clock: &Clock, scene: (&str, f64), cases: &[(Case, f64)]) -> Vec<Measurement> {
    let [timed, portable] = [
        METHODS.map(|(name, timed, _)| (name, timed)),
        METHODS.map(|(name, _, portable)| (name, portable)),
    ];
    let verdict = |_: &_, exact: &f64, term| Verdict::difference(term, *exact);
    let times = compare(clock, scene, cases, &timed, verdict);
    let errors = compare(&Clock::STOPPED, scene, cases, &portable, verdict);
    let both = times.into_iter().zip(errors);
    both.map(|(time, errors)| Measurement {
        ns: time.ns,
        ..errors
    })
    .collect()
}

/// Returns cases across a highlight, from its middle, x = 1, to its end, at e⁻²⁰ or x = 0,
/// with the exact powers.
fn across(n: u32) -> Vec<(Case, f64)> {
    let width = if n > 20 { 20.0 / f64::from(n) } else { 1.0 };
    let case = |i| {
        let x = (1.0 - width * f64::from(i) / 5000.0) as f32;
        ((x, n), libm::pow(f64::from(x), f64::from(n)))
    };
    (0..=5000).map(case).collect()
}
