//! `cargo bench --bench race`: renders the still life in turns with what the project was at an
//! older commit, which is built beside it, and writes the ratios into the book.

mod clock;
#[path = "../common.rs"]
mod common;

use common::Error;
use glam::UVec2;
use measure::median;
use measure::pictures::{frame, packet_picture, scalar_picture};
use measure::scenes::plain_scene;
use preview::{print_line, write_file};
use ray_casting::scene::still_life_camera;
use reflection::{MAX_DEPTH, PathBudget};
use shadow_acne::from_eye;
use speed_and_accuracy::table::three_digits;
use std::fs;
use std::hint::black_box;
use std::io::{BufRead, BufReader, Write};
use std::path::{Path, PathBuf};
use std::process::{Child, Command, ExitCode, Stdio};
use transparency::scene::{AMBER, absorbing_still_life};

const USAGE: &str = "cargo bench --bench race, with no argument";

/// The commit at which the packets were first measured.
const BEFORE: &str = "3d0ceecce497c314fb4a73320f98bb5965e749d6";

/// Odd, so that one is in the middle.
const ROUNDS: usize = 7;

/// If the ratios of the rounds, without the least and the greatest, differ by more than this
/// factor, the machine is busy.
const QUIET: f64 = 1.15;

const SIZE: UVec2 = UVec2::new(800, 600);

/// The table that the book includes.
const TABLE: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/book/src/studies/race.md");

/// A picture's name for the older program, how often it is rendered in a round, and what it is.
const PICTURES: [(&str, u32, &str); 4] = [
    ("packets-4", 4, "packets, 4 × 4"),
    ("packets-1", 40, "packets, one sample"),
    ("10", 1, "chapter 10, 4 × 4"),
    ("11", 1, "chapter 11, 4 × 4"),
];

fn main() -> ExitCode {
    common::run(run)
}

fn run(arguments: &[String]) -> Result<(), Error> {
    match arguments {
        [] => race(),
        [help] if help == "--help" => Ok(print_line(USAGE)?),
        _ => Err(Error::Usage(format!("it takes no argument: {USAGE}"))),
    }
}

fn race() -> Result<(), Error> {
    common::check_release()?;
    let mut before = start(&build_before()?)?;
    let measured_on = format!("{}, {}", common::machine(), today()?);
    print_line(&format!("measured on {measured_on}"))?;
    let pictures = PICTURES.map(|(name, ..)| picture(name));
    let mut rounds = vec![Vec::new(); PICTURES.len()];
    for round in 1..=ROUNDS {
        print_line(&format!("round {round} of {ROUNDS}"))?;
        for (i, (name, times, _)) in PICTURES.into_iter().enumerate() {
            let theirs = before.seconds(name, times)?;
            let start = clock::cpu_s();
            for _ in 0..times {
                black_box(frame(&pictures[i], SIZE, SIZE.x as usize));
            }
            let ours = (clock::cpu_s() - start) / f64::from(times);
            rounds[i].push([theirs, ours]);
        }
    }
    let rows: Vec<_> = PICTURES.iter().zip(&rounds).map(row).collect();
    let spread = rows.iter().map(|(_, spread)| *spread).fold(1.0, f64::max);
    let rows: Vec<_> = rows.into_iter().map(|(row, _)| row).collect();
    let rows = rows.join("\n");
    print_line(&format!(
        "the still life, before and now: medians of {ROUNDS} rounds in turns, and the ratios' range\n{rows}"
    ))?;
    if spread > QUIET {
        print_line(&format!(
            "the machine is busy: a picture's ratios differ by a factor of {}, so they say nothing, and the book's table stays",
            three_digits(spread)
        ))?;
        return Ok(());
    }
    let anchored = |name: &str, text: &str| {
        format!("<!-- ANCHOR: {name} -->\n{text}\n<!-- ANCHOR_END: {name} -->\n")
    };
    let file = anchored("machine", &measured_on) + &anchored("ratios", &rows);
    write_file(Path::new(TABLE), |out| out.write_all(file.as_bytes()))?;
    Ok(())
}

/// Returns a row of the table, and by what factor its ratios differ, without the least and the
/// greatest.
fn row(((_, _, what), rounds): (&(&str, u32, &str), &Vec<[f64; 2]>)) -> (String, f64) {
    let mut ratios: Vec<_> = rounds.iter().map(|[before, now]| now / before).collect();
    ratios.sort_by(f64::total_cmp);
    let [before, now] = [0, 1].map(|i| rounds.iter().map(|round| round[i]).collect());
    let [before, now, ratio, least, most] = [
        median(before),
        median(now),
        ratios[ROUNDS / 2],
        ratios[1],
        ratios[ROUNDS - 2],
    ]
    .map(three_digits);
    let row = format!("| {what} | {before} | {now} | {ratio} | {least} to {most} |");
    (row, ratios[ROUNDS - 2] / ratios[1])
}

