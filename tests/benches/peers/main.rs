//! `cargo bench --bench peers -- FOLDER`: times POV-Ray beside ours, and tinyraytracer, whose
//! source is in FOLDER, and writes the ratios into the book.

#[path = "../common.rs"]
mod common;
mod found;
mod tinyraytracer;

use canvas::Canvas;
use common::Error;
use found::{POV_RAY, Peers, TINYRAYTRACER, traced_s};
use glam::UVec2;
use measure::median;
use measure::pictures::{frame, packet_picture, pool, scalar_picture};
use measure::scenes::plain_scene;
use packets::LANES;
use preview::{print_line, write_file};
use ray_casting::Camera;
use reflection::PathBudget;
use refraction::Material;
use shadows::Scene;
use speed_and_accuracy::table::three_digits;
use std::hint::black_box;
use std::io::Write;
use std::path::Path;
use std::process::{Command, ExitCode, Output};
use std::time::Instant;

const USAGE: &str =
    "cargo bench --bench peers -- FOLDER, the one of tinyraytracer.cpp, or none";

/// Odd, so that one is in the middle.
const ROUNDS: usize = 7;

/// The table that the book includes.
const TABLE: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/book/src/studies/peers.md");

/// The still life for POV-Ray, which follows rays as far as [`AS_POV_RAY`].
const STILL_LIFE: &str =
    concat!(env!("CARGO_MANIFEST_DIR"), "/tests/povray/still-life.pov");
const SIZE: UVec2 = UVec2::new(800, 600);
const AS_POV_RAY: PathBudget = PathBudget {
    depth: 5,
    throughput: 1.0,
    min_throughput: 0.0,
};

/// A picture, who renders it, and beside whom.
const RATIOS: [[&str; 3]; 7] = [
    [SAMPLED, "one by one", POV_RAY],
    [SAMPLED, "packets", POV_RAY],
    [BALLS, "one by one", TINYRAYTRACER],
    [BALLS, "packets", TINYRAYTRACER],
    ["still life", "packets", "one by one"],
    [SAMPLED, "packets", "one by one"],
    [SAMPLED, "canvas, 2 threads", "canvas, 1 thread"],
];
const SAMPLED: &str = "still life, 4 × 4";
const BALLS: &str = "tinyraytracer's balls";

/// One of theirs or of ours, and the seconds that it took in each round.
struct Runner<'a> {
    picture: &'static str,
    name: &'static str,
    run: Box<dyn Fn() -> Result<f64, Error> + 'a>,
    seconds: Vec<f64>,
}

fn main() -> ExitCode {
    common::run(run)
}

fn run(arguments: &[String]) -> Result<(), Error> {
    match arguments {
        [help] if help == "--help" => {
            print_line(USAGE)?;
            Ok(())
        }
        [folder] => race(folder),
        _ => Err(Error::Usage(format!("name one folder: {USAGE}"))),
    }
}

fn race(folder: &str) -> Result<(), Error> {
    let path = std::env::var_os("PATH").unwrap_or_default();
    let peers = Peers::find(folder, &path);
    let peers = peers.map_err(|error| Error::Usage(error.to_string()))?;
    common::check_release()?;
    peers.missing.iter().try_for_each(print_line)?;
    let folder = tempfile::tempdir().map_err(failed("make a temporary folder"))?;
    let mut measured_on = vec![common::machine()];
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
    print_line(&format!("measured on {measured_on}"))?;
    for round in 1..=ROUNDS {
        print_line(&format!("round {round} of {ROUNDS}"))?;
        for runner in &mut runners {
            runner.seconds.push((runner.run)()?);
        }
    }
    let rows = table(&runners);
    let heading = row(["picture", "ours", "s", "beside", "s", "ratio"]);
    print_line(&format!(
        "medians of {ROUNDS} rounds in turns:\n{heading}\n{rows}"
    ))?;
    if peers.missing.is_empty() {
        let anchored = |name, text| {
            format!("<!-- ANCHOR: {name} -->\n{text}\n<!-- ANCHOR_END: {name} -->\n")
        };
        let file = anchored("machine", measured_on) + &anchored("ratios", rows);
        write_file(Path::new(TABLE), |out| out.write_all(file.as_bytes()))?;
    } else {
        print_line("the book's table stays as it is: a tracer is missing")?;
    }
    Ok(())
}

