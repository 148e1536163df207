//! Other people's tracers: what the same picture costs there and here.

pub mod tinyraytracer;

use self::tinyraytracer::ppm;
use crate::pictures::{PlainSight, by_packets, frame, one_by_one, plain_sight, pool};
use crate::study::{machine, only_in_release, three_digits};
use canvas::{Canvas, Failure, Task};
use glam::UVec2;
use indicatif::{ProgressBar, ProgressStyle};
use packets::LANES;
use reflection::Reach;
use std::ffi::OsStr;
use std::hint::black_box;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};
use std::time::Instant;

/// Times them and us, in turns.
pub const PEERS_TASK: Task = Task {
    flag: "peers",
    value: "FOLDER",
    help: "Time POV-Ray beside ours, and tinyraytracer, whose source is in FOLDER (or none), and write the ratios into the book",
    run: race,
};

/// Odd, so that one is in the middle.
const ROUNDS: usize = 7;

/// What the book quotes.
const TABLE: &str = concat!(
    env!("CARGO_MANIFEST_DIR"),
    "/../../book/src/studies/peers.md"
);

/// The still life for POV-Ray, which follows rays as far as [`AS_POV_RAY`].
const STILL_LIFE: &str = concat!(
    env!("CARGO_MANIFEST_DIR"),
    "/../../tests/povray/still-life.pov"
);
const SIZE: UVec2 = UVec2::new(800, 600);
const AS_POV_RAY: Reach = Reach {
    depth: 5,
    weight: 1.0,
    least_weight: 0.0,
};

/// A picture, who paints it, and beside whom.
const RATIOS: [[&str; 3]; 7] = [
    [SAMPLED, "one by one", POV_RAY],
    [SAMPLED, "packets", POV_RAY],
    [BALLS, "one by one", TINYRAYTRACER],
    [BALLS, "packets", TINYRAYTRACER],
    ["still life", "packets", "one by one"],
    [SAMPLED, "packets", "one by one"],
    [SAMPLED, "packets, 2 threads", "packets, 1 thread"],
];
const SAMPLED: &str = "still life, 4 × 4";
const BALLS: &str = "tinyraytracer's balls";
const POV_RAY: &str = "POV-Ray";
const TINYRAYTRACER: &str = "tinyraytracer";

/// What there is of theirs.
#[derive(Debug)]
pub struct Peers {
    povray: Option<PathBuf>,
    /// A compiler, and the source.
    tinyraytracer: Option<(PathBuf, PathBuf)>,
    /// A line for each that is not there.
    pub missing: Vec<String>,
}

impl Peers {
    /// Looks for programs on a search `path`, and for tinyraytracer's source in `folder`
    /// if that is not `none`.
    ///
    /// # Errors
    /// If the source is not where it is said to be.
    pub fn look(folder: &str, path: &OsStr) -> Result<Self, Failure> {
        let mut missing = Vec::new();
        let mut find = |program: &str, peer: &str| {
            let folders = std::env::split_paths(path);
            let found = folders.map(|folder| folder.join(program));
            let found = found.into_iter().find(|file| file.is_file());
            if found.is_none() {
                missing.push(format!("{peer} is left out: there is no {program}"));
            }
            found
        };
        let povray = find("povray", POV_RAY);
        let mut tinyraytracer = None;
        if folder == "none" {
            missing.push(format!("{TINYRAYTRACER} is left out: no source was given"));
        } else {
            let source = Path::new(folder).join("tinyraytracer.cpp");
            if !source.is_file() {
                return Err(Failure::Failed(format!(
                    "there is no {}; name the folder of that file, or none",
                    source.display()
                )));
            }
            tinyraytracer = find("g++", TINYRAYTRACER).map(|compiler| (compiler, source));
        }
        Ok(Self {
            povray,
            tinyraytracer,
            missing,
        })
    }
}

/// One of them or of ours, and the seconds that it took in each round.
struct Runner<'a> {
    picture: &'static str,
    name: &'static str,
    run: Box<dyn Fn() -> Result<f64, Failure> + 'a>,
    seconds: Vec<f64>,
}

