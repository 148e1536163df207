//! Shadow acne: how often rays that leave a surface hit an object that they should not hit,
//! or miss one that they should.

use crate::chart::{Axis, Chart, Quantity};
use crate::study::{Choice, Clock, Study, each};
use crate::table::Measurement;
use shadow_acne::{from_surface, with_scaled_offset, without_offset};
use trial::{Configuration, Ground, Method, Secondary, Tally, Trial};

/// Shadow rays on the planet: false hits, in percent of the points that the light reaches,
/// and lost shadows, in percent of those that it does not reach, over the scene's scale
/// (with the origin of the world in it) and over its distance from there (in its own units,
/// at scale 1). Both numbers count alike in "overall": their mean, over all these variants
/// of the scene. The setting there is the offset's length, and the times are those
/// at scale 1.
pub const STUDY: Study = Study {
    name: "acne",
    title: "Leaving a surface: without an offset, by a fixed one, by one that is scaled, and from the surface itself",
    measure,
    chosen: &[Choice::of("from the surface")],
    charts: &[
        Chart::new("false hits", SCALE, (Quantity::Wrong, "percent of the lit"))
            .titled("Acne: points in the light that are made dark"),
        Chart::new(
            "lost shadows",
            SCALE,
            (Quantity::Wrong, "percent of the dark"),
        )
        .titled("Lost shadows: points in the shadow that are lit"),
        Chart::new("overall", TIME, (Quantity::Wrong, "wrong, in percent"))
            .titled("Both, at all scales and distances, against the cost"),
    ],
};

const SCALE: Axis = (Quantity::Setting, "scale of the scene");
const TIME: Axis = (Quantity::Ns, "nanoseconds per shadow ray");

/// A name, a method, and whether the charts over the scale show it.
const METHODS: [(&str, Method, bool); 9] = [
    ("without offset", Method::Spawn(without_offset), true),
    ("fixed 10⁻⁶", Method::Offset(1e-6), true),
    ("fixed 10⁻⁵", Method::Offset(1e-5), false),
    ("fixed 10⁻⁴", Method::Offset(1e-4), true),
    ("fixed 10⁻³", Method::Offset(1e-3), false),
    ("fixed 10⁻²", Method::Offset(1e-2), true),
    ("fixed 0.1", Method::Offset(1e-1), false),
    ("scaled", Method::Spawn(with_scaled_offset), true),
    ("from the surface", Method::Spawn(from_surface), true),
];

fn measure(clock: &Clock) -> Vec<Measurement> {
    let scales = [1e-3, 1e-2, 0.1, 1.0, 10.0, 100.0, 1e3, 1e4, 1e5, 1e6];
    let scaled = scales.map(|scale| ("", scale, on_the_planet(scale, 0.0)));
    let distances = [1.0, 10.0, 100.0, 1e3, 1e4, 1e5];
    let away =
        distances.map(|distance| (", far away", distance, on_the_planet(1.0, distance)));
    let variants = scaled.into_iter().chain(away);
    let tallies: Vec<(&str, f64, [Tally; 9])> = variants
        .map(|(variant, setting, trial)| {
            (
                variant,
                setting,
                METHODS.map(|(_, method, _)| trial.tally(method)),
            )
        })
        .collect();
    let mut rows = Vec::new();
    for (variant, setting, tallies) in &tallies {
        for ((name, _, is_shown), tally) in METHODS.into_iter().zip(tallies) {
            let row = |scene, wrong| Measurement {
                wrong: Some(wrong),
                ..Measurement::of(format!("{scene}{variant}"), name, *setting)
            };
            if is_shown {
                rows.push(row("false hits", tally.false_hits()));
                rows.push(row("lost shadows", tally.leaks()));
            }
        }
    }
    let trial = &on_the_planet(1.0, 0.0);
    let jobs = METHODS.map(|(_, method, _)| {
        each(trial.rays(), move |ray| trial.is_occluded(method, ray))
    });
    let times = clock.min_of_rounds(trial.rays().len(), jobs);
    for (i, ((name, method, _), ns)) in METHODS.into_iter().zip(times).enumerate() {
        let of_both = tallies
            .iter()
            .map(|(.., tallies)| tallies[i].false_hits() + tallies[i].leaks());
        let (name, setting) = match method {
            Method::Spawn(_) => (name, 0.0),
            Method::Offset(length) => ("fixed", length.into()),
        };
        rows.push(Measurement {
            wrong: Some(of_both.sum::<f64>() / 2.0 / tallies.len() as f64),
            ns,
            ..Measurement::of("overall", name, setting)
        });
    }
    rows
}

fn on_the_planet(scale: f64, distance: f64) -> Trial {
    let configuration = Configuration {
        ground: Ground::Sphere,
        secondary: Secondary::Shadow,
        is_f64: false,
        scale,
        distance,
    };
    configuration.trial()
}
