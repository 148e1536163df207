//! Chapter 13's studies: what the book's tables and charts say is what is measured today.
//!
//! The times are not compared: they are the machine's. All else is.

use speed_and_accuracy::STUDIES;
use speed_and_accuracy::chart;
use speed_and_accuracy::patterns::PATTERNS;
use speed_and_accuracy::studies::growth;
use speed_and_accuracy::study::{Clock, Study, Table};
use std::f64::consts::PI;

mod speed_and_accuracy_studies {
    use super::*;

    macro_rules! studies {
        ($($study:ident)*) => {
            $(#[test]
            fn $study() {
                let study = &::speed_and_accuracy::studies::$study::STUDY;
                super::check(study);
            })*

            #[test]
            fn no_study_is_left_out() {
                let tested = [$(stringify!($study)),*];
                assert_eq!(tested, STUDIES.map(|study| study.name));
            }
        };
    }

    studies!(
        sphere plane bounces refraction fresnel highlight recursion sampling acne growth packets plan
    );

    /// The yardstick of growth is none if it finds anything else.
    #[test]
    fn the_tree_finds_what_trying_all_spheres_finds() {
        let table = Table::from_csv(growth::STUDY.table).expect("a table");
        let trees = table
            .rows
            .iter()
            .filter(|row| row.method.starts_with("tree"));
        assert_eq!(trees.clone().count(), 24);
        for row in trees {
            assert_eq!(row.wrong, Some(0.0), "{row:?}");
        }
    }

    /// π 23.7² for the disc, and π/16 for each dot: 7.5 × 7.5, for the borders halve some. What the exact
    /// mean of 4096 lines of a pixel may be wrong by is 10⁻⁵.
    #[test]
    fn the_patterns_means_add_up_to_their_areas() {
        for (name, area) in [("edge", PI * 23.7 * 23.7), ("dots", 56.25 * PI / 16.0)] {
            let pattern = PATTERNS.iter().find(|pattern| pattern.name == name);
            let means = pattern.expect("a pattern").means();
            let error = means.iter().sum::<f64>() - area;
            assert!(error.abs() <= 1e-5 * means.len() as f64, "{name}: {error}");
        }
    }
}

fn check(study: &Study) {
    let again = format!(
        "if that is what you wanted: cargo run --release --bin 13-speed-and-accuracy -- --study {}",
        study.name
    );
    let book = Table::from_csv(study.table).unwrap_or_else(|problem| {
        panic!("the table {}.csv: {problem}; {again}", study.name)
    });
    let measured = Table {
        machine: book.machine.clone(),
        rows: (study.measure)(&Clock::STOPPED),
    };
    // As a file holds it: rounded.
    let measured = Table::from_csv(&measured.to_csv()).expect("just written");
    let [in_book, now] =
        [book.clone(), measured].map(|table| table.without_times().to_csv());
    let differing = in_book
        .lines()
        .zip(now.lines())
        .filter(|(book, now)| book != now);
    let differing: Vec<String> = differing
        .map(|(book, now)| format!("book: {book}\n now: {now}"))
        .collect();
    assert!(in_book == now, "\n{}\n{again}", differing.join("\n"));

    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/book/src/studies");
    let svg = std::fs::read_to_string(format!("{folder}/{}.svg", study.name));
    let drawn = chart::svg(study.title, study.charts, &book);
    assert!(
        svg.expect("a chart") == drawn,
        "the chart is not that of its table; {again}"
    );
    for chart in study.charts {
        let shown = book.rows.iter().filter(|row| row.scene == chart.scene);
        assert!(
            shown.count() > 1,
            "the chart of {} shows nothing",
            chart.scene
        );
    }
}
