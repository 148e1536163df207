//! Planned pictures, against n × n samples and a fixed depth.

use crate::{DEFAULT_TOLERANCE, Plan};
use anti_aliasing::{Sampler, jittered, regular};
use canvas::{Canvas, Picture, Pixel};
use glam::{UVec2, Vec2};
use measure::scenes::{BookScene, Model, SCENES};
use reflection::{MAX_DEPTH, PathBudget};
use speed_and_accuracy::chart::{Axis, Chart, Quantity};
use speed_and_accuracy::error_map::level_error;
use speed_and_accuracy::study::{Clock, Study, each};
use speed_and_accuracy::table::Measurement;

/// Planned pictures, whose setting is the tolerance, against n × n samples of rays with a
/// fixed depth, whose setting is n.
///
/// The pictures have 48 × 36 pixels; more for the planet's small balls, and fewer where they
/// take many rays. Rays and nanoseconds are those of one pixel. Errors are in levels, against
/// 1,024 jittered samples of rays that are followed to a throughput of 10⁻⁴.
pub const STUDY: Study = Study {
    name: "plan",
    title: "Planned pictures, against n × n samples and a depth of 64",
    measure,
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

fn measure(clock: &Clock) -> Vec<Measurement> {
    // Of mirrors that reflect 0.99, even a small reference takes a billion rays.
    let scenes = SCENES
        .iter()
        .filter(|scene| scene.name != "endless-mirrors");
    scenes.flat_map(|scene| compare(clock, scene)).collect()
}

fn compare(clock: &Clock, scene: &BookScene) -> Vec<Measurement> {
    let (model, camera) = (scene.make)();
    let size = match scene.name {
        "planet" => UVec2::new(128, 96),
        "facing-mirrors" | "nested" => UVec2::new(24, 18),
        _ => UVec2::new(48, 36),
    };
    let sampled = |sampler: Sampler, n, budget| {
        let model = model.clone();
        let radiance = move |point: Vec2| model.trace(camera.ray(point), budget);
        Picture::new(move |pixel| sampler(pixel, n, &radiance))
    };
    let deep = PathBudget {
        min_throughput: 1e-4,
        ..PathBudget::new(500)
    };
    let reference = Canvas::render(&sampled(jittered, 32, deep), size);
    let measured = |method, setting, picture: Picture| {
        let canvas = Canvas::render(&picture, size);
        let pairs = canvas.radiance.iter().zip(&reference.radiance);
        let errors = pairs.map(|(ours, exact)| level_error(*ours, exact.as_dvec3()));
        let row = Measurement {
            work: Some(canvas.rays as f64 / canvas.radiance.len() as f64),
            ..Measurement::of(scene.name, method, setting).with_errors(errors)
        };
        (row, picture)
    };
    let mut rows = Vec::new();
    for tolerance in [DEFAULT_TOLERANCE, 2.0, 8.0] {
        let picture = plan(model.clone(), tolerance).picture(camera);
        rows.push(measured("planned", tolerance.into(), picture));
    }
    for n in [1, 2, 4, 8, 12, 16, 20, 24, 28, 32] {
        let picture = sampled(regular, n, PathBudget::new(MAX_DEPTH));
        rows.push(measured("n × n, depth 64", n.into(), picture));
        // Settings that cost more than ten times as much as the first plan are left out.
        if rows[rows.len() - 1].0.work > rows[0].0.work.map(|rays| 10.0 * rays) {
            break;
        }
    }
    // Pixels from all over the picture: 53 has no factor in common with a width.
    let pixels: Vec<Pixel> = Pixel::all(size).step_by(53).collect();
    let jobs = rows
        .iter()
        .map(|(_, picture)| each(&pixels, |&pixel| picture.radiance(pixel)));
    let times = clock.min_of_rounds(pixels.len(), jobs);
    let rows = rows.into_iter().zip(times);
    rows.map(|((row, _), ns)| Measurement { ns, ..row })
        .collect()
}

/// Returns the plan for a scene.
#[must_use]
pub fn plan(model: Model, tolerance: f32) -> Plan {
    match model {
        Model::Plain(scene) => Plan::with_black_shadows(scene, tolerance),
        Model::Absorbing(scene) => Plan::new(scene, tolerance),
    }
}
