//! What a study is, how it measures, and the table it leaves.

use crate::chart::Chart;
use canvas::Failure;
use glam::DVec3;
use std::hint::black_box;
use std::time::{Duration, Instant};

// ANCHOR: study
/// A comparison of methods over the settings of one knob.
pub struct Study {
    /// Lower case: `sphere`. Its table and chart are `NAME.csv` and `NAME.svg`.
    pub name: &'static str,
    /// What is compared, in a few words.
    pub title: &'static str,
    /// Everything measured; times only if the clock runs.
    pub measure: fn(&Clock) -> Vec<Measurement>,
    /// What is drawn of it, from top to bottom.
    pub charts: &'static [Chart],
    /// The table in the book, as it was when this was compiled.
    pub table: &'static str,
}

/// What one method at one setting costs, and how wrong it is. The study says in which
/// units.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Measurement {
    /// What the method is tried on.
    pub scene: String,
    /// Its name.
    pub method: String,
    /// The knob's setting.
    pub setting: f64,
    /// What it costs in rays or operations, which are counted, not timed.
    pub work: Option<f64>,
    /// The largest error.
    pub max: Option<f64>,
    /// The root of the mean of the squares of the errors.
    pub rms: Option<f64>,
    /// Wrong decisions, such as a hit that is none, in percent.
    pub wrong: Option<f64>,
    /// What it costs in nanoseconds.
    pub ns: Option<f64>,
}
// ANCHOR_END: study

impl Measurement {
    /// A measurement of nothing yet.
    #[must_use]
    pub fn of(scene: impl Into<String>, method: impl Into<String>, setting: f64) -> Self {
        Self {
            scene: scene.into(),
            method: method.into(),
            setting,
            ..Self::default()
        }
    }

    /// The same with the largest and the RMS of some errors, if there are any.
    #[must_use]
    pub fn with_errors(self, errors: impl IntoIterator<Item = f64>) -> Self {
        let (mut count, mut max, mut squares) = (0_u32, 0.0, 0.0);
        for error in errors {
            let error = error.abs();
            // NaN and infinity are errors, too: the largest there is.
            let error = if error.is_finite() {
                error
            } else {
                f64::INFINITY
            };
            max = if error > max { error } else { max };
            squares += error * error;
            count += 1;
        }
        let rms = (squares / f64::from(count)).sqrt();
        let is_any = count > 0;
        Self {
            max: is_any.then_some(max),
            rms: is_any.then_some(rms),
            ..self
        }
    }

    /// The same with the time of one step, where its time is that of so many.
    #[must_use]
    pub fn for_one_of(self, steps: u32) -> Self {
        let ns = self.ns.map(|ns| ns / f64::from(steps));
        Self { ns, ..self }
    }
}

/// The distance from an f32 as large as `x` to the next.
#[must_use]
pub fn ulp(x: f64) -> f64 {
    let x = x.abs() as f32;
    f64::from(x.next_up()) - f64::from(x)
}

/// A unit vector, all directions alike.
#[must_use]
pub fn direction(random: &mut fastrand::Rng) -> DVec3 {
    loop {
        let vector = DVec3::from_array(std::array::from_fn(|_| 2.0 * random.f64() - 1.0));
        if (1e-3..1.0).contains(&vector.length_squared()) {
            return vector.normalize();
        }
    }
}