/// Returns the same pictures as the older program's.
fn picture(name: &str) -> canvas::Picture {
    let budget = PathBudget::new(MAX_DEPTH);
    let (scene, camera) = plain_scene("still-life");
    match name {
        "packets-4" => packet_picture(scene, camera, budget, 4),
        "packets-1" => packet_picture(scene, camera, budget, 1),
        "10" => scalar_picture(scene, camera, budget, 4),
        _ => {
            let (scene, camera) = (absorbing_still_life(AMBER), still_life_camera());
            let start = from_eye(&scene.objects, camera.eye);
            let radiance = move |point| {
                let ray = start(camera.ray(point));
                transparency::trace(&scene, &ray, budget, transparency::between_media)
            };
            canvas::Picture::new(move |pixel| anti_aliasing::regular(pixel, 4, &radiance))
        }
    }
}

/// Builds the older program beside this one, and returns its path.
fn build_before() -> Result<PathBuf, Error> {
    let failed = |what: &str, error: &dyn std::fmt::Display| {
        Error::Failed(format!("cannot {what}: {error}"))
    };
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("race");
    fs::create_dir_all(&folder).map_err(|error| failed("make a folder", &error))?;
    print_line("building the project as it was, which takes minutes the first time")?;
    let archive = folder.join("before.tar");
    let mut git = Command::new("git");
    git.current_dir(env!("CARGO_MANIFEST_DIR"));
    git.args(["archive", BEFORE, "-o"]).arg(&archive);
    let done = git.output();
    let done = done.map_err(|error| failed("run git", &error))?;
    if !done.status.success() {
        return Err(Error::Failed(format!(
            "this clone does not have commit {}: git fetch --unshallow",
            &BEFORE[..7]
        )));
    }
    let succeeds = |command: &mut Command, what: &str| match command.status() {
        Ok(status) if status.success() => Ok(()),
        Ok(status) => Err(failed(what, &status)),
        Err(error) => Err(failed(what, &error)),
    };
    let mut tar = Command::new("tar");
    tar.arg("-xf").arg(&archive).arg("-C").arg(&folder);
    succeeds(&mut tar, "unpack it")?;
    let package = folder.join("chapters/race");
    let files = [
        ("Cargo.toml", include_str!("before.toml")),
        ("src/main.rs", include_str!("before.rs")),
        ("src/clock.rs", include_str!("clock.rs")),
    ];
    for (name, text) in files {
        let path = package.join(name);
        let written = fs::create_dir_all(path.parent().unwrap_or(&package))
            .and_then(|()| fs::write(&path, text));
        written.map_err(|error| failed("write its program", &error))?;
    }
    let mut cargo = Command::new(env!("CARGO"));
    cargo.current_dir(&folder);
    cargo.args([
        "build",
        "--release",
        "--quiet",
        "--package",
        "race",
        "--target-dir",
    ]);
    cargo.arg(folder.join("target"));
    succeeds(&mut cargo, "build it")?;
    Ok(folder.join("target/release/race"))
}

/// The older program, which waits for the names of pictures.
struct Before {
    child: Child,
    answers: BufReader<std::process::ChildStdout>,
}

fn start(program: &Path) -> Result<Before, Error> {
    let mut command = Command::new(program);
    command.stdin(Stdio::piped()).stdout(Stdio::piped());
    let child = command.spawn();
    let mut child =
        child.map_err(|error| Error::Failed(format!("cannot run it: {error}")))?;
    let stdout = child.stdout.take().expect("a pipe");
    Ok(Before {
        child,
        answers: BufReader::new(stdout),
    })
}

impl Before {
    /// Returns the seconds of CPU time that it takes to render a picture.
    fn seconds(&mut self, name: &str, times: u32) -> Result<f64, Error> {
        let stopped = || Error::Failed("the older program has stopped".to_string());
        let stdin = self.child.stdin.as_mut().expect("a pipe");
        writeln!(stdin, "{name} {times}").map_err(|_| stopped())?;
        let mut answer = String::new();
        self.answers.read_line(&mut answer).map_err(|_| stopped())?;
        answer.trim().parse().map_err(|_| stopped())
    }
}

/// Returns today's date.
fn today() -> Result<String, Error> {
    let output = Command::new("date").arg("+%Y-%m-%d").output();
    let output =
        output.map_err(|error| Error::Failed(format!("cannot run date: {error}")))?;
    Ok(String::from_utf8_lossy(&output.stdout).trim().to_string())
}
