//! Studies, and how they measure.

use crate::chart::Chart;
use crate::table::{Measurement, Table};
use std::fs;
use std::hint::black_box;
use std::path::PathBuf;
use std::time::{Duration, Instant};

// ANCHOR: study
/// A comparison of methods over the settings of one knob.
pub struct Study {
    /// Lower case, `sphere`. Its table and its charts are `NAME.csv` and `NAME.svg`.
    pub name: &'static str,
    /// What is compared, in a few words.
    pub title: &'static str,
    /// Measures everything; times only if the clock runs.
    pub measure: fn(&Clock) -> Vec<Measurement>,
    /// What the book takes, which the charts mark.
    pub chosen: &'static [Choice],
    /// The charts, from top to bottom.
    pub charts: &'static [Chart],
}

/// A method that the book takes.
pub struct Choice {
    /// Its name.
    pub method: &'static str,
    /// Its setting, as the table has it. `None` if the setting is that of the inputs.
    pub setting: Option<f64>,
}
// ANCHOR_END: study

impl Choice {
    /// Returns the choice of a method for all inputs.
    pub const fn of(method: &'static str) -> Self {
        let setting = None;
        Self { method, setting }
    }

    /// Returns the choice of a method with one of its settings.
    pub const fn at(method: &'static str, setting: f64) -> Self {
        let setting = Some(setting);
        Self { method, setting }
    }
}

impl Study {
    /// Returns the path of the study's file in the book: of its table, `csv`, or of its
    /// charts, `svg`.
    pub fn path(&self, extension: &str) -> PathBuf {
        let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../../book/src/studies");
        PathBuf::from(folder)
            .join(self.name)
            .with_extension(extension)
    }

    /// Reads the study's table from the book.
    ///
    /// # Errors
    /// If the file cannot be read, or holds no table.
    pub fn table(&self) -> csv::Result<Table> {
        Table::from_csv(&fs::read_to_string(self.path("csv"))?)
    }
}

impl Measurement {
    /// Returns a row without numbers.
    pub fn of(scene: impl Into<String>, method: impl Into<String>, setting: f64) -> Self {
        Self {
            scene: scene.into(),
            method: method.into(),
            setting,
            ..Self::default()
        }
    }

    /// Returns the row with the largest and the RMS of some errors, or without them if
    /// there are no errors. One that is not finite counts as infinite.
    pub fn with_errors(self, errors: impl IntoIterator<Item = f64>) -> Self {
        let (mut count, mut max, mut squares) = (0_u32, 0.0, 0.0);
        for error in errors {
            let error = if error.is_finite() {
                error.abs()
            } else {
                f64::INFINITY
            };
            max = if error > max { error } else { max };
            squares += error * error;
            count += 1;
        }
        let rms = (squares / f64::from(count)).sqrt();
        let some = |number| (count > 0).then_some(number);
        Self {
            max: some(max),
            rms: some(rms),
            ..self
        }
    }

    /// Divides the time by `steps`.
    pub fn per_step(self, steps: u32) -> Self {
        let ns = self.ns.map(|ns| ns / f64::from(steps));
        Self { ns, ..self }
    }
}

// ANCHOR: clock
/// A clock for the times of jobs. Tests stop it, as they compare the errors alone.
pub struct Clock {
    rounds: u32,
    time: Duration,
}

impl Clock {
    /// A clock that stands still: every time is `None`.
    pub const STOPPED: Self = Self {
        rounds: 0,
        time: Duration::ZERO,
    };

    /// A clock that runs every job at least 25 times, and for long enough to outlast other
    /// work of the machine.
    pub const RUNNING: Self = Self {
        rounds: 25,
        time: Duration::from_millis(300),
    };

