//! A study, measured again: what the book's table and charts say is what is measured today.

use crate::plot::svg;
use speed_and_accuracy::study::Study;
use speed_and_accuracy::table::{Measurement, Table};

/// Compares rows with those of a study's table that are `chosen`, but for the times, which are
/// the machine's.
///
/// # Panics
/// If anything else differs.
pub fn check_rows(
    study: &Study,
    rows: Vec<Measurement>,
    chosen: impl Fn(&Measurement) -> bool,
) {
    let mut book = table(study);
    book.rows.retain(chosen);
    let measured = Table {
        rows,
        ..Table::default()
    };
    let [expected, now] = [book, measured].map(|table| table.without_times().to_csv());
    let lines = expected.lines().zip(now.lines());
    let differing = lines.filter(|(book, now)| book != now);
    let differing: Vec<String> = differing
        .map(|(book, now)| format!("book: {book}\n now: {now}"))
        .collect();
    let differing = differing.join("\n");
    assert!(expected == now, "\n{differing}\n{}", again(study));
}

/// Compares a study's charts with those of its table.
///
/// # Panics
/// If they differ, or a chart shows nothing, or does not show what the book has chosen.
pub fn check_charts(study: &Study) {
    let table = table(study);
    let charts = std::fs::read_to_string(study.path("svg"));
    let are_those_of_the_table = charts.is_ok_and(|charts| charts == svg(study, &table));
    let (name, again) = (study.name, again(study));
    assert!(
        are_those_of_the_table,
        "{name}.svg is not its table's; {again}"
    );
    let lines = || study.charts.iter().flat_map(|chart| chart.lines(&table));
    for chart in study.charts {
        let lines = chart.lines(&table);
        let points: usize = lines.iter().map(|line| line.points.len()).sum();
        assert!(points > 1, "the chart of {} shows nothing", chart.scene);
    }
    for choice in study.chosen {
        let is_shown = lines().any(|line| {
            let has = |setting| line.settings.contains(&setting);
            line.method == choice.method && choice.setting.is_none_or(has)
        });
        assert!(
            is_shown,
            "{name} does not show the chosen {}",
            choice.method
        );
    }
}

fn table(study: &Study) -> Table {
    let table = study.table();
    table.unwrap_or_else(|error| panic!("{}.csv: {error}; {}", study.name, again(study)))
}

fn again(study: &Study) -> String {
    let name = study.name;
    format!("if that is what you wanted: cargo bench --bench studies -- {name}")
}
