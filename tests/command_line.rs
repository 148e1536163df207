//! The command line: the real programs, every option, and every input that makes no sense.

#[path = "command_line/interactive.rs"]
mod interactive;
mod programs;

use canvas::{Canvas, Stage, View};
use glam::UVec2;
use stages::STAGES;
use std::collections::BTreeMap;
use std::ffi::OsStr;
use std::fs;
use std::path::Path;
use std::process::{Command, Output};
use std::thread::sleep;
use std::time::{Duration, Instant};
use tempfile::TempDir;

const SPHERE_HIT: &Stage = &sphere_hit::STAGE;
const SHADOWS: &Stage = &shadows::STAGE;
const SHADING: &Stage = &shading::STAGE;

/// A small picture's size, as an argument and as the library has it.
const SMALL: (&str, UVec2) = ("40x30", UVec2::new(40, 30));

fn temp() -> TempDir {
    tempfile::tempdir().expect("a temporary folder")
}

/// Returns a program with `arguments`, in `folder`, where there is no display.
fn command<A: AsRef<OsStr>>(program: &str, arguments: &[A], folder: &Path) -> Command {
    let mut command = Command::new(programs::path(program));
    command.args(arguments).current_dir(folder);
    command.env_remove("DISPLAY").env_remove("WAYLAND_DISPLAY");
    command
}

fn output(command: &mut Command) -> Output {
    command.output().expect("the program runs")
}

fn text(bytes: &[u8]) -> &str {
    std::str::from_utf8(bytes).expect("the terminal is given UTF-8")
}

/// Asserts that a program succeeds without a word on stderr; returns the lines on stdout.
fn accepted(program: &str, arguments: &[&str], folder: &Path) -> Vec<String> {
    let output = output(&mut command(program, arguments, folder));
    assert_eq!(text(&output.stderr), "", "{arguments:?}");
    assert_eq!(output.status.code(), Some(0), "{arguments:?}");
    text(&output.stdout).lines().map(str::to_owned).collect()
}

/// Asserts that `command` ends with `code` and one line on stderr that has all of `words`, and
/// leaves `folder` as it is.
fn assert_refused(command: &mut Command, folder: &Path, code: i32, words: &[&str]) {
    let before = listing(folder);
    let output = output(command);
    let stderr = text(&output.stderr);
    assert_eq!(output.status.code(), Some(code), "{command:?}: {stderr}");
    assert_eq!(text(&output.stdout), "", "{command:?}");
    let is_one_line = stderr.lines().count() == 1 && stderr.ends_with('\n');
    assert!(is_one_line, "{command:?}: {stderr}");
    assert!(stderr.starts_with("error: "), "{command:?}: {stderr}");
    for noise in ["panicked", "Usage:"] {
        assert!(!stderr.contains(noise), "{command:?}: {stderr}");
    }
    for word in words {
        assert!(
            stderr.contains(word),
            "{command:?} does not say '{word}': {stderr}"
        );
    }
    assert_eq!(listing(folder), before, "{command:?} wrote something");
}

/// Returns the contents of a folder: the names, and the bytes of regular files.
fn listing(folder: &Path) -> BTreeMap<String, Option<Vec<u8>>> {
    let entries = fs::read_dir(folder).expect("a folder");
    entries
        .map(|entry| {
            let entry = entry.expect("an entry");
            let is_file = entry.file_type().expect("its type").is_file();
            let holds = is_file.then(|| fs::read(entry.path()).expect("its bytes"));
            (entry.file_name().to_string_lossy().into_owned(), holds)
        })
        .collect()
}

fn names(folder: &Path) -> Vec<String> {
    listing(folder).into_keys().collect()
}

/// Asserts that the file is a PNG with exactly the pixels that the library renders.
fn assert_shows(path: &Path, stage: &Stage, view: &str, setting: f32, size: UVec2) {
    let saved = image::open(path).expect("a PNG");
    let view = stage.view(view).expect("a view");
    let expected = Canvas::render(&(view.picture)(setting), size);
    assert_eq!((saved.width(), saved.height()), (size.x, size.y));
    assert_eq!(saved.color(), image::ColorType::Rgb8);
    assert!(programs::png_info(path).srgb.is_some(), "no sRGB chunk");
    assert!(
        saved.as_bytes() == expected.levels.as_flattened(),
        "{} is not {} at {setting}",
        path.display(),
        view.name
    );
}

