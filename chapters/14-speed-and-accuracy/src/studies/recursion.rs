//! Limits to the recursion.

use crate::chart::{Axis, Chart, Quantity};
use crate::error_map::level_error;
use crate::study::{Choice, Clock, Study, each};
use crate::table::Measurement;
use canvas::Canvas;
use glam::UVec2;
use measure::pictures::{camera_rays, exact_radiance, render};
use measure::scenes::{Model, plain_scene, scene};
use oracle::Limit;
use ray_casting::Camera;
use reflection::{MAX_DEPTH, PathBudget};

/// A limit to the bounces, one to the throughput, and both, in glass and between mirrors; the
/// setting is the depth, or k for a cut-off at 2⁻ᵏ: 11 for the 1/2048 that is an
/// eighth of a level on a linear scale, 15 for a tenth of the darkest level.
///
/// Rays, shadow rays among them, and nanoseconds are those of one pixel. Errors are in
/// levels, not rounded, against the oracle; a pixel off by more than half a level is wrong.
/// Pixels at an edge that f32 and f64 see on different sides are left out, as a row of each
/// scene says: they differ by more than a tenth of a level when both follow rays to the end.
pub const STUDY: Study = Study {
    name: "recursion",
    title: "When to follow a ray no farther: after so many bounces, or when it brings too little",
    measure,
    chosen: &[Choice::at("depth 64 + cut-off", 15.0)],
    charts: &[
        Chart::new("ball", RAYS, LARGEST)
            .titled("A ball of glass: the cut-off needs fewer rays than the depth"),
        Chart::new("nested", RAYS, LARGEST)
            .titled("A ball in a bubble in a ball: by depth alone the rays multiply"),
        Chart::new("mirrors 0.99", RAYS, LARGEST)
            .titled("Two mirrors of 0.99: one chain, in which both mean the same"),
    ],
};

const RAYS: Axis = (
    Quantity::Work,
    "rays per pixel (at the marks: the depth, or k of a cut-off at 2⁻ᵏ)",
);
const LARGEST: Axis = (Quantity::Max, "largest error, in levels");

const SIZE: UVec2 = UVec2::new(64, 48);

/// A budget that follows rays to the end: between mirrors of 0.99 after 1375 bounces, which
/// need less than half of a thread's usual stack of 2 MiB.
const TO_THE_END: PathBudget = PathBudget {
    depth: 2048,
    throughput: 1.0,
    min_throughput: 1e-6,
};

fn measure(clock: &Clock) -> Vec<Measurement> {
    // A scene, the part of its light that is shown, since what is too bright for a screen
    // shows no error, and the greatest depth.
    [
        compare(clock, "ball", &glass_alone("glass"), 1.0, MAX_DEPTH),
        compare(clock, "nested", &glass_alone("nested"), 1.0, 16),
        compare(clock, "mirrors 0.9", &scene("facing-mirrors"), 1.0, 1000),
        compare(clock, "mirrors 0.99", &scene("endless-mirrors"), 0.1, 1000),
    ]
    .concat()
}

/// Returns a scene with nothing in it but its glass and its floor.
fn glass_alone(name: &str) -> (Model, Camera) {
    let (mut scene, camera) = plain_scene(name);
    let is_kept = |name| ["floor", "glass"].contains(&name);
    scene.objects.retain(|object| is_kept(object.name));
    (Model::Plain(scene), camera)
}

/// Returns methods, their settings, and the budgets that they give a camera's ray.
fn budgets(deepest: u32) -> Vec<(&'static str, f64, PathBudget)> {
    let mut budgets = Vec::new();
    let mut add = |method, setting, depth, min_throughput| {
        let budget = PathBudget {
            depth,
            throughput: 1.0,
            min_throughput,
        };
        budgets.push((method, setting, budget));
    };
    let depths = (0..=6).chain([8, 10, 12, 16, 24, 32, 64, 128, 256, 512, 1000]);
    for depth in depths.filter(|&depth| depth <= deepest) {
        add("depth", f64::from(depth), depth, 0.0);
    }
    for k in 4..=16 {
        let min_throughput = 1.0 / (1 << k) as f32;
        let k = f64::from(k);
        add("cut-off", k, TO_THE_END.depth, min_throughput);
        add("depth 64 + cut-off", k, MAX_DEPTH, min_throughput);
    }
    add(
        "to the end",
        0.0,
        TO_THE_END.depth,
        TO_THE_END.min_throughput,
    );
    budgets
}

fn compare(
    clock: &Clock,
    name: &str,
    (model, camera): &(Model, Camera),
    exposure: f32,
    deepest: u32,
) -> Vec<Measurement> {
    let limit = Limit {
        bounces: TO_THE_END.depth,
        min_throughput: TO_THE_END.min_throughput.into(),
    };
    let exact = exact_radiance(model, camera, SIZE, limit);
    let errors = |canvas: &Canvas| -> Vec<f64> {
        let pairs = canvas.radiance.iter().zip(&exact);
        pairs
            .map(|(ours, exact)| {
                level_error(exposure * *ours, f64::from(exposure) * *exact)
            })
            .collect()
    };
    let to_the_end = errors(&render(model, *camera, SIZE, TO_THE_END));
    let is_kept = |&pixel: &usize| to_the_end[pixel] <= 0.1;
    let kept: Vec<usize> = (0..exact.len()).filter(is_kept).collect();
    let percent = |part: usize, of: usize| Some(100.0 * part as f64 / of as f64);
    let mut rows = vec![Measurement {
        wrong: percent(exact.len() - kept.len(), exact.len()),
        ..Measurement::of(name, "left out", 0.0)
    }];
    let budgets = budgets(deepest);
    let times = trace_times(
        clock,
        model,
        camera,
        budgets.iter().map(|&(.., budget)| budget),
    );
    for ((method, setting, budget), ns) in budgets.into_iter().zip(times) {
        let canvas = render(model, *camera, SIZE, budget);
        let errors = errors(&canvas);
        let errors = kept.iter().map(|&pixel| errors[pixel]);
        let wrong = errors.clone().filter(|&error| error > 0.5).count();
        rows.push(Measurement {
            work: Some(canvas.rays as f64 / exact.len() as f64),
            wrong: percent(wrong, kept.len()),
            ns,
            ..Measurement::of(name, method, setting).with_errors(errors)
        });
    }
    rows
}

/// Returns the nanoseconds for a pixel by each of some budgets.
pub fn trace_times(
    clock: &Clock,
    model: &Model,
    camera: &Camera,
    budgets: impl IntoIterator<Item = PathBudget>,
) -> Vec<Option<f64>> {
    let rays = camera_rays(camera, UVec2::new(20, 15));
    let job = |budget| each(&rays, move |&ray| model.trace(ray, budget));
    clock.min_of_rounds(rays.len(), budgets.into_iter().map(job))
}
