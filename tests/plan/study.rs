//! The study's table. It takes minutes to measure, so only a part of it is measured again here.

use crate::check::{check_charts, check_rows};
use ::plan::STAGE;
use ::plan::study::{STUDY, TOLERANCES, compare, plan, render, scenes};
use harness::{Numbers, table, three_digits};
use speed_and_accuracy::study::Clock;
use speed_and_accuracy::table::Measurement;
use std::sync::LazyLock;

static ROWS: LazyLock<Vec<Measurement>> =
    LazyLock::new(|| STUDY.table().expect("a table").rows);

/// The rows of a scene.
struct Scene {
    name: &'static str,
    reference: &'static Measurement,
    /// Those of the plan, of half a level first.
    planned: &'static [Measurement],
    /// Those of n × n samples.
    fixed: &'static [Measurement],
}

fn tables() -> impl Iterator<Item = Scene> {
    scenes().map(|scene| {
        let mut of_scene = ROWS.chunk_by(|a, b| a.scene == b.scene);
        let rows = of_scene.find(|rows| rows[0].scene == scene.name);
        let rows = rows.unwrap_or_else(|| panic!("no rows of {}", scene.name));
        let (planned, fixed) = rows[1..].split_at(TOLERANCES.len());
        Scene {
            name: scene.name,
            reference: &rows[0],
            planned,
            fixed,
        }
    })
}

fn work(row: &Measurement) -> f64 {
    row.work.expect("counted rays")
}

fn rms(row: &Measurement) -> f64 {
    row.rms.expect("an error")
}

/// Returns the rays per pixel at which the line of a method reaches an error, in a chart with
/// logarithmic axes. `None` if it does not.
fn rays_at<'a>(
    error: f64,
    rows: impl Iterator<Item = &'a Measurement> + Clone,
) -> Option<f64> {
    let steps = rows.clone().zip(rows.skip(1));
    let mut across = steps.filter(|(a, b)| rms(a) > error && rms(b) <= error);
    let (a, b) = across.next()?;
    let part = libm::log(rms(a) / error) / libm::log(rms(a) / rms(b));
    Some(work(a) * libm::pow(work(b) / work(a), part))
}

/// Ten times the rays for a hundredth of the error: a tenth is reached at √10 times as many.
#[test]
fn rays_are_read_off_a_line_between_two_marks() {
    let rows = [(1.0, 50.0), (10.0, 10.0), (100.0, 0.1)].map(|(work, rms)| Measurement {
        work: Some(work),
        rms: Some(rms),
        ..Measurement::default()
    });
    let rays = rays_at(1.0, rows.iter()).expect("between the last two");
    assert!((rays - 1000.0_f64.sqrt()).abs() < 1e-9, "{rays}");
    assert_eq!(rays_at(0.01, rows.iter()), None);
}

#[test]
fn the_charts_are_those_of_the_table() {
    check_charts(&STUDY);
}

/// The references, every method, and the errors, of one of the scenes.
#[test]
fn a_scene_measured_again_has_the_rows_of_the_table() {
    let scene = scenes().find(|scene| scene.name == "flat");
    let rows = compare(&Clock::STOPPED, scene.expect("a scene"));
    check_rows(&STUDY, rows, |row| row.scene == "flat");
}

#[test]
fn the_plans_of_all_scenes_take_the_rays_of_the_table() {
    let rows = scenes().flat_map(|scene| {
        let (model, camera) = (scene.make)();
        TOLERANCES.map(|tolerance| Measurement {
            work: Some(render(&plan(model.clone(), tolerance).picture(camera)).1),
            ..Measurement::of(scene.name, "planned", tolerance.into())
        })
    });
    let book = ROWS.iter().filter(|row| row.method == "planned");
    let book = book.map(|row| Measurement {
        work: row.work,
        ..Measurement::of(&row.scene, &row.method, row.setting)
    });
    let table = |rows: Vec<Measurement>| {
        speed_and_accuracy::table::Table {
            rows,
            ..Default::default()
        }
        .to_csv()
    };
    assert_eq!(table(book.collect()), table(rows.collect()));
}

/// A tenth of the target.
#[test]
fn the_references_are_exact_to_a_twentieth_of_a_level() {
    for Scene {
        name, reference, ..
    } in tables()
    {
        assert!(rms(reference) <= 0.05, "{name}: {}", rms(reference));
    }
}

#[test]
fn half_a_level_is_met_in_at_least_12_of_14_scenes() {
    assert_eq!(tables().count(), 14);
    let missed = tables().filter(|scene| rms(&scene.planned[0]) > 0.5);
    let missed: Vec<&str> = missed.map(|scene| scene.name).collect();
    assert!(missed.len() <= 2, "missed: {missed:?}");
}

#[test]
fn a_larger_tolerance_takes_fewer_rays_and_is_less_accurate() {
    for Scene { name, planned, .. } in tables() {
        assert!(planned.is_sorted_by(|a, b| work(a) > work(b)), "{name}");
        assert!(planned.is_sorted_by(|a, b| rms(a) < rms(b)), "{name}");
    }
}

/// Returns the row that the page has of a scene: what the plan for half a level takes and misses.
fn errors(scene: Scene) -> [String; 5] {
    let half = &scene.planned[0];
    let worst = half.max.expect("an error");
    let numbers = [rms(half), worst, work(half), rms(scene.reference)];
    let [rms, worst, rays, reference] = numbers.map(three_digits);
    [scene.name.to_string(), rms, worst, rays, reference]
}

#[test]
fn the_numbers_are_those_in_the_book() {
    let mut numbers = Numbers::default();
    let missed = || tables().filter(|scene| rms(&scene.planned[0]) > 0.5);
    numbers.note("errors", table(tables().map(errors)));
    numbers.note("misses", table(missed().map(errors)));
    let ratios = tables().map(
        |Scene {
             name,
             planned,
             fixed,
             ..
         }| {
            let planned = &planned[0];
            let ratio = |method: &str| {
                let rows = fixed.iter().filter(|row| row.method == method);
                let rays = rays_at(rms(planned), rows);
                rays.map_or("more than 10".to_string(), |rays| {
                    format!("{:.1}", rays / work(planned))
                })
            };
            let [grid, sobol, adaptive] = ["grid", "Owen-Sobol", "adaptive"].map(ratio);
            [name.to_string(), grid, sobol, adaptive]
        },
    );
    numbers.note("ratios", table(ratios));
    numbers.note("missed", missed().count());
    numbers.check(&format!("{}-sampling", STAGE.name));
}