#[test]
fn png_saves_a_picture_of_the_right_size_and_prints_its_path() {
    let sizes = [
        ("", 800, 600),
        ("40x30", 40, 30),
        ("1x1", 1, 1),
        ("16384x1", 16_384, 1),
        ("1x16384", 1, 16_384),
    ];
    for (size, width, height) in sizes {
        let folder = temp();
        let mut arguments = vec!["--png", "picture.PNG"];
        if !size.is_empty() {
            arguments.extend(["--size", size]);
        }
        // Nothing but the path: a window was not even tried.
        let printed = accepted(SHADOWS.name, &arguments, folder.path());
        assert_eq!(printed, ["picture.PNG"]);
        assert_eq!(names(folder.path()), ["picture.PNG"]);
        let saved = image::ImageReader::open(folder.path().join("picture.PNG"));
        let saved = saved.expect("a file").with_guessed_format().expect("bytes");
        let saved = saved.decode().expect("a PNG");
        assert_eq!((saved.width(), saved.height()), (width, height));
    }
}

#[test]
fn view_chooses_the_picture_and_the_hero_is_the_default() {
    let folder = temp();
    let path = folder.path().join("a.png");
    let name = path.to_str().expect("UTF-8");
    let arguments = ["--size", SMALL.0, "--png", name];
    accepted(SHADING.name, &arguments, folder.path());
    assert_shows(&path, SHADING, SHADING.hero, 0.0, SMALL.1);
    for view in SHADING.views {
        let arguments = ["--view", view.name, "--size", SMALL.0, "--png", name];
        assert_eq!(accepted(SHADING.name, &arguments, folder.path()), [name]);
        assert_shows(&path, SHADING, view.name, view.default_setting(), SMALL.1);
    }
}

#[test]
fn knob_turns_the_knob_from_end_to_end() {
    let settings = [
        (SHADING, "specular", "1", 1.0),
        (SHADING, "specular", "10", 10.0),
        (SHADING, "specular", "256", 256.0),
        (SPHERE_HIT, "far-textbook", "12.5", 12.5),
        (SPHERE_HIT, "far-textbook", "1e6", 1e6),
    ];
    let folder = temp();
    let path = folder.path().join("a.png");
    for (stage, view, knob, setting) in settings {
        #[rustfmt::skip]
        let arguments = ["--view", view, "--knob", knob, "--size", SMALL.0, "--png", "a.png"];
        accepted(stage.name, &arguments, folder.path());
        assert_shows(&path, stage, view, setting, SMALL.1);
    }
}

#[test]
fn list_names_every_view_and_every_knobs_range() {
    let folder = temp();
    for stage in STAGES {
        let lines = accepted(stage.name, &["--list"], folder.path());
        assert!(lines[0].contains(stage.name) && lines[0].contains(stage.title));
        for view in stage.views {
            let line = lines.iter().position(|line| line == view.name);
            let line =
                line.unwrap_or_else(|| panic!("--list does not name {}", view.name));
            assert_eq!(lines[line + 1].trim(), view.caption);
            if let Some(knob) = &view.knob {
                assert!(lines[line + 2].contains(&knob.range()), "{}", view.name);
            }
        }
    }
    assert!(names(folder.path()).is_empty());
}

#[test]
fn help_names_every_option_and_key() {
    let folder = temp();
    for help in ["--help", "-h"] {
        let text = accepted(SHADING.name, &[help], folder.path()).join("\n");
        #[rustfmt::skip]
        let words = [
            "--view <NAME>", "--knob <X>", "--size <WxH>", "--png <PATH>", "--all <DIR>", "--list", "--help",
            "combined, ambient, diffuse, specular", "[default: combined]", "[default: 800x600]",
            "Tab", "1-9", "Up", "Down", "P saves", "Esc",
        ];
        for word in words {
            assert!(text.contains(word), "{help} does not name {word}");
        }
    }
    assert!(names(folder.path()).is_empty());
}

