//! `cargo bench --bench studies -- [NAME…]`: measures the named studies again, or all of
//! them, and writes their tables and charts into the book.

#[path = "../common.rs"]
mod common;
mod plot;

use common::Error;
use preprocessor::studies;
use preview::{print_line, write_file};
use speed_and_accuracy::chart::pareto_front;
use speed_and_accuracy::study::{Clock, Study};
use speed_and_accuracy::table::Table;
use std::io::Write;
use std::process::ExitCode;

fn main() -> ExitCode {
    common::run(run)
}

fn run(names: &[String]) -> Result<(), Error> {
    let all: Vec<&str> = studies().map(|study| study.name).collect();
    let all = all.join(", ");
    if names.iter().any(|name| name == "--help") {
        print_line(&format!(
            "cargo bench --bench studies -- [NAME…]\nthe studies: {all}"
        ))?;
        return Ok(());
    }
    for name in names {
        if studies().all(|study| study.name != name) {
            let line = format!("there is no study '{name}'; the studies: {all}");
            return Err(Error::Usage(line));
        }
    }
    common::check_release()?;
    print_line(&format!("measured on {}", common::machine()))?;
    for study in studies() {
        if names.is_empty() || names.iter().any(|name| name == study.name) {
            measure(study)?;
        }
    }
    Ok(())
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
    let svg = plot::svg(study.title, study.charts, &table);
    for (extension, text) in [("csv", csv), ("svg", svg)] {
        write_file(&study.path(extension), |file| {
            file.write_all(text.as_bytes())
        })?;
    }
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
