//! A study, measured again: what the book's table and charts say is what is measured today.

use crate::plot::svg;
use speed_and_accuracy::study::{Clock, Study};
use speed_and_accuracy::table::Table;

/// Measures a study with a clock that stands still, since the times are the machine's.
///
/// # Panics
/// If the table in the book differs in anything else, or its charts are not the table's.
pub fn check(study: &Study) {
    let name = study.name;
    let again =
        format!("if that is what you wanted: cargo bench --bench studies -- {name}");
    let book = study.table();
    let book = book.unwrap_or_else(|error| panic!("{name}.csv: {error}; {again}"));
    let measured = Table {
        rows: (study.measure)(&Clock::STOPPED),
        ..Table::default()
    };
    let [expected, now] =
        [book.clone().without_times(), measured].map(|table| table.to_csv());
    let lines = expected.lines().zip(now.lines());
    let differing = lines.filter(|(book, now)| book != now);
    let differing: Vec<String> = differing
        .map(|(book, now)| format!("book: {book}\n now: {now}"))
        .collect();
    assert!(expected == now, "\n{}\n{again}", differing.join("\n"));

    let charts = std::fs::read_to_string(study.path("svg"));
    let drawn = svg(study.title, study.charts, &book);
    let are_those_of_the_table = charts.is_ok_and(|charts| charts == drawn);
    assert!(
        are_those_of_the_table,
        "{name}.svg is not its table's; {again}"
    );
    for chart in study.charts {
        let points: usize = chart
            .lines(&book)
            .iter()
            .map(|line| line.points.len())
            .sum();
        assert!(points > 1, "the chart of {} shows nothing", chart.scene);
    }
}