#[test]
fn all_saves_every_view_under_its_name() {
    for stage in STAGES {
        let folder = temp();
        fs::create_dir(folder.path().join("pictures")).expect("a folder");
        let arguments = ["--all", "pictures", "--size", SMALL.0];
        let printed = accepted(stage.name, &arguments, folder.path());
        let path = |view: &View| format!("pictures/{}--{}.png", stage.name, view.name);
        let paths: Vec<_> = stage.views.iter().map(path).collect();
        assert_eq!(printed, paths);
        let saved = names(&folder.path().join("pictures"));
        assert_eq!(saved.len(), stage.views.len());
        for (view, path) in stage.views.iter().zip(paths) {
            let path = folder.path().join(path);
            assert_shows(&path, stage, view.name, view.default_setting(), SMALL.1);
        }
    }
}

#[test]
fn without_a_display_the_picture_is_saved_instead() {
    let cases: [(&[&str], &str, f32, UVec2); 2] = [
        (&[], "combined", 0.0, UVec2::new(800, 600)),
        (
            &["--view", "specular", "--knob", "7", "--size", SMALL.0],
            "specular",
            7.0,
            SMALL.1,
        ),
    ];
    for (arguments, view, setting, size) in cases {
        let folder = temp();
        let lines = accepted(SHADING.name, arguments, folder.path());
        assert_eq!(lines.len(), 2, "{lines:?}");
        assert!(lines[0].starts_with("no window"), "{lines:?}");
        let knob = if setting == 7.0 { "--knob-7" } else { "" };
        let name = format!("{}--{view}{knob}.png", SHADING.name);
        assert_eq!(lines[1], name);
        assert_shows(&folder.path().join(&name), SHADING, view, setting, size);
        assert_eq!(names(folder.path()), [name]);
    }
}

#[test]
fn a_bare_run_lists_the_chapters() {
    let folder = temp();
    let lines = accepted("chapters", &[], folder.path());
    assert_eq!(lines.len(), STAGES.len());
    for (line, stage) in lines.iter().zip(STAGES) {
        let command = format!("cargo run --bin {} ", stage.name);
        assert!(
            line.starts_with(&command) && line.ends_with(stage.title),
            "{line}"
        );
    }
}

