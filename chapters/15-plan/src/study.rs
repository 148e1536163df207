//! Planned pictures, against the same number of samples in every pixel.

use crate::{DEFAULT_TOLERANCE, Plan};
use anti_aliasing::sobol::low_discrepancy;
use anti_aliasing::{Sampler, adaptive, regular};
use canvas::{Picture, Pixel, rays_so_far};
use glam::{DVec3, UVec2, Vec2, Vec3};
use measure::Random;
use measure::pictures::exact_means;
use measure::scenes::{BookScene, Model, SCENES, exact_camera};
use oracle::Limit;
use ray_casting::Camera;
use reflection::{MAX_DEPTH, PathBudget};
use speed_and_accuracy::chart::{Axis, Chart, Quantity};
use speed_and_accuracy::error_map::level_error;
use speed_and_accuracy::study::{Choice, Clock, Study, each};
use speed_and_accuracy::table::Measurement;
use std::iter;

/// Planned pictures, whose setting is the tolerance, against n × n samples of rays with a
/// fixed depth, whose setting is n.
///
/// Of pictures of 320 × 240 pixels, 1,200 are measured: a random one in each block of 8 × 8.
/// Rays and nanoseconds are those of one pixel, and errors are in levels, against the mean of
/// two references by the oracle. The errors in the row of a "reference" are its own: half of
/// the differences of the two.
pub const STUDY: Study = Study {
    name: "plan",
    title: "Planned pictures, against n × n samples and a depth of 64",
    measure: |clock| scenes().flat_map(|scene| compare(clock, scene)).collect(),
    chosen: &[Choice::at("planned", 0.5)],
    charts: &[
        Chart::new("still-life", RAYS, ERROR)
            .titled("The still life: RMS error against rays"),
        Chart::new("glass", RAYS, ERROR)
            .titled("The ball of glass from near, where few pixels are uniform"),
        Chart::new("still-life", TIME, ERROR)
            .titled("The still life: RMS error against time"),
    ],
};

const RAYS: Axis = (Quantity::Work, "rays per pixel");
const TIME: Axis = (Quantity::Ns, "nanoseconds per pixel");
const ERROR: Axis = (Quantity::Rms, "RMS error, in levels");

/// Returns the scenes that are measured: of mirrors that reflect 0.99, even a small reference
/// takes a billion rays.
pub fn scenes() -> impl Iterator<Item = &'static BookScene> {
    SCENES
        .iter()
        .filter(|scene| scene.name != "endless-mirrors")
}

/// The tolerances, in levels.
pub const TOLERANCES: [f32; 3] = [DEFAULT_TOLERANCE, 2.0, 8.0];

/// The size of the pictures, and the side of the blocks of which one pixel is measured.
const SIZE: UVec2 = UVec2::new(320, 240);
const BLOCK: usize = 8;

/// Returns a random pixel of each block.
fn pixels() -> Vec<Pixel> {
    let mut random = Random::new(15);
    let corners = (0..SIZE.y).step_by(BLOCK).flat_map(|y| {
        let row = (0..SIZE.x).step_by(BLOCK);
        row.map(move |x| (x, y))
    });
    let mut within = |start| start + random.index(BLOCK) as u32;
    let pixel = |(x, y)| Pixel {
        x: within(x),
        y: within(y),
        size: SIZE,
    };
    corners.map(pixel).collect()
}

/// Returns the radiance of the measured pixels of a picture, and the rays per pixel that it
/// took.
pub fn render(picture: &Picture) -> (Vec<Vec3>, f64) {
    let before = rays_so_far();
    let radiance = pixels().into_iter().map(|pixel| picture.radiance(pixel));
    let radiance: Vec<Vec3> = radiance.collect();
    let rays = (rays_so_far() - before) as f64 / radiance.len() as f64;
    (radiance, rays)
}

/// Returns the exact radiance of the measured pixels: the means of two references, and half
/// of their differences in levels, which is the deviation of such a mean.
fn reference(model: &Model, camera: Camera) -> Vec<(DVec3, f64)> {
    let (scene, camera) = (model.exactly(), exact_camera(&camera));
    // What is left out of a ray is far below a level.
    let limit = Limit {
        bounces: 1000,
        min_throughput: 1e-5,
    };
    let mean = |pixel| {
        let [a, b] = exact_means(&scene, &camera, pixel, limit);
        ((a + b) / 2.0, level_error(a.as_vec3(), b) / 2.0)
    };
    pixels().into_iter().map(mean).collect()
}

/// Samplers of the same number of samples in every pixel, and one of two numbers.
const SAMPLERS: [(&str, Sampler); 3] = [
    ("grid", regular),
    ("Owen-Sobol", low_discrepancy),
    ("adaptive", adaptive),
];

/// Returns the rows of a scene. Only the still life is timed.
pub fn compare(clock: &Clock, scene: &BookScene) -> Vec<Measurement> {
    let (model, camera) = (scene.make)();
    let exact = reference(&model, camera);
    let of_reference = Measurement::of(scene.name, "reference", 0.0)
        .with_errors(exact.iter().map(|(_, deviation)| *deviation));
    let measured = |method, setting: f64, picture: Picture| {
        let (radiance, rays) = render(&picture);
        let pairs = radiance.iter().zip(&exact);
        let errors = pairs.map(|(ours, (exact, _))| level_error(*ours, *exact));
        let row = Measurement {
            work: Some(rays),
            ..Measurement::of(scene.name, method, setting).with_errors(errors)
        };
        (row, picture)
    };
    let mut rows = Vec::new();
    for tolerance in TOLERANCES {
        let picture = plan(model.clone(), tolerance).picture(camera);
        rows.push(measured("planned", tolerance.into(), picture));
    }
    // Settings that cost more than ten times as much as the first plan are left out.
    let most = rows[0].0.work.map(|rays| 10.0 * rays);
    for (method, sampler) in SAMPLERS {
        for n in [1, 2, 4, 8, 12, 16, 20, 24, 28, 32] {
            let model = model.clone();
            let budget = PathBudget::new(MAX_DEPTH);
            let radiance = move |point: Vec2| model.trace(camera.ray(point), budget);
            let picture = Picture::new(move |pixel| sampler(pixel, n, &radiance));
            let (row, picture) = measured(method, n.into(), picture);
            if row.work > most {
                break;
            }
            rows.push((row, picture));
        }
    }
    let timed: Vec<Pixel> = pixels().into_iter().step_by(53).collect();
    let jobs = rows
        .iter()
        .map(|(_, picture)| each(&timed, |&pixel| picture.radiance(pixel)));
    let is_timed = scene.name == "still-life";
    let clock = if is_timed { clock } else { &Clock::STOPPED };
    let times = clock.min_of_rounds(timed.len(), jobs);
    let rows = rows.into_iter().zip(times);
    let rows = rows.map(|((row, _), ns)| Measurement { ns, ..row });
    iter::once(of_reference).chain(rows).collect()
}

/// Returns the plan for a scene.
pub fn plan(model: Model, tolerance: f32) -> Plan {
    match model {
        Model::Plain(scene) => Plan::with_black_shadows(scene, tolerance),
        Model::Absorbing(scene) => Plan::new(scene, tolerance),
    }
}