fn race(folder: &str) -> Result<(), Failure> {
    let path = std::env::var_os("PATH").unwrap_or_default();
    let peers = Peers::look(folder, &path)?;
    only_in_release()?;
    peers.missing.iter().for_each(|line| canvas::say(line));
    let folder = tempfile::tempdir().map_err(failed("make a temporary folder"))?;
    let mut measured_on = vec![machine()];
    let mut runners = ours(folder.path());
    if let Some(povray) = &peers.povray {
        let said = output(Command::new(povray).arg("--version"))?;
        measured_on.push(first_line_with(POV_RAY, &said.stderr));
        runners.push(runner(SAMPLED, POV_RAY, || povray_s(povray, folder.path())));
    }
    if let Some((compiler, source)) = &peers.tinyraytracer {
        let said = output(Command::new(compiler).arg("--version"))?;
        measured_on.push(first_line_with("g++", &said.stdout));
        let program = folder.path().join("theirs");
        let mut compile = Command::new(compiler);
        compile.args(["-O3", "-march=native", "-o"]).arg(&program);
        output(compile.arg(source))?;
        let folder = folder.path();
        runners.push(runner(BALLS, TINYRAYTRACER, move || {
            timed(|| output(Command::new(&program).current_dir(folder)).map(drop))
        }));
    }
    let measured_on = measured_on.join("; ");
    canvas::say(&format!("measured on {measured_on}"));
    run_in_turns(&mut runners)?;
    let rows = table(&runners);
    let heading = row(["picture", "ours", "s", "beside", "s", "ratio"]);
    canvas::say(&format!(
        "medians of {ROUNDS} rounds in turns:\n{heading}\n{rows}"
    ));
    if peers.missing.is_empty() {
        let anchored = |name, text| {
            format!("<!-- ANCHOR: {name} -->\n{text}\n<!-- ANCHOR_END: {name} -->\n")
        };
        let file = anchored("machine", measured_on) + &anchored("ratios", rows);
        canvas::write_file(Path::new(TABLE), file.as_bytes()).map_err(Failure::Failed)?;
    } else {
        canvas::say("the book's table stays as it is: somebody is missing");
    }
    Ok(())
}

fn runner<'a>(
    picture: &'static str,
    name: &'static str,
    run: impl Fn() -> Result<f64, Failure> + 'a,
) -> Runner<'a> {
    Runner {
        picture,
        name,
        run: Box::new(run),
        seconds: Vec::new(),
    }
}

/// Ours, on one thread but where it says otherwise. `folder` takes files.
fn ours(folder: &Path) -> Vec<Runner<'_>> {
    let ways = |sight: PlainSight, reach, n| {
        [
            ("one by one", one_by_one(sight.clone(), reach, n)),
            ("packets", by_packets(sight, reach, n)),
        ]
    };
    let mut runners = Vec::new();
    for (picture, n) in [("still life", 1), (SAMPLED, 4)] {
        for (name, paint) in ways(plain_sight("still-life"), AS_POV_RAY, n) {
            runners.push(runner(picture, name, move || {
                timed(|| {
                    black_box(frame(&paint, SIZE, LANES));
                    Ok(())
                })
            }));
        }
    }
    for (name, paint) in ways(tinyraytracer::scene(), tinyraytracer::REACH, 1) {
        let file = folder.join(name);
        runners.push(runner(BALLS, name, move || {
            timed(|| {
                let light = frame(&paint, tinyraytracer::SIZE, LANES);
                let written = std::fs::write(&file, ppm(tinyraytracer::SIZE, &light));
                written.map_err(failed("write a temporary file"))
            })
        }));
    }
    for (threads, name) in [(1, "packets, 1 thread"), (2, "packets, 2 threads")] {
        let [_, (_, paint)] = ways(plain_sight("still-life"), AS_POV_RAY, 4);
        let pool = pool(threads);
        runners.push(runner(SAMPLED, name, move || {
            timed(|| {
                pool.install(|| black_box(Canvas::paint(&paint, SIZE)));
                Ok(())
            })
        }));
    }
    runners
}