#[test]
fn what_makes_no_sense_is_refused_with_code_2_and_what_would_be_right() {
    let size: &[&str] = &["WxH", "800x600", "1 to 16384"];
    let shininess: &[&str] = &["shininess", "1 to 256, whole"];
    let distance: &[&str] = &["distance", "1 to 1000000 radii"];
    let views: &[&str] = &["--view <NAME>", "combined, ambient, diffuse, specular"];
    let help: &[&str] = &["--help"];
    #[rustfmt::skip]
    let cases: &[(&Stage, &[&str], &[&str])] = &[
        (SHADING, &["--view", "nope"], views),
        (SHADING, &["--view", "Combined"], views),
        (SHADING, &["--view", ""], views),
        (SHADING, &["--view", "two\nlines"], views),
        (SHADING, &["--view", "two\n\nlines"], views),
        (SHADING, &["--view", "nope"], &["'nope'"]),
        (SHADING, &["--view", "speculer"], &["'speculer'", "similar", "'specular'"]),
        (SHADING, &["--view", "specular", "--knob", "shiny"], shininess),
        (SHADING, &["--view", "specular", "--knob", ""], shininess),
        (SHADING, &["--view", "specular", "--knob", "NaN"], shininess),
        (SHADING, &["--view", "specular", "--knob", "inf"], shininess),
        (SHADING, &["--view", "specular", "--knob", "-inf"], shininess),
        (SHADING, &["--view", "specular", "--knob", "-1"], shininess),
        (SHADING, &["--view", "specular", "--knob", "0"], shininess),
        (SHADING, &["--view", "specular", "--knob", "257"], shininess),
        (SHADING, &["--view", "specular", "--knob", "1.5"], shininess),
        (SPHERE_HIT, &["--view", "far-textbook", "--knob", "0.99"], distance),
        (SPHERE_HIT, &["--view", "far-textbook", "--knob", "1e7"], distance),
        (SPHERE_HIT, &["--view", "far-textbook", "--knob", "1e99"], distance),
        (SHADING, &["--knob", "50"], &["combined", "no knob", "specular"]),
        (SHADOWS, &["--knob", "50"], &["no knob", "no view of this chapter"]),
        (SHADOWS, &["--size", "0x10"], size),
        (SHADOWS, &["--size", "10x0"], size),
        (SHADOWS, &["--size", "16385x1"], size),
        (SHADOWS, &["--size", "1x16385"], size),
        (SHADOWS, &["--size", "99999999999x1"], size),
        (SHADOWS, &["--size", "800"], size),
        (SHADOWS, &["--size", "axb"], size),
        (SHADOWS, &["--size", "-1x5"], size),
        (SHADOWS, &["--size", "1e3x2"], size),
        (SHADOWS, &["--size", "8x6x4"], size),
        (SHADOWS, &["--size", "x"], size),
        (SHADOWS, &["--size", ""], size),
        (SHADOWS, &["--colour", "red"], &["--colour", "--help"]),
        (SHADOWS, &["--veiw", "hard"], &["'--veiw'", "similar", "'--view'"]),
        (SHADOWS, &["picture.png"], &["picture.png", "--help"]),
        (SHADOWS, &["--list=all"], help),
        (SHADOWS, &["--view"], &["--view <NAME>", "--help"]),
        (SHADOWS, &["--knob"], &["--knob <X>", "--help"]),
        (SHADOWS, &["--size"], &["--size <WxH>", "--help"]),
        (SHADOWS, &["--png"], &["--png <PATH>", "--help"]),
        (SHADOWS, &["--png", ""], &["--png <PATH>", "--help"]),
        (SHADOWS, &["--all"], &["--all <DIR>", "--help"]),
        (SHADOWS, &["--all", ""], &["--all <DIR>", "--help"]),
        (SHADOWS, &["--size", "8x6", "--size", "8x6"], help),
        (SHADOWS, &["--png", "a.png", "--all", "."], &["--png", "--all"]),
        (SHADING, &["--all", ".", "--view", "specular", "--knob", "9"], &["--all", "--view", "--knob"]),
        (SHADOWS, &["--list", "--png", "a.png"], &["--list", "--png"]),
        (SHADOWS, &["--list", "--size", "8x6"], &["--list", "cannot be used with"]),
        (SHADOWS, &["--png", "a.jpg"], &["'a.jpg'", ".png"]),
        (SHADOWS, &["--png", "png"], &["'png'", ".png"]),
        (SHADOWS, &["--png", "."], &["'.'", ".png"]),
        (SHADOWS, &["--png", ".png"], &["'.png'", ".png"]),
    ];
    let folder = temp();
    fs::write(folder.path().join("old.png"), "an old picture").expect("a file");
    for (stage, arguments, words) in cases {
        // As it stands, and where it would otherwise have given a picture.
        let mut commands = vec![arguments.to_vec()];
        if !arguments.contains(&"--png") && !arguments.contains(&"--all") {
            commands.push([&["--png", "old.png"], *arguments].concat());
        }
        for arguments in commands {
            let mut command = command(stage.name, &arguments, folder.path());
            assert_refused(&mut command, folder.path(), 2, words);
        }
    }
}

#[test]
fn what_cannot_be_saved_is_refused_with_code_1_before_anything_is_written() {
    let folder = temp();
    let at = |name: &str| folder.path().join(name);
    fs::create_dir(at("folder.png")).expect("a folder");
    fs::create_dir(at("all")).expect("a folder");
    let last = SHADOWS.views.last().expect("a view").name;
    let last = format!("{}--{last}.png", SHADOWS.name);
    let in_all = format!("all/{last}");
    let locked = ["locked.png", &in_all].map(at);
    for path in &locked {
        fs::write(path, "an old picture").expect("a file");
        let mut permissions = fs::metadata(path).expect("the file").permissions();
        permissions.set_readonly(true);
        fs::set_permissions(path, permissions).expect("a lock");
    }
    #[rustfmt::skip]
    let cases: [(&[&str], &[&str]); 8] = [
        (&["--png", "two\nlines/a.png"], &["no folder two lines"]),
        (&["--png", "nowhere/a.png"], &["nowhere/a.png", "no folder nowhere", "create it"]),
        (&["--png", "locked.png/a.png"], &["no folder locked.png"]),
        (&["--png", "folder.png"], &["folder.png", "is a folder", "name a file"]),
        (&["--png", "locked.png"], &["locked.png", "read-only", "another name"]),
        (&["--all", "nowhere"], &["no folder nowhere", "create it"]),
        (&["--all", "locked.png"], &["no folder locked.png"]),
        (&["--all", "all"], &[&last, "read-only"]),
    ];
    for (arguments, words) in cases {
        let mut command = command(SHADOWS.name, arguments, folder.path());
        assert_refused(&mut command, folder.path(), 1, words);
    }
    assert_eq!(names(&at("all")), [last]);

    // The same without a display, where the picture would go to the current folder.
    let current = temp();
    let taken = format!("{}--{}.png", SHADOWS.name, SHADOWS.hero);
    fs::create_dir(current.path().join(taken)).expect("a folder");
    let none: &[&str] = &[];
    let output = output(&mut command(SHADOWS.name, none, current.path()));
    assert_eq!(output.status.code(), Some(1));
    assert!(text(&output.stderr).contains("is a folder"));
    assert_eq!(text(&output.stderr).lines().count(), 1);
}