// ANCHOR: clock
/// Measures times, or does not: a test wants the errors alone.
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

    /// A clock that runs every job at least so many times, and for longer than a machine
    /// is busy with something else, and believes the fastest.
    pub const RUNNING: Self = Self {
        rounds: 25,
        time: Duration::from_millis(300),
    };

    /// How long each job takes, in nanoseconds for each of its `calls`.
    ///
    /// Whatever else the machine does can only make a job slower, so the least of many
    /// rounds is nearest to the truth; and the jobs take turns, so that a slow minute is
    /// slow for all of them.
    #[must_use]
    pub fn least(&self, calls: usize, jobs: &mut [Job]) -> Vec<Option<f64>> {
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

/// Something to be timed.
pub type Job<'a> = Box<dyn FnMut() + 'a>;

/// A job that calls a function of each input, and lets no compiler see that nobody wants
/// the answers.
pub fn each<'a, T, A>(inputs: &'a [T], call: impl Fn(&T) -> A + 'a) -> Job<'a> {
    Box::new(move || {
        for input in inputs {
            black_box(call(black_box(input)));
        }
    })
}
// ANCHOR_END: clock

// ANCHOR: compare
/// What an answer is worth beside the right one.
pub enum Verdict {
    /// So far from it; if that is not finite, it is a wrong decision as well.
    Off(f64),
    /// A right decision, whose distance from it says nothing.
    Right,
    /// A wrong decision.
    Wrong,
}

impl Verdict {
    /// That on a decision.
    #[must_use]
    pub fn of(is_right: bool) -> Self {
        if is_right { Self::Right } else { Self::Wrong }
    }
}

/// Tries each of the named `methods` on inputs that come with what is right for them, and
/// has each answer judged: by the input, what is right, and the answer.
///
/// Where all answers are only off, nothing is said about decisions.
pub fn compare<T, R, A, F>(
    clock: &Clock,
    (scene, setting): (&str, f64),
    inputs: &[(T, R)],
    methods: &[(&str, F)],
    judge: impl Fn(&T, &R, A) -> Verdict,
) -> Vec<Measurement>
where
    F: Fn(&T) -> A + Copy,
{
    let job = |&(_, method): &(&str, F)| each(inputs, move |(input, _)| method(input));
    let mut jobs: Vec<Job> = methods.iter().map(job).collect();
    let times = clock.least(inputs.len(), &mut jobs);
    let row = |(&(name, method), ns): (&(&str, F), Option<f64>)| {
        let (mut errors, mut right, mut wrong) = (Vec::new(), 0_usize, 0_usize);
        for (input, exact) in inputs {
            match judge(input, exact, method(input)) {
                Verdict::Off(error) => {
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

// ANCHOR: table
/// A study's measurements, as its file holds them.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Table {
    /// Where the times were measured.
    pub machine: String,
    /// One row for each scene, method and setting.
    pub rows: Vec<Measurement>,
}

const COLUMNS: [&str; 8] = [
    "scene", "method", "setting", "work", "max", "rms", "wrong", "ns",
];
// ANCHOR_END: table

impl Table {
    /// The table as comma-separated values, every number rounded to three digits, below a
    /// line that names the machine.
    #[must_use]
    pub fn to_csv(&self) -> String {
        let mut writer = csv::Writer::from_writer(Vec::new());
        let mut write = |record: [&str; 8]| {
            writer
                .write_record(record)
                .expect("memory takes everything");
        };
        write(COLUMNS);
        for row in &self.rows {
            let setting = three_digits(Some(row.setting));
            let numbers = [row.work, row.max, row.rms, row.wrong, row.ns];
            let [work, max, rms, wrong, ns] = numbers.map(three_digits);
            write([
                &row.scene,
                &row.method,
                &setting,
                &work,
                &max,
                &rms,
                &wrong,
                &ns,
            ]);
        }
        let bytes = writer.into_inner().expect("memory takes everything");
        let rows = String::from_utf8(bytes).expect("written from strings");
        format!("# {}\n{rows}", self.machine)
    }

    /// Reads what [`Table::to_csv`] wrote.
    ///
    /// # Errors
    /// One line that says what is wrong with the file.
    pub fn from_csv(text: &str) -> Result<Self, String> {
        let machine = text.lines().next().and_then(|line| line.strip_prefix("# "));
        let machine = machine
            .ok_or("its first line names no machine")?
            .to_string();
        let mut reader = csv::ReaderBuilder::new()
            .comment(Some(b'#'))
            .from_reader(text.as_bytes());
        let headers = reader.headers().map_err(|error| error.to_string())?;
        if headers != COLUMNS.as_slice() {
            return Err(format!("its columns are not {}", COLUMNS.join(",")));
        }
        let rows = reader.records().map(|record| {
            let record = record.map_err(|error| error.to_string())?;
            let number = |i: usize| match &record[i] {
                "" => Ok(None),
                text => match text.parse() {
                    Ok(number) => Ok(Some(number)),
                    Err(_) => Err(format!("“{text}” is not a number")),
                },
            };
            Ok(Measurement {
                scene: record[0].to_string(),
                method: record[1].to_string(),
                setting: number(2)?.ok_or("a row has no setting")?,
                work: number(3)?,
                max: number(4)?,
                rms: number(5)?,
                wrong: number(6)?,
                ns: number(7)?,
            })
        });
        let rows = rows.collect::<Result<_, String>>()?;
        Ok(Self { machine, rows })
    }

    /// The number in the row of a scene, a method and a setting, and in the column called
    /// `work`, `max`, `rms`, `wrong` or `ns`.
    ///
    /// # Errors
    /// One line that says which of them is not there, or that nothing is in the cell.
    pub fn number(
        &self,
        scene: &str,
        method: &str,
        setting: f64,
        column: &str,
    ) -> Result<f64, String> {
        let is_wanted = |row: &&Measurement| {
            row.scene == scene && row.method == method && row.setting == setting
        };
        let row = self.rows.iter().find(is_wanted);
        let row =
            row.ok_or_else(|| format!("there is no row {scene}, {method}, {setting}"))?;
        let number = match column {
            "work" => row.work,
            "max" => row.max,
            "rms" => row.rms,
            "wrong" => row.wrong,
            "ns" => row.ns,
            _ => return Err(format!("there is no column “{column}” of numbers")),
        };
        let empty = || format!("the row {scene}, {method}, {setting} has no {column}");
        number.ok_or_else(empty)
    }

    // ANCHOR: without-times
    /// The same without its times, which no test may compare.
    #[must_use]
    pub fn without_times(mut self) -> Self {
        self.machine = String::new();
        self.rows.iter_mut().for_each(|row| row.ns = None);
        self
    }
    // ANCHOR_END: without-times
}

/// A number rounded to three digits: `0.123`, `12.3`, `1.23e-7`; nothing for none.
#[must_use]
pub fn three_digits(x: Option<f64>) -> String {
    let Some(x) = x else {
        return String::new();
    };
    let rounded = format!("{x:.2e}");
    let value: f64 = rounded.parse().expect("a number just written");
    if value == 0.0 || (1e-3..1e6).contains(&value.abs()) || !value.is_finite() {
        value.to_string()
    } else {
        format!("{value:e}")
    }
}

/// Refuses to measure in a debug build.
///
/// # Errors
/// There.
pub fn only_in_release() -> Result<(), Failure> {
    if cfg!(debug_assertions) {
        return Err(Failure::Usage(
            "the times of a debug build mean nothing; measure with cargo run --release"
                .to_string(),
        ));
    }
    Ok(())
}

/// What the times are measured on: the processor, and what the compiler builds for.
#[must_use]
pub fn machine() -> String {
    let system = format!("{} {}", std::env::consts::ARCH, std::env::consts::OS);
    let cpus = std::fs::read_to_string("/proc/cpuinfo").unwrap_or_default();
    let model = cpus
        .lines()
        .find_map(|line| line.strip_prefix("model name")?.split_once(": "));
    match model {
        Some((_, model)) => format!("{}, {system}", model.trim()),
        None => system,
    }
}
