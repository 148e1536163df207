//! The study, measured once for all of these tests: its errors and counts are exact.

use crate::check::check;
use ::plan::STAGE;
use ::plan::study::STUDY;
use harness::{Numbers, table, three_digits};
use speed_and_accuracy::study::{Clock, Study};
use speed_and_accuracy::table::Measurement;
use std::sync::LazyLock;

static ROWS: LazyLock<Vec<Measurement>> =
    LazyLock::new(|| (STUDY.measure)(&Clock::STOPPED));

/// The rows of each scene: three planned pictures, of a tolerance of half a level first, and
/// those of n × n samples.
fn scenes() -> impl Iterator<Item = (&'static [Measurement], &'static [Measurement])> {
    let scenes = ROWS.chunk_by(|a, b| a.scene == b.scene);
    scenes.map(|rows| rows.split_at(3))
}

fn work(row: &Measurement) -> f64 {
    row.work.expect("counted rays")
}

fn rms(row: &Measurement) -> f64 {
    row.rms.expect("an error")
}

#[test]
fn the_table_and_its_charts_are_those_in_the_book() {
    check(&Study {
        measure: |_| ROWS.clone(),
        ..STUDY
    });
}

#[test]
fn a_larger_tolerance_takes_fewer_rays_and_is_less_accurate() {
    for (planned, _) in scenes() {
        let name = &planned[0].scene;
        assert!(planned.is_sorted_by(|a, b| work(a) > work(b)), "{name}");
        assert!(planned.is_sorted_by(|a, b| rms(a) < rms(b)), "{name}");
    }
}

/// With twice the rays, n × n samples are still worse. In the nested glass, which is in no
/// picture of the book, few pixels are uniform: there it is only more rays.
#[test]
fn many_more_rays_everywhere_are_worse_than_the_plan() {
    let rows = scenes().map(|(planned, fixed)| {
        let planned = &planned[0];
        let worse = fixed.iter().rfind(|row| rms(row) > rms(planned));
        let worse = worse.expect("one sample is worse");
        let times = work(worse) / work(planned);
        let least = if planned.scene == "nested" { 1.0 } else { 2.0 };
        assert!(times >= least, "{}: {times}", planned.scene);
        [
            planned.scene.clone(),
            three_digits(work(planned)),
            three_digits(rms(planned)),
            worse.setting.to_string(),
            three_digits(work(worse)),
            three_digits(rms(worse)),
            three_digits(times),
        ]
    });
    let mut numbers = Numbers::default();
    numbers.note("scenes", table(rows));
    numbers.check(&format!("{}-sampling", STAGE.name));
}
