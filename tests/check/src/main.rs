//! `check mine.png` compares a picture with the book's; `check 06` does so with all of a chapter's.

use check::figures::{Figure, figures};
use check::image::{self, Image};
use check::report::judge;
use clap::{Arg, Command, value_parser};
use std::ffi::OsStr;
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::process::{self, ExitCode, Stdio};
use std::time::{Duration, Instant};
use std::{env, fs, thread};

/// How it ended.
#[derive(Clone, Copy, PartialEq, PartialOrd)]
enum Exit {
    Equal = 0,
    Different = 1,
    Usage = 2,
}

type Book = (Vec<Figure>, Vec<(String, Image)>);

fn main() -> ExitCode {
    let exit = match run() {
        Ok(exit) => exit,
        Err((exit, message)) => {
            let _ = writeln!(io::stderr(), "error: {message}");
            exit
        }
    };
    ExitCode::from(exit as u8)
}

fn run() -> Result<Exit, (Exit, String)> {
    let usage = |message: String| (Exit::Usage, message);
    let command = Command::new("check")
        .about("Compares your picture with the book's, and names what probably went wrong")
        .after_help("Exit code: 0 if all are equal, 1 if one differs, 2 if there is nothing to compare.")
        .args([
            Arg::new("what")
                .value_name("PNG or CHAPTER")
                .required(true)
                .value_parser(value_parser!(PathBuf))
                .help("A PNG from any program, or a chapter's number or name: 06, 06-reflection, reflection"),
            Arg::new("picture")
                .long("picture")
                .value_name("NAME")
                .help("The book's picture that it is meant to be, like 06-reflection--bouncing"),
        ]);
    let matches = match command.try_get_matches() {
        Ok(matches) => matches,
        Err(error) if !error.use_stderr() => {
            print(&error.to_string())?;
            return Ok(Exit::Equal);
        }
        Err(error) => {
            let text = error.to_string();
            let first = text.split("\n\n").next().unwrap_or_default();
            let first = first.trim_start_matches("error: ");
            let words: Vec<_> = first.split_whitespace().collect();
            return Err(usage(format!(
                "{}; write check mine.png, or a chapter's number: check 06",
                words.join(" ")
            )));
        }
    };
    let what: &PathBuf = matches.get_one("what").expect("it is required");
    let told = matches.get_one::<String>("picture").map(String::as_str);
    let book = image::book().map_err(usage)?;
    let book = (figures(book.clone()), book);
    if !what.exists()
        && let Some(chapter) = chapter(what, &book.1)
    {
        if told.is_some() {
            let message = "--picture is for a PNG; a chapter's pictures have their names";
            return Err(usage(message.to_string()));
        }
        return check_chapter(&chapter, &book);
    }
    if let Some(name) = told {
        check_name(name, &book.1).map_err(usage)?;
    }
    check_file(what, told, &book)
}

/// Returns the whole name of a chapter that is given by its number or its name.
fn chapter(what: &Path, book: &[(String, Image)]) -> Option<String> {
    let what = what.to_str()?;
    let mut stages = book.iter().filter_map(|(name, _)| name.split_once("--"));
    let is_meant = |stage: &str| {
        let (number, name) = stage.split_once('-').unwrap_or((stage, ""));
        [stage, number, number.trim_start_matches('0'), name].contains(&what)
            || (what == "0" && number == "00")
    };
    stages
        .find(|(stage, _)| is_meant(stage))
        .map(|(stage, _)| stage.to_string())
}

/// Refuses a name that no picture of the book has.
fn check_name(name: &str, book: &[(String, Image)]) -> Result<(), String> {
    if book.iter().any(|(other, _)| other == name) {
        return Ok(());
    }
    // The names that share the most with it.
    let alike = |other: &str| {
        let words = name.split('-').filter(|word| !word.is_empty());
        words
            .filter(|word| other.split('-').any(|other| other == *word))
            .count()
    };
    let mut names: Vec<_> = book.iter().map(|(name, _)| &name[..]).collect();
    if names.iter().all(|name| alike(name) == 0) {
        return Err(format!(
            "the book has no picture {name}; a name is like 06-reflection--bouncing, and all are in book/src/pictures"
        ));
    }
    names.sort_by_key(|other| std::cmp::Reverse(alike(other)));
    Err(format!(
        "the book has no picture {name}; these are most like it: {}",
        names[..3].join(", ")
    ))
}

fn print(text: &str) -> Result<(), (Exit, String)> {
    match io::stdout().write_all(text.as_bytes()) {
        // A closed pipe is no error: its reader has seen enough.
        Err(error) if error.kind() != io::ErrorKind::BrokenPipe => {
            Err((Exit::Different, format!("cannot print: {error}")))
        }
        _ => Ok(()),
    }
}

fn check_file(
    path: &Path,
    told: Option<&str>,
    (figures, book): &Book,
) -> Result<Exit, (Exit, String)> {
    let shown = path.display();
    let (yours, notes) =
        image::read(path).map_err(|error| (Exit::Usage, format!("{shown}: {error}")))?;
    let stem = path
        .file_stem()
        .and_then(OsStr::to_str)
        .unwrap_or("picture");
    // A name that the book has says what is meant.
    let by_name = book.iter().map(|(name, _)| &name[..]);
    let told = told.or_else(|| by_name.into_iter().find(|name| *name == stem));
    let folder = target().join("check");
    let verdict = judge(&yours, told, (figures, book), (&folder, stem));
    let verdict = verdict.ok_or_else(|| {
        let message = "the book has no picture to compare with";
        (Exit::Usage, message.to_string())
    })?;
    let [w, h] = yours.size;
    let mut text = format!("{shown}, {w}x{h}\n");
    for note in notes {
        text += &format!("  {note}\n");
    }
    text += &verdict.text;
    print(&text)?;
    Ok(if verdict.is_equal {
        Exit::Equal
    } else {
        Exit::Different
    })
}