#[cfg(unix)]
mod unix {
    use super::*;
    use std::os::unix::ffi::OsStrExt;
    use std::os::unix::fs::{PermissionsExt, symlink};

    #[test]
    fn what_is_not_a_file_is_refused() {
        let folder = temp();
        let fifo = folder.path().join("fifo.png");
        let made = Command::new("mkfifo").arg(&fifo).status();
        assert!(made.expect("mkfifo runs").success());
        let mut command = command(SHADOWS.name, &["--png", "fifo.png"], folder.path());
        let words = ["fifo.png", "not a regular file", "name one"];
        assert_refused(&mut command, folder.path(), 1, &words);
    }

    #[test]
    fn a_full_disk_leaves_the_old_picture_as_it_was() {
        let folder = temp();
        fs::write(folder.path().join("old.png"), "an old picture").expect("a file");
        // No file may grow beyond a few kilobytes: writing fails, as on a full disk.
        let limited = "trap '' XFSZ; ulimit -f 8; exec \"$@\"";
        let program = programs::path(SHADING.name);
        for save in [["--png", "old.png"], ["--png", "new.png"], ["--all", "."]] {
            let mut command = Command::new("sh");
            command.args(["-c", limited, "sh"]).arg(&program).args(save);
            command.current_dir(folder.path());
            assert_refused(&mut command, folder.path(), 1, &["cannot save", save[1]]);
        }
    }

    /// Every way to print something.
    const PRINTING: [(&str, &[&str]); 8] = [
        ("chapters", &[]),
        (SHADING.name, &["--list"]),
        (SHADING.name, &["--help"]),
        (SHADING.name, &["--size", SMALL.0, "--png", "a.png"]),
        (SHADING.name, &["--size", SMALL.0, "--all", "."]),
        (SHADING.name, &["--size", SMALL.0]),
        (::interactive::STAGE.name, &["--trace", "1,1"]),
        (::interactive::STAGE.name, &["--help"]),
    ];

    #[test]
    fn a_closed_stdout_is_no_reason_to_panic() {
        for (program, arguments) in PRINTING {
            let folder = temp();
            let (reader, writer) = std::io::pipe().expect("a pipe");
            drop(reader);
            let mut command = command(program, arguments, folder.path());
            let output = output(command.stdout(writer));
            assert_eq!(text(&output.stderr), "", "{arguments:?}");
            assert_eq!(output.status.code(), Some(0), "{arguments:?}");
            // The picture is saved all the same.
            if arguments.contains(&"--png") {
                assert_eq!(names(folder.path()), ["a.png"]);
            }
        }
    }

    #[test]
    #[cfg(target_os = "linux")]
    fn what_a_full_disk_loses_of_the_output_is_an_error() {
        for (program, arguments) in PRINTING {
            let folder = temp();
            let full = fs::File::options().write(true).open("/dev/full");
            let mut command = command(program, arguments, folder.path());
            let output = output(command.stdout(full.expect("/dev/full")));
            let stderr = text(&output.stderr);
            assert_eq!(output.status.code(), Some(1), "{arguments:?}");
            assert_eq!(stderr.lines().count(), 1, "{arguments:?}: {stderr}");
            assert!(stderr.starts_with("error: cannot print: "), "{stderr}");
        }
    }