fn run_in_turns(runners: &mut [Runner]) -> Result<(), Failure> {
    let style = ProgressStyle::with_template("{bar:40} {pos}/{len} {msg}")
        .expect("a valid template");
    let progress = ProgressBar::new((ROUNDS * runners.len()) as u64).with_style(style);
    for _ in 0..ROUNDS {
        for runner in &mut *runners {
            progress.set_message(runner.name);
            runner.seconds.push((runner.run)()?);
            progress.inc(1);
        }
    }
    progress.finish_and_clear();
    Ok(())
}

/// The rows of a table: a picture, who paints it in how many seconds, beside whom, and
/// the ratio, which is the rounds' median, too.
fn table(runners: &[Runner]) -> String {
    let find = |picture, name| {
        let is_it = |runner: &&Runner| runner.picture == picture && runner.name == name;
        runners.iter().find(is_it).map(|runner| &runner.seconds)
    };
    let rows = RATIOS.into_iter().filter_map(|[picture, name, beside]| {
        let [a, b] = [find(picture, name)?, find(picture, beside)?];
        let ratios = a.iter().zip(b).map(|(a, b)| a / b);
        let [a_s, b_s, ratio] = [a.clone(), b.clone(), ratios.collect()]
            .map(|values| three_digits(Some(median(values))));
        Some(row([picture, name, &a_s, beside, &b_s, &ratio]))
    });
    rows.collect::<Vec<_>>().join("\n")
}

fn row([picture, name, a_s, beside, b_s, ratio]: [&str; 6]) -> String {
    format!("| {picture:21} | {name:18} | {a_s:6} | {beside:17} | {b_s:6} | {ratio:6} |")
}

fn median(mut values: Vec<f64>) -> f64 {
    values.sort_by(f64::total_cmp);
    values[values.len() / 2]
}

/// The seconds that POV-Ray says it traced for, on one thread and by the clock, as ours
/// are: without its start, its parser and its file.
fn povray_s(povray: &Path, folder: &Path) -> Result<f64, Failure> {
    let mut command = Command::new(povray);
    command.args(["+W800", "+H600", "+A0.0", "+AM1", "+R4", "-J"]);
    command
        .args(["+WT1", "-D", "-V"])
        .arg(format!("+I{STILL_LIFE}"));
    command.arg(format!("+O{}", folder.join("theirs.png").display()));
    let said = output(&mut command)?.stderr;
    traced_s(&String::from_utf8_lossy(&said))
        .ok_or_else(|| Failure::Failed("POV-Ray does not say its time".to_string()))
}

/// Tracing is what POV-Ray does last: “Trace Time: … 5 seconds (5.998 seconds)”.
#[must_use]
pub fn traced_s(said: &str) -> Option<f64> {
    let (before, _) = said.rsplit_once(" seconds)")?;
    before.rsplit_once('(')?.1.parse().ok()
}

fn timed(work: impl FnOnce() -> Result<(), Failure>) -> Result<f64, Failure> {
    let start = Instant::now();
    work()?;
    Ok(start.elapsed().as_secs_f64())
}

/// What a program says that must succeed.
fn output(command: &mut Command) -> Result<Output, Failure> {
    let program = command.get_program().display().to_string();
    let output = command
        .output()
        .map_err(failed(&format!("run {program}")))?;
    if !output.status.success() {
        let said = String::from_utf8_lossy(&output.stderr);
        let mut lines = said.lines().filter(|line| !line.trim().is_empty());
        let error = lines.clone().find(|line| line.contains("error"));
        let line = error.or_else(|| lines.next_back());
        return Err(Failure::Failed(format!(
            "{program} fails: {}",
            line.unwrap_or("without a word")
        )));
    }
    Ok(output)
}

fn failed(what: &str) -> impl Fn(std::io::Error) -> Failure {
    move |error| Failure::Failed(format!("cannot {what}: {error}"))
}

fn first_line_with(word: &str, said: &[u8]) -> String {
    let said = String::from_utf8_lossy(said);
    let line = said.lines().find(|line| line.starts_with(word));
    line.unwrap_or(word).trim().to_string()
}