    /// Returns the time of each job in nanoseconds per call, of which it makes `calls`: the
    /// minimum of several rounds.
    ///
    /// Other work of the machine can only make a job slower, so the minimum is nearest to
    /// the truth. The jobs take turns, so that a slow minute is slow for all of them.
    pub fn min_of_rounds<'a>(
        &self,
        calls: usize,
        jobs: impl IntoIterator<Item = Job<'a>>,
    ) -> Vec<Option<f64>> {
        let mut jobs: Vec<Job> = jobs.into_iter().collect();
        let mut least = vec![None; jobs.len()];
        let beginning = Instant::now();
        let mut round = 0;
        while round < self.rounds || beginning.elapsed() < self.time {
            round += 1;
            for (job, least) in jobs.iter_mut().zip(&mut least) {
                let start = Instant::now();
                job();
                let ns = start.elapsed().as_nanos() as f64 / calls as f64;
                if least.is_none_or(|least| ns < least) {
                    *least = Some(ns);
                }
            }
        }
        least
    }
}

/// A job to be timed.
pub type Job<'a> = Box<dyn FnMut() + 'a>;

/// Returns a job that calls a function of each input, and hides from the compiler that the
/// results are not used.
pub fn each<'a, T, A>(inputs: &'a [T], call: impl Fn(&T) -> A + 'a) -> Job<'a> {
    Box::new(move || {
        for input in inputs {
            black_box(call(black_box(input)));
        }
    })
}
// ANCHOR_END: clock

// ANCHOR: compare
/// The comparison of a method's result with the exact one.
pub enum Verdict {
    /// Absolute error. A non-finite error also counts as a wrong decision.
    Error(f64),
    /// A right decision, whose error means nothing.
    Right,
    /// A wrong decision.
    Wrong,
}

impl Verdict {
    /// Returns `Right` or `Wrong`.
    pub fn of(is_right: bool) -> Self {
        if is_right { Self::Right } else { Self::Wrong }
    }

    /// Returns the difference of a result from the exact one, as its error.
    pub fn difference(result: f32, exact: f64) -> Self {
        Self::Error(f64::from(result) - exact)
    }

    /// Returns the error in ulps: in distances from the exact result's f32 to the next.
    pub fn in_ulps(result: f32, exact: f64) -> Self {
        let nearest = exact.abs() as f32;
        let ulp = f64::from(nearest.next_up()) - f64::from(nearest);
        Self::Error((f64::from(result) - exact) / ulp)
    }
}

/// Returns a row of measurements for each of the named `methods`, called with inputs that
/// come with their exact results. `verdict` compares: from the input, the exact result and
/// the method's.
///
/// If all verdicts are finite errors, the row has no percentage of wrong decisions.
pub fn compare<T, R, A, F>(
    clock: &Clock,
    (scene, setting): (&str, f64),
    inputs: &[(T, R)],
    methods: &[(&str, F)],
    verdict: impl Fn(&T, &R, A) -> Verdict,
) -> Vec<Measurement>
where
    F: Fn(&T) -> A + Copy,
{
    let job = |&(_, method): &(&str, F)| each(inputs, move |(input, _)| method(input));
    let times = clock.min_of_rounds(inputs.len(), methods.iter().map(job));
    let row = |(&(name, method), ns): (&(&str, F), Option<f64>)| {
        let (mut errors, mut right, mut wrong) = (Vec::new(), 0_usize, 0_usize);
        for (input, exact) in inputs {
            match verdict(input, exact, method(input)) {
                Verdict::Error(error) => {
                    wrong += usize::from(!error.is_finite());
                    errors.push(error);
                }
                Verdict::Right => right += 1,
                Verdict::Wrong => wrong += 1,
            }
        }
        let percent = 100.0 * wrong as f64 / inputs.len() as f64;
        Measurement {
            wrong: (right + wrong > 0).then_some(percent),
            ns,
            ..Measurement::of(scene, name, setting).with_errors(errors)
        }
    };
    methods.iter().zip(times).map(row).collect()
}
// ANCHOR_END: compare
