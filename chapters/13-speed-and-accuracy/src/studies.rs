//! The studies, and what runs them.

pub mod acne;
pub mod bounces;
pub mod fresnel;
pub mod growth;
pub mod highlight;
pub mod packets;
pub mod plan;
pub mod plane;
pub mod recursion;
pub mod refraction;
pub mod sampling;
pub mod sphere;

use crate::chart;
use crate::peers::PEERS_TASK;
use crate::plan::WISH;
use crate::scenes;
use crate::study::{Clock, Study, Table, machine, only_in_release};
use canvas::{Canvas, Failure, Task};
use glam::UVec2;
use indicatif::{ProgressBar, ProgressStyle};
use std::path::Path;

/// Every study, in the order of the chapters that they belong to.
pub const STUDIES: [&Study; 12] = [
    &sphere::STUDY,
    &plane::STUDY,
    &bounces::STUDY,
    &refraction::STUDY,
    &fresnel::STUDY,
    &highlight::STUDY,
    &recursion::STUDY,
    &sampling::STUDY,
    &acne::STUDY,
    &growth::STUDY,
    &packets::STUDY,
    &plan::STUDY,
];

/// What the chapter's command line can do beside showing its views.
pub const TASKS: [Task; 3] = [STUDY_TASK, PLAN_TASK, PEERS_TASK];

const STUDY_TASK: Task = Task {
    flag: "study",
    value: "NAME",
    help: "Measure again, and write the table and the chart into the book: the name of a chart's view, or all",
    run: measure,
};

const PLAN_TASK: Task = Task {
    flag: "plan",
    value: "SCENE",
    help: "Say what the picture of a scene of the book needs, and what that costs: still-life, facing-mirrors, planet …",
    run: say_plan,
};

/// Where the book keeps the studies' tables and charts.
const FOLDER: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../book/src/studies");

/// The study called `name`.
///
/// # Errors
/// One line that names the studies there are.
pub fn find(name: &str) -> Result<&'static Study, String> {
    let study = STUDIES.into_iter().find(|study| study.name == name);
    study.ok_or_else(|| {
        let names = STUDIES.map(|study| study.name).join(", ");
        format!("there is no study '{name}'; the studies: {names}")
    })
}

/// Runs the study called `name`, or all of them for `all`, writes their tables and charts
/// into the book, and says in a line each what came of it.
///
/// # Errors
/// In a debug build, for a name that no study has, and if a file cannot be written. What
/// was written before is whole.
pub fn measure(name: &str) -> Result<(), Failure> {
    let chosen = match name {
        "all" => STUDIES.to_vec(),
        _ => vec![find(name).map_err(|line| Failure::Usage(line + ", or all"))?],
    };
    only_in_release()?;
    let style = ProgressStyle::with_template("{bar:40} {pos}/{len} {msg}")
        .expect("a valid template");
    let progress = ProgressBar::new(chosen.len() as u64).with_style(style);
    canvas::say(&format!("measured on {}", machine()));
    for study in chosen {
        progress.set_message(study.name);
        let table = Table {
            machine: machine(),
            rows: (study.measure)(&Clock::RUNNING),
        };
        // What is drawn is what is written: rounded.
        let csv = table.to_csv();
        let table = Table::from_csv(&csv).map_err(Failure::Failed)?;
        let svg = chart::svg(study.title, study.charts, &table);
        for (ending, text) in [("csv", csv), ("svg", svg)] {
            let path = Path::new(FOLDER).join(format!("{}.{ending}", study.name));
            canvas::write_file(&path, text.as_bytes()).map_err(Failure::Failed)?;
        }
        progress.suspend(|| canvas::say(&summary(study, &table)));
        progress.inc(1);
    }
    progress.finish_and_clear();
    Ok(())
}

/// Says in words what the picture of a scene of the book needs, and counts its rays.
fn say_plan(name: &str) -> Result<(), Failure> {
    let scene = scenes::find(name).map_err(Failure::Usage)?;
    let (model, camera) = (scene.make)();
    let plan = model.plan(&camera, WISH);
    canvas::say(&plan.to_string());
    let size = UVec2::new(320, 240);
    let rays = Canvas::paint(&model.planned(plan, camera), size).rays;
    let per_pixel = rays as f64 / f64::from(size.x * size.y);
    let pixels = format!("{}x{} pixels", size.x, size.y);
    canvas::say(&format!("at {pixels}: {per_pixel:.1} rays for a pixel"));
    Ok(())
}

/// A study's outcome in a line for each of its charts: which methods no other beats.
fn summary(study: &Study, table: &Table) -> String {
    let mut lines = vec![format!("\n{}: {} rows", study.title, table.rows.len())];
    for chart in study.charts {
        if chart.front {
            let best = chart.best(table).join(", ");
            lines.push(format!("  {}: {best}", chart.title));
        }
    }
    lines.join("\n")
}