fn runner<'a>(
    picture: &'static str,
    name: &'static str,
    run: impl Fn() -> Result<f64, Error> + 'a,
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
    let both = |(scene, camera): (Scene<Material>, Camera), budget, n| {
        [
            (
                "one by one",
                scalar_picture(scene.clone(), camera, budget, n),
            ),
            ("packets", packet_picture(scene, camera, budget, n)),
        ]
    };
    let mut runners = Vec::new();
    for (name, n) in [("still life", 1), (SAMPLED, 4)] {
        for (method, picture) in both(plain_scene("still-life"), AS_POV_RAY, n) {
            runners.push(runner(name, method, move || {
                timed(|| {
                    black_box(frame(&picture, SIZE, LANES));
                    Ok(())
                })
            }));
        }
    }
    for (method, picture) in both(tinyraytracer::scene(), tinyraytracer::BUDGET, 1) {
        let file = folder.join(method);
        runners.push(runner(BALLS, method, move || {
            timed(|| {
                let radiance = frame(&picture, tinyraytracer::SIZE, LANES);
                let ppm = tinyraytracer::ppm(tinyraytracer::SIZE, &radiance);
                std::fs::write(&file, ppm).map_err(failed("write a temporary file"))
            })
        }));
    }
    for (threads, name) in [(1, "canvas, 1 thread"), (2, "canvas, 2 threads")] {
        let [_, (_, picture)] = both(plain_scene("still-life"), AS_POV_RAY, 4);
        let pool = pool(threads);
        runners.push(runner(SAMPLED, name, move || {
            timed(|| {
                pool.install(|| black_box(Canvas::render(&picture, SIZE)));
                Ok(())
            })
        }));
    }
    runners
}

/// The rows of a table: a picture, who renders it in how many seconds, beside whom, and
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
            .map(|values| three_digits(median(values)));
        Some(row([picture, name, &a_s, beside, &b_s, &ratio]))
    });
    rows.collect::<Vec<_>>().join("\n")
}

fn row([picture, name, a_s, beside, b_s, ratio]: [&str; 6]) -> String {
    format!("| {picture:21} | {name:18} | {a_s:6} | {beside:17} | {b_s:6} | {ratio:6} |")
}

/// The seconds that POV-Ray says it traced for, on one thread and by the clock, as ours
/// are: without its start, its parser and its file.
fn povray_s(povray: &Path, folder: &Path) -> Result<f64, Error> {
    let mut command = Command::new(povray);
    command.args(["+W800", "+H600", "+A0.0", "+AM1", "+R4", "-J"]);
    command.args(["+WT1", "-D", "-V"]);
    command.arg(format!("+I{STILL_LIFE}"));
    command.arg(format!("+O{}", folder.join("theirs.png").display()));
    let said = output(&mut command)?.stderr;
    traced_s(&String::from_utf8_lossy(&said))
        .ok_or_else(|| Error::Failed("POV-Ray does not say its time".to_string()))
}

fn timed(work: impl FnOnce() -> Result<(), Error>) -> Result<f64, Error> {
    let start = Instant::now();
    work()?;
    Ok(start.elapsed().as_secs_f64())
}

/// Returns the output of a program. An error if it does not succeed.
fn output(command: &mut Command) -> Result<Output, Error> {
    let program = command.get_program().display().to_string();
    let output = command.output();
    let output = output.map_err(failed(&format!("run {program}")))?;
    if !output.status.success() {
        let said = String::from_utf8_lossy(&output.stderr);
        let mut lines = said.lines().filter(|line| !line.trim().is_empty());
        let error = lines.clone().find(|line| line.contains("error"));
        let line = error.or_else(|| lines.next_back());
        return Err(Error::Failed(format!(
            "{program} fails: {}",
            line.unwrap_or("without a word")
        )));
    }
    Ok(output)
}

fn failed(what: &str) -> impl Fn(std::io::Error) -> Error {
    move |error| Error::Failed(format!("cannot {what}: {error}"))
}

fn first_line_with(word: &str, said: &[u8]) -> String {
    let said = String::from_utf8_lossy(said);
    let line = said.lines().find(|line| line.starts_with(word));
    line.unwrap_or(word).trim().to_string()
}
