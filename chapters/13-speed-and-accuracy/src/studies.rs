//! The studies, and what runs them.

pub mod acne;
pub mod sphere;

use crate::chart;
use crate::study::{Clock, Study, Table, machine};
use canvas::{Failure, Task};
use indicatif::{ProgressBar, ProgressStyle};
use std::path::Path;

/// Every study, in the order of the chapters that they belong to.
pub const STUDIES: [&Study; 2] = [&sphere::STUDY, &acne::STUDY];

/// What the chapter's command line can do beside showing its views.
pub const TASKS: [Task; 1] = [Task {
    flag: "study",
    value: "NAME",
    help: "Measure again, and write the table and the chart into the book: the name of a chart's view, or all",
    run: measure,
}];

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
    if cfg!(debug_assertions) {
        return Err(Failure::Usage(
            "the times of a debug build mean nothing; measure with cargo run --release"
                .to_string(),
        ));
    }
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