    /// Returns a program that may use so many kilobytes of memory.
    fn with_memory(kilobytes: u64, program: &str, folder: &Path) -> Command {
        let mut command = Command::new("sh");
        command
            .args(["-c", "ulimit -v \"$1\"; shift; exec \"$@\"", "sh"])
            .arg(kilobytes.to_string())
            .arg(programs::path(program))
            .current_dir(folder)
            .env_remove("DISPLAY");
        command
    }

    /// As one canvas, this picture takes 1.2 GB.
    #[test]
    fn a_png_needs_no_more_memory_than_a_few_of_its_rows() {
        let folder = temp();
        let mut command = with_memory(600_000, canvas::STAGE.name, folder.path());
        command.args(["--size", "16384x4096", "--png", "a.png"]);
        let output = output(&mut command);
        assert_eq!(text(&output.stderr), "");
        assert_eq!(output.status.code(), Some(0));
        let info = programs::png_info(&folder.path().join("a.png"));
        assert_eq!((info.width, info.height), (16384, 4096));
    }

    #[test]
    fn where_memory_is_short_it_says_so() {
        let (mut succeeded, mut refused) = (0, 0);
        let limits = std::iter::successors(Some(16_000), |limit| Some(limit * 6 / 5));
        for kilobytes in limits.take_while(|&limit| limit < 3_000_000) {
            let folder = temp();
            let mut command = with_memory(kilobytes, SHADING.name, folder.path());
            command.args(["--size", "16384x8", "--png", "a.png"]);
            let output = output(&mut command);
            let stderr = text(&output.stderr);
            match output.status.code() {
                Some(0) => succeeded += 1,
                // Too little for the program to be loaded at all.
                Some(126 | 127) => {}
                code => {
                    assert_eq!(code, Some(1), "{kilobytes}: {stderr}");
                    assert_eq!(stderr.lines().count(), 1, "{kilobytes}: {stderr}");
                    assert!(stderr.starts_with("error: cannot save a.png: "), "{stderr}");
                    assert!(names(folder.path()).is_empty());
                    refused += 1;
                }
            }
        }
        assert!(succeeded > 0 && refused > 0, "{succeeded}, {refused}");
    }

    /// An emulated processor lacks the vectors of most that this is built on and for.
    #[test]
    #[cfg(all(target_arch = "x86_64", target_feature = "avx"))]
    fn on_an_older_processor_it_says_so() {
        for program in ["chapters", SHADING.name, ::interactive::STAGE.name] {
            let mut command = Command::new("qemu-x86_64");
            command
                .args(["-cpu", "Nehalem"])
                .arg(programs::path(program));
            let output = match command.arg("--list").output() {
                Ok(output) => output,
                Err(error) if error.kind() == std::io::ErrorKind::NotFound => {
                    return programs::skip("qemu-x86_64", "qemu-user");
                }
                Err(error) => panic!("qemu-x86_64 does not start: {error}"),
            };
            let stderr = text(&output.stderr);
            assert_eq!(output.status.code(), Some(1), "{program}: {stderr}");
            assert_eq!(stderr.lines().count(), 1, "{program}: {stderr}");
            assert!(stderr.contains("built for another processor"), "{stderr}");
        }
    }

    #[test]
    fn an_argument_that_is_not_utf_8_is_refused_unless_it_is_a_path() {
        let folder = temp();
        let odd = OsStr::from_bytes(b"\xff.png");
        for option in ["--view", "--knob", "--size"] {
            let arguments = [OsStr::new(option), odd];
            let mut command = command(SHADOWS.name, &arguments, folder.path());
            assert_refused(&mut command, folder.path(), 2, &["UTF-8", "--help"]);
        }
        // Linux takes any bytes for a name.
        if cfg!(target_os = "linux") {
            let arguments = ["--size", SMALL.0, "--png"].map(OsStr::new);
            let arguments = [&arguments[..], &[odd]].concat();
            let output = output(&mut command(SHADOWS.name, &arguments, folder.path()));
            assert_eq!(output.status.code(), Some(0));
            assert!(folder.path().join(odd).is_file());
        }
    }

    fn mode(path: &Path) -> u32 {
        fs::metadata(path).expect("a file").permissions().mode() & 0o777
    }

