//! Chapter 13: pictures by their plans, against a fixed depth and n × n samples.

use crate::chart::{Axis, Chart, Quantity};
use crate::plan::WISH;
use crate::scenes::{BookScene, SCENES};
use crate::study::{Clock, Job, Measurement, Study, each};
use anti_aliasing::{jittered, regular};
use canvas::{Canvas, Picture, Pixel};
use glam::{UVec2, Vec3};
use reflection::{MAX_DEPTH, Reach};

/// The RMS error, in levels, against 1,024 samples that are followed until nothing is
/// left; what it costs in rays for a pixel; and in nanoseconds.
///
/// The plan's setting is the wish, in levels; the fixed one's is n. Of those, the two that
/// decide are always there, up to 32: the least n that is as good as the plan with a wish
/// of half a level, and the least that costs three times as many rays.
pub const STUDY: Study = Study {
    name: "plan",
    title: "Pictures by their plans, against depth 64 and n × n samples everywhere",
    measure,
    charts: &[
        Chart {
            title: "The still life: RMS error against rays",
            scene: "still-life",
            x: RAYS,
            y: ERROR,
            front: true,
        },
        Chart {
            title: "The ball of glass from near, where little is alike in a pixel",
            scene: "glass",
            x: RAYS,
            y: ERROR,
            front: true,
        },
        Chart {
            title: "The still life: RMS error against time",
            scene: "still-life",
            x: Axis {
                quantity: Quantity::Ns,
                label: "nanoseconds for a pixel",
            },
            y: ERROR,
            front: true,
        },
    ],
    table: include_str!("../../../../book/src/studies/plan.csv"),
};

const RAYS: Axis = Axis {
    quantity: Quantity::Work,
    label: "rays for a pixel",
};

const ERROR: Axis = Axis {
    quantity: Quantity::Rms,
    label: "RMS error, in levels",
};

/// The plan's method in the table, and the fixed settings'.
pub const METHODS: [&str; 2] = ["by plan", "n × n, depth 64"];

/// The most samples along a side: the reference has no more.
const MOST: u32 = 32;

fn measure(clock: &Clock) -> Vec<Measurement> {
    // Of mirrors that pass on 0.99 even a small reference takes a billion rays.
    let scenes = SCENES
        .iter()
        .filter(|scene| scene.name != "endless-mirrors");
    scenes.flat_map(|scene| compare(clock, scene)).collect()
}

/// Large enough to show the smallest thing in it; the more rays to a pixel, the smaller.
fn size(scene: &BookScene) -> UVec2 {
    match scene.name {
        "planet" => UVec2::new(128, 96),
        "facing-mirrors" | "nested" => UVec2::new(24, 18),
        _ => UVec2::new(48, 36),
    }
}

fn compare(clock: &Clock, scene: &BookScene) -> Vec<Measurement> {
    let size = size(scene);
    let (model, camera) = (scene.make)();
    let by_plan = |wish: f32| {
        let plan = model.plan(&camera, wish);
        model.clone().planned(plan, camera)
    };
    let by_samples = |n: u32| {
        let model = model.clone();
        Picture::new(move |pixel| {
            let reach = Reach::new(MAX_DEPTH);
            regular(pixel, n, &|point| model.trace(camera.ray(point), reach))
        })
    };
    let reference = {
        let model = model.clone();
        let deep = Reach {
            depth: 500,
            weight: 1.0,
            least_weight: 1e-4,
        };
        let picture = Picture::new(move |pixel| {
            jittered(pixel, MOST, &|point| model.trace(camera.ray(point), deep))
        });
        Canvas::paint(&picture, size)
    };
    let measured = |method: &str, setting: f64, picture: Picture| {
        let canvas = Canvas::paint(&picture, size);
        let row = Measurement {
            work: Some(canvas.rays as f64 / f64::from(size.x * size.y)),
            ..Measurement::of(scene.name, method, setting)
        };
        (row.with_errors(errors(&canvas, &reference)), picture)
    };

    let mut rows: Vec<_> = [WISH, 2.0, 8.0]
        .into_iter()
        .map(|wish| measured(METHODS[0], wish.into(), by_plan(wish)))
        .collect();
    let (goal, cost) = (rows[0].0.rms, rows[0].0.work.map(|rays| 3.0 * rays));
    let fixed = |n: u32| measured(METHODS[1], n.into(), by_samples(n));
    let is_as_good = |row: &Measurement| row.rms <= goal;
    let is_as_costly = |row: &Measurement| row.work >= cost;
    let mut tried: Vec<_> = [1, 2, 4].map(|n| (n, fixed(n))).into();
    for is_enough in [&is_as_good as &dyn Fn(&Measurement) -> bool, &is_as_costly] {
        // By halving: the error falls, and the cost grows, with n.
        let (mut below, mut enough) = (1, MOST);
        while below + 1 < enough {
            let n = below.midpoint(enough);
            let place = tried.iter().position(|(tried, _)| *tried == n);
            let place = place.unwrap_or_else(|| {
                tried.push((n, fixed(n)));
                tried.len() - 1
            });
            if is_enough(&tried[place].1.0) {
                enough = n;
            } else {
                below = n;
            }
        }
        if tried.iter().all(|(n, _)| *n != enough) {
            tried.push((enough, fixed(enough)));
        }
    }
    tried.sort_by_key(|(n, _)| *n);
    rows.extend(tried.into_iter().map(|(_, row)| row));

    // Some pixels from everywhere.
    let pixel = |i: u32| Pixel {
        x: (2 * i + 1) * size.x / 64,
        y: (2 * (13 * i % 32) + 1) * size.y / 64,
        size,
    };
    let pixels: Vec<Pixel> = (0..32).map(pixel).collect();
    let mut jobs: Vec<Job> = rows
        .iter()
        .map(|(_, picture)| each(&pixels, |pixel| picture.light(*pixel)))
        .collect();
    let times = clock.least(pixels.len(), &mut jobs);
    drop(jobs);
    let rows = rows.into_iter().zip(times);
    rows.map(|((row, _), ns)| Measurement { ns, ..row })
        .collect()
}

/// How far each colour of each pixel is off, in levels that are not rounded.
fn errors(canvas: &Canvas, reference: &Canvas) -> impl Iterator<Item = f64> {
    let levels = |light: &Vec3| light.to_array().map(|light| oracle::level(light.into()));
    let pixels = canvas.light.iter().zip(&reference.light);
    pixels.flat_map(move |(ours, exact)| {
        let [ours, exact] = [levels(ours), levels(exact)];
        (0..3).map(move |i| ours[i] - exact[i])
    })
}