/// Returns the folder in which cargo builds: this program is in `target/debug` or the like.
fn target() -> PathBuf {
    let program = env::current_exe().unwrap_or_default();
    program
        .ancestors()
        .nth(2)
        .unwrap_or(Path::new("target"))
        .to_path_buf()
}

/// The longest that a picture of a chapter may take.
const PATIENCE: Duration = Duration::from_secs(120);

fn check_chapter(stage: &str, (figures, book): &Book) -> Result<Exit, (Exit, String)> {
    let broken = |message: String| (Exit::Different, message);
    let program = env::current_exe().map_err(|error| broken(error.to_string()))?;
    let bin = program.parent().unwrap_or(Path::new("."));
    let mut build = process::Command::new(env::var_os("CARGO").unwrap_or("cargo".into()));
    build.args(["build", "--quiet", "--bin", stage]);
    build.current_dir(concat!(env!("CARGO_MANIFEST_DIR"), "/../.."));
    if bin.file_name() == Some(OsStr::new("release")) {
        build.arg("--release");
    }
    let output = build
        .output()
        .map_err(|error| broken(format!("cargo: {error}")))?;
    if !output.status.success() {
        let stderr = String::from_utf8_lossy(&output.stderr);
        return Err(broken(format!(
            "{stage} cannot be built: {}; for more, cargo build --bin {stage}",
            first_error(&stderr)
        )));
    }
    let folder = target().join("check");
    fs::create_dir_all(&folder)
        .map_err(|error| broken(format!("{}: {error}", folder.display())))?;
    let mut exit = Exit::Equal;
    let mut equal = 0;
    let prefix = format!("{stage}--");
    for (name, image) in book.iter().filter(|(name, _)| name.starts_with(&prefix)) {
        let path = folder.join(format!("{name}.png"));
        let drawn = draw(&bin.join(stage), name, image.size, &path);
        let result = drawn.and_then(|()| {
            image::read(&path).map_err(|error| format!("{}: {error}", path.display()))
        });
        let (yours, _) = match result {
            Ok(yours) => yours,
            Err(message) => {
                exit = Exit::Different;
                print(&format!("{name}: {message}\n"))?;
                continue;
            }
        };
        let verdict = judge(&yours, Some(name), (figures, book), (&folder, name));
        let verdict = verdict.ok_or_else(|| broken(format!("no picture {name}")))?;
        if verdict.is_equal {
            equal += 1;
        } else {
            exit = Exit::Different;
            print(&format!(
                "{}\n",
                verdict.text.trim_start_matches("compared with ")
            ))?;
        }
    }
    print(&format!(
        "{stage}: {equal} pictures are equal to the book's\n"
    ))?;
    Ok(exit)
}

/// Returns the compiler's first error, and its place.
fn first_error(stderr: &str) -> String {
    let mut lines = stderr.lines().skip_while(|line| !line.starts_with("error"));
    let first = lines.next().unwrap_or("cargo failed, and said nothing");
    // An error of the compiler's has a number: error[E0425].
    let message = first.split_once(": ").map_or(first, |(_, message)| message);
    let place = lines
        .next()
        .and_then(|line| line.trim().strip_prefix("--> "));
    place.map_or(message.to_string(), |place| format!("{message}, {place}"))
}

/// Lets a chapter's program draw a picture, by its name: `STAGE--VIEW--knob-SETTING`.
fn draw(program: &Path, name: &str, [w, h]: [u32; 2], path: &Path) -> Result<(), String> {
    let mut parts = name.split("--").skip(1);
    let mut command = process::Command::new(program);
    command.args(["--view", parts.next().unwrap_or_default()]);
    if let Some(setting) = parts.next().and_then(|part| part.strip_prefix("knob-")) {
        command.args(["--knob", &setting.replace('_', ".")]);
    }
    command
        .args(["--size", &format!("{w}x{h}"), "--png"])
        .arg(path);
    command.stdout(Stdio::null()).stderr(Stdio::piped());
    // An old picture must not be taken for a new one.
    let _ = fs::remove_file(path);
    let mut child = command.spawn().map_err(|error| error.to_string())?;
    let start = Instant::now();
    let status = loop {
        match child.try_wait().map_err(|error| error.to_string())? {
            Some(status) => break status,
            None if start.elapsed() > PATIENCE => {
                let _ = child.kill();
                let _ = child.wait();
                let seconds = PATIENCE.as_secs();
                return Err(format!("not drawn after {seconds} s: does a loop not end?"));
            }
            None => thread::sleep(Duration::from_millis(5)),
        }
    };
    if status.success() {
        return Ok(());
    }
    let stderr = io::read_to_string(child.stderr.take().ok_or("no stderr")?);
    let stderr = stderr.map_err(|error| error.to_string())?;
    let lines: Vec<_> = stderr
        .lines()
        .filter(|line| !line.trim().is_empty())
        .collect();
    let words = lines.iter().take(2).copied().collect::<Vec<_>>().join(" ");
    Err(format!(
        "the program failed: {}",
        words.trim_start_matches("error: ")
    ))
}