    #[test]
    fn a_new_picture_is_an_ordinary_file() {
        let folder = temp();
        let at = |name: &str| folder.path().join(name);
        // The bits of 0666 that the umask leaves.
        fs::write(at("ordinary"), "").expect("a file");
        let arguments = ["--size", SMALL.0, "--png", "new.png"];
        accepted(SHADOWS.name, &arguments, folder.path());
        assert_eq!(mode(&at("new.png")), mode(&at("ordinary")));
    }

    #[test]
    fn a_replaced_picture_keeps_its_links_and_its_mode() {
        let folder = temp();
        let at = |name: &str| folder.path().join(name);
        fs::create_dir(at("elsewhere")).expect("a folder");
        fs::write(at("old.png"), "an old picture").expect("a file");
        let links = [
            ("link.png", "old.png"),
            ("link-to-link.png", "link.png"),
            // From the link's folder, not from the current one.
            ("elsewhere/link.png", "../old.png"),
            // To what does not exist yet.
            ("dangling.png", "elsewhere/new.png"),
            ("elsewhere/dangling.png", "newer.png"),
        ];
        for (link, target) in links {
            symlink(target, at(link)).expect("a link");
        }
        for old in [0o600, 0o644, 0o666, 0o755, 0o200] {
            let permissions = fs::Permissions::from_mode(old);
            fs::set_permissions(at("old.png"), permissions).expect("a mode");
            for (name, _) in [("old.png", "")].into_iter().chain(links) {
                let arguments = ["--size", SMALL.0, "--png", name];
                assert_eq!(accepted(SHADOWS.name, &arguments, folder.path()), [name]);
                if old != 0o200 {
                    assert_shows(&at(name), SHADOWS, SHADOWS.hero, 0.0, SMALL.1);
                }
                assert_eq!(mode(&at("old.png")), old, "{name}");
            }
        }
        for (link, target) in links {
            assert_eq!(fs::read_link(at(link)).expect("a link"), Path::new(target));
        }
        let all = [
            "dangling.png",
            "elsewhere",
            "link-to-link.png",
            "link.png",
            "old.png",
        ];
        assert_eq!(names(folder.path()), all);
        let all = ["dangling.png", "link.png", "new.png", "newer.png"];
        assert_eq!(names(&at("elsewhere")), all);
    }

    #[test]
    fn a_link_that_leads_nowhere_is_refused_and_stays() {
        let folder = temp();
        let links = [
            ("itself.png", "itself.png", "itself.png: "),
            ("one.png", "two.png", "one.png: "),
            ("two.png", "one.png", "two.png: "),
            ("lost.png", "nowhere/a.png", "no folder ./nowhere"),
        ];
        for (link, target, _) in links {
            symlink(target, folder.path().join(link)).expect("a link");
        }
        for (link, target, words) in links {
            let mut command = command(SHADOWS.name, &["--png", link], folder.path());
            assert_refused(&mut command, folder.path(), 1, &[words]);
            let found = fs::read_link(folder.path().join(link));
            assert_eq!(found.expect("a link"), Path::new(target));
        }
    }

    #[test]
    fn an_interrupted_program_leaves_nothing() {
        use std::os::unix::process::ExitStatusExt;
        for (signal, number) in [("INT", 2), ("TERM", 15)] {
            let folder = temp();
            fs::write(folder.path().join("old.png"), "an old picture").expect("a file");
            // More than can be done before the signal.
            let arguments = ["--size", "16384x16384", "--png", "old.png"];
            let mut command = command(SHADING.name, &arguments, folder.path());
            let mut program = command.spawn().expect("the program runs");
            let deadline = Instant::now() + Duration::from_secs(60);
            while names(folder.path()).len() < 2 {
                assert!(Instant::now() < deadline, "nothing is saved");
                sleep(Duration::from_millis(10));
            }
            assert!(names(folder.path())[0].starts_with(".unfinished-"));
            let kill = Command::new("kill")
                .args(["-s", signal, &program.id().to_string()])
                .status();
            assert!(kill.expect("kill runs").success());
            let status = program.wait().expect("the program ends");
            assert_eq!(status.signal(), Some(number));
            assert_eq!(names(folder.path()), ["old.png"]);
            let old = fs::read(folder.path().join("old.png"));
            assert_eq!(old.expect("a file"), b"an old picture");
        }
    }
}
