//! Chapter 12: what a packet gains, and how many of its rays stay together.

use crate::chart::{Axis, Chart, Quantity};
use crate::pictures::{by_packets, frame, one_by_one, plain_sight, pool};
use crate::study::{Clock, Job, Measurement, Study};
use canvas::{Canvas, Picture, rays_so_far};
use glam::{UVec2, Vec3};
use packets::{LANES, packets_so_far};
use rayon::ThreadPool;
use reflection::{MAX_DEPTH, Reach};
use refraction::Material;
use shadows::Scene;
use std::hint::black_box;

/// One ray at once or a packet of sixteen: lanes in use, lanes that stay live from bounce
/// to bounce, and threads.
///
/// Nanoseconds are those of one pixel. Of "lanes", the setting is how many of the sixteen
/// hold a ray of the camera's, and work is what is cast for a pixel, rays or packets; of
/// "divergence", the bounces before, and the live lanes of the packets that are cast
/// there; of "all rays", those of all packets; of "threads", their number, and rays for a
/// pixel. Errors are in linear levels, and wrong are pixels with any other bit, against
/// one ray at once and one thread.
pub const STUDY: Study = Study {
    name: "packets",
    title: "What sixteen rays at once gain: lanes in use, lanes that stay together, threads",
    measure,
    charts: &[
        Chart {
            title: "The still life: every lane in use makes a pixel cheaper",
            scene: "lanes",
            x: Axis::new(Quantity::Setting, "pixels in a packet"),
            y: Axis::new(Quantity::Ns, "nanoseconds for a pixel"),
            front: false,
        },
        Chart {
            title: "Divergence: the more bounces, the emptier the packets",
            scene: "divergence",
            x: Axis::new(Quantity::Setting, "bounces"),
            y: Axis::new(Quantity::Work, "live lanes of sixteen"),
            front: false,
        },
        Chart {
            title: "The still life: threads help as far as there are processors",
            scene: "threads",
            x: Axis::new(Quantity::Setting, "threads"),
            y: Axis::new(Quantity::Ns, "nanoseconds for a pixel"),
            front: false,
        },
    ],
    table: include_str!("../../../../book/src/studies/packets.csv"),
};

/// Whose rows are whole packets, whatever their lanes.
const SMALL: UVec2 = UVec2::new(160, 120);
/// Enough for a thread to be worth its start.
const LARGE: UVec2 = UVec2::new(320, 240);
/// Deeper, hardly a packet is left.
const DEEPEST: u32 = 8;

fn measure(clock: &Clock) -> Vec<Measurement> {
    let mut rows = lanes(clock);
    rows.extend(divergence("still life", "still-life"));
    rows.extend(divergence("nested glass", "nested"));
    rows.extend(threads(clock));
    rows
}

/// The still life by n × n samples for a pixel, one ray at once and in packets.
fn still_life(n: u32) -> [Picture; 2] {
    let sight = plain_sight("still-life");
    let reach = Reach::new(MAX_DEPTH);
    [
        one_by_one(sight.clone(), reach, n),
        by_packets(sight, reach, n),
    ]
}

/// A picture's light, and what was cast for it: rays and packets.
fn cast(picture: &Picture, size: UVec2, lanes: usize) -> (Vec<Vec3>, [u64; 2]) {
    let before = [rays_so_far(), packets_so_far()];
    let light = frame(picture, size, lanes);
    let after = [rays_so_far(), packets_so_far()];
    (light, [after[0] - before[0], after[1] - before[1]])
}

fn lanes(clock: &Clock) -> Vec<Measurement> {
    let names = [
        "one by one",
        "packets",
        "one by one, 4 × 4",
        "packets, 4 × 4",
    ];
    let pictures = [1, 4].map(still_life);
    let right = [&pictures[0][0], &pictures[1][0]].map(|one| frame(one, SMALL, LANES));
    let cases =
        [1, 2, 4, 8, LANES].map(|lanes| (0..names.len()).map(move |i| (lanes, i)));
    let cases: Vec<_> = cases.into_iter().flatten().collect();
    let picture = |i: usize| &pictures[i / 2][i % 2];
    let job = |&(lanes, i): &(usize, usize)| -> Job {
        Box::new(move || {
            black_box(frame(picture(i), SMALL, lanes));
        })
    };
    let pixels = right[0].len();
    let times = clock.least(pixels, &mut cases.iter().map(job).collect::<Vec<_>>());
    let row = |(&(lanes, i), ns): (&(usize, usize), Option<f64>)| {
        let (light, [rays, packets]) = cast(picture(i), SMALL, lanes);
        let work = if packets == 0 { rays } else { packets };
        let row = Measurement {
            work: Some(work as f64 / pixels as f64),
            ns,
            ..Measurement::of("lanes", names[i], lanes as f64)
        };
        against(&right[i / 2], &light, row)
    };
    cases.iter().zip(times).map(row).collect()
}

