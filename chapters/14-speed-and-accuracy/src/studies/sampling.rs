//! The positions of a pixel's samples, and their number.

use crate::chart::{Axis, Chart, Quantity};
use crate::error_map::level_error;
use crate::study::{Choice, Clock, Study, each};
use crate::table::Measurement;
use anti_aliasing::sobol::{image_point, low_discrepancy};
use anti_aliasing::{Sampler, adaptive, hash, jittered, regular};
use canvas::Pixel;
use glam::{DVec2, Vec2, Vec3};
use measure::Random;
use measure::subjects::{Subject, adaptive_linear, subjects};

/// Samplers that take n × n samples of a pixel, of patterns and of the still life; the
/// setting is n.
///
/// Work, samples of a pattern and rays of the still life, and nanoseconds are those of one
/// pixel. Errors are in levels, against exact means, or that of 4096 samples for the still
/// life. In the rows of a scene's "order", the RMS column holds the p of an RMS error, in
/// linear light, that falls as work⁻ᵖ, from n = 2 on.
///
/// "Adaptive" compares a pixel's first samples as levels, "adaptive, linear" as light.
pub const STUDY: Study = Study {
    name: "sampling",
    title: "Where to look in a pixel, and how often",
    measure,
    chosen: &[Choice::at("regular", 4.0)],
    charts: &[
        Chart::new("edge", SAMPLES, ERROR)
            .titled("A disc’s edge: any even spread beats chance"),
        Chart::new("horizon", SAMPLES, ERROR)
            .titled("A floor to its horizon: the grid is hardly better than chance"),
        Chart::new("still life", TIME, ERROR)
            .titled("The still life: the rays cost more than choosing their positions"),
    ],
};

const SAMPLES: Axis = (Quantity::Work, "samples per pixel (at the marks: n)");
const TIME: Axis = (Quantity::Ns, "nanoseconds per pixel (at the marks: n)");
const ERROR: Axis = (Quantity::Rms, "RMS error, in levels");

/// The samplers that the study compares, with their names.
pub const SAMPLERS: [(&str, Sampler); 7] = [
    ("random", random),
    ("regular", regular),
    ("jittered", jittered),
    ("R2", r2),
    ("Owen-Sobol", low_discrepancy),
    ("adaptive", adaptive),
    ("adaptive, linear", adaptive_linear),
];

/// Returns the mean of n × n samples, each anywhere in the pixel.
fn random(pixel: Pixel, n: u32, radiance: &dyn Fn(Vec2) -> Vec3) -> Vec3 {
    let mut random = Random::new(pixel.x ^ hash(pixel.y));
    let position = |_| Vec2::new(random.f32(), random.f32());
    let samples = (0..n * n)
        .map(position)
        .map(|position| radiance(image_point(pixel, position)));
    samples.sum::<Vec3>() / (n * n) as f32
}

/// Returns the mean of n × n samples of Roberts' sequence: from a position of each pixel's
/// own in steps of 1/g and 1/g², where g³ = g + 1, modulo 1.
///
/// Source: Roberts, "The Unreasonable Effectiveness of Quasirandom Sequences" (2018).
fn r2(pixel: Pixel, n: u32, radiance: &dyn Fn(Vec2) -> Vec3) -> Vec3 {
    const G: f64 = 1.324_717_957_244_746;
    // The whole pixel is 2³² wide, so that integers wrap modulo 1.
    const WHOLE: f64 = (1_u64 << 32) as f64;
    const STEPS: [u32; 2] = [(WHOLE / G) as u32, (WHOLE / (G * G)) as u32];
    let x = hash(pixel.x ^ hash(pixel.y));
    let start = [x, hash(x)];
    let position = |i: u32| {
        let along = |axis: usize| start[axis].wrapping_add(i.wrapping_mul(STEPS[axis]));
        // An f32 holds 24 bits of them.
        Vec2::from_array([0, 1].map(|axis| (along(axis) >> 8) as f32)) / (1 << 24) as f32
    };
    let samples = (0..n * n).map(|i| radiance(image_point(pixel, position(i))));
    samples.sum::<Vec3>() / (n * n) as f32
}

fn measure(clock: &Clock) -> Vec<Measurement> {
    subjects()
        .iter()
        .flat_map(|subject| compare(clock, subject))
        .collect()
}

fn compare(clock: &Clock, subject: &Subject) -> Vec<Measurement> {
    let pixels: Vec<Pixel> = Pixel::all(subject.size).collect();
    // 64 of them are timed.
    let timed = pixels.iter().step_by(pixels.len() / 64 + 1);
    let timed: Vec<Pixel> = timed.copied().collect();
    let settings = [1, 2, 3, 4, 6, 8, 12, 16, 32].into_iter();
    let (mut rows, mut in_light) = (Vec::new(), Vec::new());
    for n in settings.filter(|&n| n <= subject.finest) {
        let job = |(_, sampler): (_, Sampler)| {
            each(&timed, move |&pixel| sampler(pixel, n, &*subject.radiance))
        };
        let times = clock.min_of_rounds(timed.len(), SAMPLERS.map(job));
        for ((method, sampler), ns) in SAMPLERS.into_iter().zip(times) {
            let canvas = subject.render(sampler, n);
            let pairs = || canvas.radiance.iter().zip(&subject.means);
            let errors = pairs().map(|(radiance, mean)| radiance.as_dvec3() - mean);
            let row = Measurement {
                work: Some(canvas.rays as f64 / pixels.len() as f64),
                ns,
                ..Measurement::of(subject.name, method, f64::from(n))
            };
            let errors = errors.flat_map(|error| error.to_array());
            in_light.push(row.clone().with_errors(errors));
            let errors = pairs().map(|(radiance, mean)| level_error(*radiance, *mean));
            rows.push(row.with_errors(errors));
        }
    }
    let orders = SAMPLERS.map(|(method, _)| {
        let of_it = in_light
            .iter()
            .filter(|row| row.method == method && row.setting > 1.0);
        Measurement {
            rms: order(of_it),
            ..Measurement::of(format!("{} order", subject.name), method, 0.0)
        }
    });
    rows.extend(orders);
    rows
}

/// Returns the p of an RMS error that falls as work⁻ᵖ, by least squares of its logarithm.
/// `None` if the work is always the same.
fn order<'a>(rows: impl Iterator<Item = &'a Measurement>) -> Option<f64> {
    let points = rows.filter_map(|row| Some(DVec2::new(row.work?, row.rms?)));
    // A smaller RMS error comes from the sum of the samples in f32.
    let points = points.filter(|point| point.y > 1e-6);
    let points: Vec<DVec2> = points.map(|point| point.map(libm::log)).collect();
    let mean = points.iter().sum::<DVec2>() / points.len() as f64;
    let sum =
        |of: fn(DVec2) -> f64| points.iter().map(|&point| of(point - mean)).sum::<f64>();
    let squares = sum(|point| point.x * point.x);
    (squares > 0.0).then(|| -sum(|point| point.x * point.y) / squares)
}
