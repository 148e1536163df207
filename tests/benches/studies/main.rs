//! `cargo bench --bench studies -- [--charts] [NAME…]`: measures the named studies again, or
//! all of them, and writes their tables and charts into the book. With `--charts` it measures
//! nothing, and draws the charts of the tables that are there.

#[path = "../common.rs"]
mod common;
mod plot;

use common::Error;
use preprocessor::studies;
use preview::{print_line, write_file};
use speed_and_accuracy::chart::pareto_front;
use speed_and_accuracy::study::{Clock, Study};
use speed_and_accuracy::table::Table;
use std::process::ExitCode;

fn main() -> ExitCode {
    common::run(run)
}

fn run(arguments: &[String]) -> Result<(), Error> {
    let (options, names): (Vec<_>, Vec<_>) = arguments
        .iter()
        .partition(|argument| *argument == "--charts");
    let all: Vec<&str> = studies().map(|study| study.name).collect();
    let all = all.join(", ");
    if names.iter().any(|name| *name == "--help") {
        print_line(&format!(
            "cargo bench --bench studies -- [--charts] [NAME…]\nthe studies: {all}"
        ))?;
        return Ok(());
    }
    for name in &names {
        if studies().all(|study| study.name != **name) {
            let line = format!("there is no study '{name}'; the studies: {all}");
            return Err(Error::Usage(line));
        }
    }
    let is_named =
        |study: &&Study| names.is_empty() || names.iter().any(|name| *name == study.name);
    if !options.is_empty() {
        return studies().filter(is_named).try_for_each(|study| {
            let table = study.table();
            draw(
                study,
                &table.map_err(|error| Error::Failed(error.to_string()))?,
            )
        });
    }
    common::check_release()?;
    print_line(&format!("measured on {}", common::machine()))?;
    studies().filter(is_named).try_for_each(measure)
}

/// Measures a study, writes its table and its charts, and prints a line for each chart of
/// costs and errors: the methods that no other beats.
fn measure(study: &Study) -> Result<(), Error> {
    print_line(&format!("\n{}", study.title))?;
    let table = Table {
        machine: common::machine(),
        rows: (study.measure)(&Clock::RUNNING),
    };
    // The charts show the numbers as they are written: rounded.
    let csv = table.to_csv();
    let table = Table::from_csv(&csv).expect("it was just written");
    write(study, "csv", &csv)?;
    draw(study, &table)?;
    for chart in study
        .charts
        .iter()
        .filter(|chart| chart.show_pareto_front())
    {
        let mut lines = chart.lines(&table);
        let front = pareto_front(lines.iter().flat_map(|line| line.points.clone()));
        lines.retain(|line| line.points.iter().any(|point| front.contains(point)));
        let best: Vec<&str> = lines.iter().map(|line| line.method).collect();
        print_line(&format!("  {}: {}", chart.title, best.join(", ")))?;
    }
    Ok(())
}

fn draw(study: &Study, table: &Table) -> Result<(), Error> {
    write(study, "svg", &plot::svg(study, table))
}

fn write(study: &Study, extension: &str, text: &str) -> Result<(), Error> {
    Ok(write_file(&study.path(extension), |file| {
        file.write_all(text.as_bytes())
    })?)
}
