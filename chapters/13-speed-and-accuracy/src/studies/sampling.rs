//! Chapter 9: where to look in a pixel, and how often.

use crate::chart::{Axis, Chart, Quantity};
use crate::patterns::{PATTERNS, Sampler, Subject};
use crate::pictures::pixels;
use crate::sampling::{low_discrepancy, point};
use crate::study::{Clock, Measurement, Study, each};
use anti_aliasing::{adaptive, hash, jittered, regular};
use canvas::Pixel;
use glam::{DVec2, Vec2, Vec3};

/// Ways to place n × n samples in a pixel, on the patterns and on the still life; the
/// setting is n.
///
/// Work, samples of a pattern and rays of the still life, and nanoseconds are those of one
/// pixel. Errors are in linear light, against exact means, or that of 4096 samples for the
/// still life. In the rows of a scene's "order", the RMS column holds the p of an RMS error
/// that falls as work⁻ᵖ, from n = 2 on.
pub const STUDY: Study = Study {
    name: "sampling",
    title: "Where to look in a pixel, and how often",
    measure,
    charts: &[
        rms_by(
            Quantity::Work,
            "samples for a pixel",
            "A disc’s edge: any even spread beats chance, the grid most of all",
            "edge",
        ),
        rms_by(
            Quantity::Work,
            "samples for a pixel",
            "A floor to its horizon: the grid is hardly better than chance",
            "horizon",
        ),
        rms_by(
            Quantity::Ns,
            "nanoseconds for a pixel",
            "The still life: the rays cost more than their places",
            "still life",
        ),
    ],
    table: include_str!("../../../../book/src/studies/sampling.csv"),
};

const fn rms_by(
    quantity: Quantity,
    label: &'static str,
    title: &'static str,
    scene: &'static str,
) -> Chart {
    Chart {
        title,
        scene,
        x: Axis::new(quantity, label),
        y: Axis {
            quantity: Quantity::Rms,
            label: "RMS error, linear",
        },
        front: true,
    }
}

const SAMPLERS: [(&str, Sampler); 6] = [
    ("random", random),
    ("regular", regular),
    ("jittered", jittered),
    ("R2", r2),
    ("Owen-Sobol", low_discrepancy),
    ("adaptive", adaptive),
];

/// The mean of n × n samples, each anywhere in the pixel.
fn random(pixel: Pixel, n: u32, light: &dyn Fn(Vec2) -> Vec3) -> Vec3 {
    let mut random = fastrand::Rng::with_seed(u64::from(hash(pixel.x ^ hash(pixel.y))));
    let places = (0..n * n).map(|_| Vec2::new(random.f32(), random.f32()));
    let samples = places.map(|place| light(point(pixel, place)));
    samples.sum::<Vec3>() / (n * n) as f32
}

/// The mean of n × n samples of Roberts' sequence: from a place of each pixel's own in
/// steps of 1/g and 1/g², where g³ = g + 1, and from 1 on to 0.
///
/// Source: Roberts, "The Unreasonable Effectiveness of Quasirandom Sequences" (2018).
fn r2(pixel: Pixel, n: u32, light: &dyn Fn(Vec2) -> Vec3) -> Vec3 {
    const G: f64 = 1.324_717_957_244_746;
    // The whole pixel is 2³² wide, so that to wrap is to go from 1 on to 0.
    const WHOLE: f64 = (1_u64 << 32) as f64;
    const STEPS: [u32; 2] = [(WHOLE / G) as u32, (WHOLE / (G * G)) as u32];
    let x = hash(pixel.x ^ hash(pixel.y));
    let start = [x, hash(x)];
    let place = |i: u32| {
        let along = |axis: usize| start[axis].wrapping_add(i.wrapping_mul(STEPS[axis]));
        // An f32 holds 24 bits of them.
        Vec2::from_array([0, 1].map(|axis| (along(axis) >> 8) as f32)) / (1 << 24) as f32
    };
    let samples = (0..n * n).map(|i| light(point(pixel, place(i))));
    samples.sum::<Vec3>() / (n * n) as f32
}

const SETTINGS: [u32; 9] = [1, 2, 3, 4, 6, 8, 12, 16, 32];
/// So many pixels are timed.
const TIMED: usize = 64;

fn measure(clock: &Clock) -> Vec<Measurement> {
    let mut subjects: Vec<Subject> = PATTERNS.iter().map(Subject::of).collect();
    subjects.push(Subject::still_life());
    subjects
        .iter()
        .flat_map(|subject| compare(clock, subject))
        .collect()
}

fn compare(clock: &Clock, subject: &Subject) -> Vec<Measurement> {
    let pixels: Vec<Pixel> = pixels(subject.size).collect();
    let timed = pixels.iter().step_by(pixels.len() / TIMED + 1);
    let timed: Vec<Pixel> = timed.copied().collect();
    let mut rows = Vec::new();
    for n in SETTINGS.into_iter().filter(|&n| n <= subject.finest) {
        let job = |(_, sampler): (_, Sampler)| {
            each(&timed, move |&pixel| sampler(pixel, n, &*subject.light))
        };
        let times = clock.least(timed.len(), &mut SAMPLERS.map(job));
        for ((method, sampler), ns) in SAMPLERS.into_iter().zip(times) {
            let canvas = subject.paint(sampler, n);
            let pairs = canvas.light.iter().zip(&subject.means);
            let errors = pairs.map(|(light, mean)| light.as_dvec3() - mean);
            rows.push(Measurement {
                work: Some(canvas.rays as f64 / pixels.len() as f64),
                ns,
                ..Measurement::of(subject.name, method, f64::from(n))
                    .with_errors(errors.flat_map(|error| error.to_array()))
            });
        }
    }
    let orders = SAMPLERS.map(|(method, _)| {
        let of_it = |row: &&Measurement| row.method == method && row.setting > 1.0;
        Measurement {
            rms: order(rows.iter().filter(of_it)),
            ..Measurement::of(format!("{} order", subject.name), method, 0.0)
        }
    });
    rows.extend(orders);
    rows
}

/// An RMS error as small as this comes from the sum of the samples in f32.
const ROUNDING: f64 = 1e-6;

/// The p of an RMS error that falls as work⁻ᵖ, by least squares of its logarithm; `None`
/// if the work is always the same.
#[expect(clippy::disallowed_methods, reason = "a slope, in three digits")]
fn order<'a>(rows: impl Iterator<Item = &'a Measurement>) -> Option<f64> {
    let points = rows.filter_map(|row| Some(DVec2::new(row.work?, row.rms?)));
    let points = points.filter(|point| point.y > ROUNDING);
    let points: Vec<DVec2> = points.map(|point| point.map(f64::ln)).collect();
    let mean = points.iter().sum::<DVec2>() / points.len() as f64;
    let sum = |of: fn(DVec2) -> f64| -> f64 {
        points.iter().map(|&point| of(point - mean)).sum()
    };
    let squares = sum(|point| point.x * point.x);
    (squares > 0.0).then(|| -sum(|point| point.x * point.y) / squares)
}