/// The row of a picture with its errors against the right one.
fn against(right: &[Vec3], light: &[Vec3], row: Measurement) -> Measurement {
    let pairs = || right.iter().zip(light);
    let bits = |light: &Vec3| light.to_array().map(f32::to_bits);
    let wrong = pairs().filter(|(right, light)| bits(right) != bits(light));
    let error = |(right, light): (&Vec3, &Vec3)| {
        255.0 * f64::from((light - right).abs().max_element())
    };
    Measurement {
        wrong: Some(100.0 * wrong.count() as f64 / right.len() as f64),
        ..row.with_errors(pairs().map(error))
    }
}

/// How full the packets are that a bounce casts: what one bounce more casts in addition.
/// Without lamps, none of them goes to a lamp; the difference does.
fn divergence(name: &str, scene: &str) -> Vec<Measurement> {
    let (lit, camera) = plain_sight(scene);
    let dark = Scene {
        lights: Vec::new(),
        ..lit.clone()
    };
    let up_to = |scene: &Scene<Material>, depth| {
        let picture = by_packets((scene.clone(), camera), Reach::new(depth), 1);
        cast(&picture, LARGE, LANES).1.map(|count| count as f64)
    };
    let row = |scene, method: String, bounces, [rays, packets]: [f64; 2]| Measurement {
        work: (packets > 0.0).then_some(rays / packets),
        ..Measurement::of(scene, method, bounces)
    };
    let less = |[a, b]: [f64; 2], [c, d]: [f64; 2]| [a - c, b - d];
    let mut rows = Vec::new();
    let (mut onwards, mut all) = ([0.0; 2], [0.0; 2]);
    for depth in 0..=DEEPEST {
        let [deeper, deeper_all] = [up_to(&dark, depth), up_to(&lit, depth)];
        let now = less(deeper, onwards);
        let now_all = less(deeper_all, all);
        (onwards, all) = (deeper, deeper_all);
        let bounces = f64::from(depth);
        rows.push(row("divergence", name.to_string(), bounces, now));
        let to_lamps = format!("{name}, to lamps");
        rows.push(row("divergence", to_lamps, bounces, less(now_all, now)));
    }
    rows.push(row(
        "all rays",
        name.to_string(),
        0.0,
        up_to(&lit, MAX_DEPTH),
    ));
    rows
}

fn threads(clock: &Clock) -> Vec<Measurement> {
    let names = ["one by one", "packets"];
    let pictures = still_life(1);
    let right = frame(&pictures[0], LARGE, LANES);
    let pools = [1, 2, 4, 8].map(|threads| (threads, pool(threads)));
    let paint = |pool: &ThreadPool, i: usize| -> Canvas {
        pool.install(|| Canvas::paint(&pictures[i], LARGE))
    };
    let mut jobs: Vec<Job> = Vec::new();
    for (_, pool) in &pools {
        for i in 0..names.len() {
            jobs.push(Box::new(move || {
                black_box(paint(pool, i));
            }));
        }
    }
    let pixels = right.len();
    let mut times = clock.least(pixels, &mut jobs).into_iter();
    let mut rows = Vec::new();
    for (threads, pool) in &pools {
        for (i, name) in names.into_iter().enumerate() {
            let canvas = paint(pool, i);
            let row = Measurement {
                work: Some(canvas.rays as f64 / pixels as f64),
                ns: times.next().flatten(),
                ..Measurement::of("threads", name, *threads as f64)
            };
            rows.push(against(&right, &canvas.light, row));
        }
    }
    rows
}
