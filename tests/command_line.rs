//! The command line: the real binaries, every option, and every input that makes no sense.

use canvas::{Canvas, Stage};
use glam::UVec2;
use light_backwards::STAGES;
use speed_and_accuracy::STUDIES;
use std::collections::BTreeMap;
use std::ffi::OsStr;
use std::fs;
use std::path::Path;
use std::process::{Command, Output};
use tempfile::TempDir;

/// Every chapter's binary, in the order of [`STAGES`].
const BINARIES: [&str; STAGES.len()] = [
    env!("CARGO_BIN_EXE_00-canvas"),
    env!("CARGO_BIN_EXE_01-ray-casting"),
    env!("CARGO_BIN_EXE_02-sphere-hit"),
    env!("CARGO_BIN_EXE_03-plane-hit"),
    env!("CARGO_BIN_EXE_04-shadows"),
    env!("CARGO_BIN_EXE_05-shading"),
    env!("CARGO_BIN_EXE_06-reflection"),
    env!("CARGO_BIN_EXE_07-refraction"),
    env!("CARGO_BIN_EXE_08-fresnel"),
    env!("CARGO_BIN_EXE_09-anti-aliasing"),
    env!("CARGO_BIN_EXE_10-shadow-acne"),
    env!("CARGO_BIN_EXE_11-transparency"),
    env!("CARGO_BIN_EXE_12-packets"),
    env!("CARGO_BIN_EXE_13-speed-and-accuracy"),
    env!("CARGO_BIN_EXE_14-interactive"),
];
const SPHERE_HIT: &str = BINARIES[2];
const SHADOWS: &str = BINARIES[4];
const SHADING: &str = BINARIES[5];
const SPEED_AND_ACCURACY: &str = BINARIES[13];
const INTERACTIVE: &str = BINARIES[14];

/// A small picture's size, as an argument and as the library has it.
const SMALL: (&str, UVec2) = ("40x30", UVec2::new(40, 30));

fn temp() -> TempDir {
    tempfile::tempdir().expect("a temporary folder")
}

/// `binary` with `arguments` in `folder`, where there is no display.
fn command<A: AsRef<OsStr>>(binary: &str, arguments: &[A], folder: &Path) -> Command {
    let mut command = Command::new(binary);
    command.args(arguments).current_dir(folder);
    command.env_remove("DISPLAY").env_remove("WAYLAND_DISPLAY");
    command
}

fn output(command: &mut Command) -> Output {
    command.output().expect("the binary runs")
}

fn text(bytes: &[u8]) -> &str {
    std::str::from_utf8(bytes).expect("the terminal is given UTF-8")
}

/// Runs what must succeed without a word on stderr; returns the lines on stdout.
fn accepted(binary: &str, arguments: &[&str], folder: &Path) -> Vec<String> {
    let output = output(&mut command(binary, arguments, folder));
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
    assert!(!stderr.contains("panicked"), "{command:?}: {stderr}");
    for word in words {
        assert!(
            stderr.contains(word),
            "{command:?} does not say '{word}': {stderr}"
        );
    }
    assert_eq!(listing(folder), before, "{command:?} wrote something");
}

/// What is in a folder: names, and what regular files hold.
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

/// Asserts that the file is a PNG with exactly the pixels that the library paints.
fn assert_shows(path: &Path, stage: &Stage, view: &str, setting: f32, size: UVec2) {
    let saved = image::open(path).expect("a PNG");
    let view = &stage.views[stage.find(view).expect("a view")];
    let expected = Canvas::paint(&(view.picture)(setting), size);
    assert_eq!((saved.width(), saved.height()), (size.x, size.y));
    assert_eq!(saved.color(), image::ColorType::Rgb8);
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
        assert_eq!(
            accepted(SHADOWS, &arguments, folder.path()),
            ["picture.PNG"]
        );
        assert_eq!(names(folder.path()), ["picture.PNG"]);
        let saved = image::ImageReader::open(folder.path().join("picture.PNG"));
        let saved = saved.expect("a file").with_guessed_format().expect("bytes");
        let saved = saved.decode().expect("a PNG");
        assert_eq!((saved.width(), saved.height()), (width, height));
    }
}

#[test]
fn view_chooses_the_picture_and_the_first_is_the_default() {
    let stage = STAGES[5];
    let folder = temp();
    let path = folder.path().join("a.png");
    let name = path.to_str().expect("UTF-8");
    accepted(SHADING, &["--size", SMALL.0, "--png", name], folder.path());
    assert_shows(&path, stage, stage.views[0].name, 0.0, SMALL.1);
    for view in stage.views {
        let arguments = ["--view", view.name, "--size", SMALL.0, "--png", name];
        assert_eq!(accepted(SHADING, &arguments, folder.path()), [name]);
        assert_shows(&path, stage, view.name, view.default_setting(), SMALL.1);
    }
}

#[test]
fn knob_turns_the_knob_from_end_to_end() {
    let settings = [
        (5, "specular", "1", 1.0),
        (5, "specular", "10", 10.0),
        (5, "specular", "256", 256.0),
        (2, "far-slide", "12.5", 12.5),
        (2, "far-slide", "1e6", 1e6),
    ];
    let folder = temp();
    let path = folder.path().join("a.png");
    for (chapter, view, knob, setting) in settings {
        #[rustfmt::skip]
        let arguments = ["--view", view, "--knob", knob, "--size", SMALL.0, "--png", "a.png"];
        accepted(BINARIES[chapter], &arguments, folder.path());
        assert_shows(&path, STAGES[chapter], view, setting, SMALL.1);
    }
}

#[test]
fn list_names_every_view_and_every_knobs_range() {
    let folder = temp();
    for (binary, stage) in BINARIES.into_iter().zip(STAGES) {
        let lines = accepted(binary, &["--list"], folder.path());
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
        let text = accepted(SHADOWS, &[help], folder.path()).join("\n");
        #[rustfmt::skip]
        let words = [
            "--view <NAME>", "--knob <X>", "--size <WxH>", "--png <PATH>", "--all <DIR>", "--list", "--help",
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
    for (binary, stage) in BINARIES.into_iter().zip(STAGES) {
        let folder = temp();
        fs::create_dir(folder.path().join("pictures")).expect("a folder");
        let arguments = ["--all", "pictures", "--size", SMALL.0];
        let printed = accepted(binary, &arguments, folder.path());
        let paths: Vec<_> = stage
            .views
            .iter()
            .map(|view| format!("pictures/{}--{}.png", stage.name, view.name))
            .collect();
        assert_eq!(printed, paths);
        assert_eq!(
            names(&folder.path().join("pictures")).len(),
            stage.views.len()
        );
        for (view, path) in stage.views.iter().zip(paths) {
            let path = folder.path().join(path);
            assert_shows(&path, stage, view.name, view.default_setting(), SMALL.1);
        }
    }
}

#[test]
fn without_a_display_the_picture_is_saved_instead() {
    let cases: [(&[&str], &str, f32, UVec2); 2] = [
        (&[], "05-shading--combined.png", 0.0, UVec2::new(800, 600)),
        (
            &["--view", "specular", "--knob", "7", "--size", SMALL.0],
            "05-shading--specular--knob-7.png",
            7.0,
            SMALL.1,
        ),
    ];
    for (arguments, name, setting, size) in cases {
        let folder = temp();
        let lines = accepted(SHADING, arguments, folder.path());
        assert_eq!(lines.len(), 2, "{lines:?}");
        assert!(lines[0].starts_with("no window"), "{lines:?}");
        assert_eq!(lines[1], name);
        assert_eq!(names(folder.path()), [name]);
        let view = name.split("--").nth(1).expect("a view's name");
        let view = view.trim_end_matches(".png");
        assert_shows(&folder.path().join(name), STAGES[5], view, setting, size);
    }
}

#[test]
fn a_bare_run_lists_the_chapters() {
    let folder = temp();
    let lines = accepted(env!("CARGO_BIN_EXE_chapters"), &[], folder.path());
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
    let help: &[&str] = &["--help"];
    #[rustfmt::skip]
    let cases: &[(&str, &[&str], &[&str])] = &[
        (SHADING, &["--view", "nope"], &["'nope'", "combined, ambient, diffuse, specular"]),
        (SHADING, &["--view", "Combined"], &["'Combined'", "combined, ambient"]),
        (SHADING, &["--view", ""], &["''", "combined, ambient"]),
        (SHADING, &["--view", "two\nlines"], &["combined, ambient"]),
        (SHADING, &["--view", "specular", "--knob", "shiny"], shininess),
        (SHADING, &["--view", "specular", "--knob", ""], shininess),
        (SHADING, &["--view", "specular", "--knob", "NaN"], shininess),
        (SHADING, &["--view", "specular", "--knob", "inf"], shininess),
        (SHADING, &["--view", "specular", "--knob", "-inf"], shininess),
        (SHADING, &["--view", "specular", "--knob", "-1"], shininess),
        (SHADING, &["--view", "specular", "--knob", "0"], shininess),
        (SHADING, &["--view", "specular", "--knob", "257"], shininess),
        (SHADING, &["--view", "specular", "--knob", "1.5"], shininess),
        (SPHERE_HIT, &["--view", "far-slide", "--knob", "0.99"], distance),
        (SPHERE_HIT, &["--view", "far-slide", "--knob", "1e7"], distance),
        (SPHERE_HIT, &["--view", "far-slide", "--knob", "1e99"], distance),
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
        (SHADOWS, &["--png", "a.jpg"], &["'a.jpg'", ".png"]),
        (SHADOWS, &["--png", "png"], &["'png'", ".png"]),
        (SHADOWS, &["--png", "."], &["'.'", ".png"]),
        (SHADOWS, &["--png", ".png"], &["'.png'", ".png"]),
    ];
    let folder = temp();
    fs::write(folder.path().join("old.png"), "an old picture").expect("a file");
    for (binary, arguments, words) in cases {
        // As it stands, and where it would otherwise have given a picture.
        let mut commands = vec![arguments.to_vec()];
        if !arguments.contains(&"--png") && !arguments.contains(&"--all") {
            commands.push([&["--png", "old.png"], *arguments].concat());
        }
        for arguments in commands {
            let mut command = command(binary, &arguments, folder.path());
            assert_refused(&mut command, folder.path(), 2, words);
        }
    }
}

#[test]
fn study_measures_no_study_that_there_is_not_and_nothing_in_a_debug_build() {
    let folder = temp();
    let refused = |arguments: &[&str], words: &[&str]| {
        let mut command = command(SPEED_AND_ACCURACY, arguments, folder.path());
        assert_refused(&mut command, folder.path(), 2, words);
    };
    let studies = STUDIES.map(|study| study.name).join(", ");
    for unknown in ["nope", "", "-1", "All", "two\nlines"] {
        refused(&["--study", unknown], &[&studies, "or all"]);
    }
    refused(&["--study"], &["--study <NAME>", "--help"]);
    for name in STUDIES.map(|study| study.name).into_iter().chain(["all"]) {
        for other in [["--view", name], ["--png", "a.png"], ["--all", "."]] {
            let arguments = [&["--study", name], &other[..]].concat();
            refused(&arguments, &["--study", other[0]]);
        }
        refused(&["--study", name, "--list"], &["--study", "--list"]);
        refused(&["--study", name, "--study", name], &["--study"]);
        // In release it would measure, for minutes, and write into the book.
        if cfg!(debug_assertions) {
            refused(&["--study", name], &["debug build", "cargo run --release"]);
        }
    }
    let help = accepted(SPEED_AND_ACCURACY, &["--help"], folder.path());
    assert!(help.join("\n").contains("--study <NAME>"), "{help:?}");
    // No other chapter measures.
    let mut command = command(SHADING, &["--study", "all"], folder.path());
    assert_refused(&mut command, folder.path(), 2, &["--study", "--help"]);
}

#[test]
fn camera_and_trace_and_target_say_what_is_wrong_with_them() {
    let folder = temp();
    let refused = |arguments: &[&str], words: &[&str]| {
        let mut command = command(INTERACTIVE, arguments, folder.path());
        assert_refused(&mut command, folder.path(), 2, words);
    };
    for camera in [
        "",
        "1,2,3",
        "0,2,-7,0,NaN,7,2",
        "0,2,-7,0,1,0,2",
        "two\nlines",
    ] {
        for other in [["--png", "a.png"], ["--trace", "1,1"], ["--size", "8x6"]] {
            let arguments = [&["--camera", camera], &other[..]].concat();
            refused(&arguments, &["--camera", "seven numbers", "0,2,-7,"]);
        }
    }
    for pixel in [
        "",
        "1",
        "1,",
        "8,0",
        "0,6",
        "-1,0",
        "1.5,0",
        "1,2,3",
        "99999999999,0",
    ] {
        let arguments = ["--trace", pixel, "--size", "8x6"];
        refused(&arguments, &["--trace", "no pixel of 8x6", "0,0 to 7,5"]);
    }
    for target in ["", "0", "-3", "fast", "33ms", "10001", "NaN"] {
        refused(
            &["--target", target],
            &["--target", "milliseconds", "1 to 10000"],
        );
    }
    for other in [["--png", "a.png"], ["--all", "."], ["--target", "33"]] {
        let arguments = [&["--trace", "1,1"], &other[..]].concat();
        refused(&arguments, &["--trace", other[0]]);
    }
    refused(
        &["--camera", "0,2,-7,0,-1,7,2", "--list"],
        &["--camera", "--list"],
    );
    let help = accepted(INTERACTIVE, &["--help"], folder.path()).join("\n");
    for word in [
        "--camera <NUMBERS>",
        "--trace <X,Y>",
        "--target <MS>",
        "W A S D",
        "Space",
    ] {
        assert!(help.contains(word), "--help does not name {word}");
    }
    // No other chapter walks.
    let mut command = command(SHADING, &["--trace", "1,1"], folder.path());
    assert_refused(&mut command, folder.path(), 2, &["--trace", "--help"]);
}

#[test]
fn camera_says_from_where_and_the_picture_knows_it() {
    let folder = temp();
    let camera = "1,1.5,-5,-0.2,-0.1,1,1.5";
    let walker: interactive::Walker = camera.parse().expect("a walker");
    for (view, knob, setting) in [(0, "2", 2.0), (8, "2.42", 2.42), (3, "", 0.0)] {
        let name = STAGES[14].views[view].name;
        let camera = format!("--camera={camera}");
        let mut arguments = vec!["--view", name, "--size", SMALL.0, &camera];
        if !knob.is_empty() {
            arguments.extend(["--knob", knob]);
        }
        // Without a display it is saved under the view's own name.
        let lines = accepted(INTERACTIVE, &arguments, folder.path());
        assert!(lines[0].starts_with("no window"), "{lines:?}");
        let path = folder.path().join(&lines[1]);
        let saved = image::open(&path).expect("a PNG");
        let picture = interactive::views::whole(view, walker.camera(), setting);
        let expected = Canvas::paint(&picture, SMALL.1);
        assert!(saved.as_bytes() == expected.levels.as_flattened(), "{name}");
        let bytes = fs::read(&path).expect("its bytes");
        let holds = |text: &str| {
            bytes
                .windows(text.len())
                .any(|part| part == text.as_bytes())
        };
        assert!(holds(&format!("Camera\0{walker}")), "{name}");
        assert!(
            holds("cargo run --release --bin 14-interactive -- --view "),
            "{name}"
        );
    }
}

#[test]
fn trace_explains_a_pixel_and_opens_no_window() {
    let folder = temp();
    let lines = accepted(INTERACTIVE, &["--trace", "480,390"], folder.path());
    assert_eq!(
        lines[0],
        "pixel 480,390 of 800x600, the ray through its centre"
    );
    assert!(
        lines.iter().any(|line| line.contains("enters glass")),
        "{lines:?}"
    );
    let arguments = ["--trace", "0,0", "--size", SMALL.0];
    let lines = accepted(INTERACTIVE, &arguments, folder.path());
    assert!(
        lines.iter().any(|line| line.contains("meets nothing")),
        "{lines:?}"
    );
    assert!(names(folder.path()).is_empty());
}

#[test]
fn peers_are_not_looked_for_where_there_is_no_source_or_timed_in_a_debug_build() {
    let folder = temp();
    let refused = |arguments: &[&str], code, words: &[&str]| {
        let mut command = command(SPEED_AND_ACCURACY, arguments, folder.path());
        assert_refused(&mut command, folder.path(), code, words);
    };
    for nowhere in ["nowhere", ".", "", "-1", "two\nlines"] {
        let words = ["tinyraytracer.cpp", "or none"];
        refused(&["--peers", nowhere], 1, &words);
    }
    refused(&["--peers"], 2, &["--peers <FOLDER>", "--help"]);
    refused(&["--peers", "none", "--list"], 2, &["--peers", "--list"]);
    // In release it would measure, for minutes.
    if cfg!(debug_assertions) {
        let words = ["debug build", "cargo run --release"];
        refused(&["--peers", "none"], 2, &words);
    }
}

#[test]
fn what_cannot_be_saved_is_refused_with_code_1_before_anything_is_written() {
    let folder = temp();
    let at = |name: &str| folder.path().join(name);
    fs::create_dir(at("folder.png")).expect("a folder");
    fs::create_dir(at("all")).expect("a folder");
    let last = format!(
        "04-shadows--{}.png",
        STAGES[4].views.last().expect("a view").name
    );
    let in_all = format!("all/{last}");
    let locked = ["locked.png", &in_all].map(at);
    for path in &locked {
        fs::write(path, "an old picture").expect("a file");
        let mut permissions = fs::metadata(path).expect("the file").permissions();
        permissions.set_readonly(true);
        fs::set_permissions(path, permissions).expect("a lock");
    }
    #[rustfmt::skip]
    let cases: [(&[&str], &[&str]); 7] = [
        (&["--png", "nowhere/a.png"], &["nowhere/a.png", "no folder nowhere", "create it"]),
        (&["--png", "locked.png/a.png"], &["no folder locked.png"]),
        (&["--png", "folder.png"], &["folder.png", "is a folder", "name a file"]),
        (&["--png", "locked.png"], &["locked.png", "read-only", "another name"]),
        (&["--all", "nowhere"], &["no folder nowhere", "create it"]),
        (&["--all", "locked.png"], &["no folder locked.png"]),
        (&["--all", "all"], &[&last, "read-only"]),
    ];
    for (arguments, words) in cases {
        let mut command = command(SHADOWS, arguments, folder.path());
        assert_refused(&mut command, folder.path(), 1, words);
    }
    assert_eq!(names(&at("all")), [last]);

    // The same without a display, where the picture would go to the current folder.
    let current = temp();
    let taken = format!("04-shadows--{}.png", STAGES[4].views[0].name);
    fs::create_dir(current.path().join(taken)).expect("a folder");
    let output = output(&mut command(SHADOWS, &[] as &[&str], current.path()));
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
        // A link to it, and not to a device: were it followed, root would replace that.
        symlink(&fifo, folder.path().join("link.png")).expect("a link");
        for name in ["fifo.png", "link.png"] {
            let mut command = command(SHADOWS, &["--png", name], folder.path());
            let words = [name, "not a regular file", "name one"];
            assert_refused(&mut command, folder.path(), 1, &words);
        }
    }

    #[test]
    fn a_folder_that_takes_no_files_is_refused() {
        let folder = temp();
        let locked = folder.path().join("locked");
        fs::create_dir(&locked).expect("a folder");
        fs::set_permissions(&locked, fs::Permissions::from_mode(0o555)).expect("a lock");
        let mut paths = Vec::new();
        // Nobody can create a file there, not even root, whom no permission stops.
        if Path::new("/proc/self").exists() {
            paths.push("/proc");
        }
        if fs::write(locked.join("probe"), "").is_err() {
            paths.push("locked");
        }
        for path in paths {
            for arguments in [["--png", &format!("{path}/a.png")], ["--all", path]] {
                let mut command = command(SHADOWS, &arguments, folder.path());
                command.args(["--size", SMALL.0]);
                assert_refused(&mut command, folder.path(), 1, &["cannot save", path]);
            }
        }
    }

    #[test]
    fn a_full_disk_leaves_the_old_picture_as_it_was() {
        let folder = temp();
        fs::write(folder.path().join("old.png"), "an old picture").expect("a file");
        // No file may grow beyond a few kilobytes: writing fails, as on a full disk.
        let limited = "trap '' XFSZ; ulimit -f 8; exec \"$@\"";
        for save in [["--png", "old.png"], ["--png", "new.png"], ["--all", "."]] {
            let arguments = ["-c", limited, "sh", SHADING, save[0], save[1]];
            let mut command = command("sh", &arguments, folder.path());
            assert_refused(&mut command, folder.path(), 1, &["cannot save", save[1]]);
        }
    }

    #[test]
    fn a_reader_that_went_away_is_no_reason_to_panic() {
        let chapters = env!("CARGO_BIN_EXE_chapters");
        #[rustfmt::skip]
        let cases: [(&str, &[&str]); 5] = [
            (chapters, &[]),
            (SHADING, &["--list"]),
            (SHADING, &["--help"]),
            (SHADING, &["--size", SMALL.0, "--png", "a.png"]),
            (SHADING, &["--size", SMALL.0]),
        ];
        let folder = temp();
        for (binary, arguments) in cases {
            let (reader, writer) = std::io::pipe().expect("a pipe");
            drop(reader);
            let output = output(command(binary, arguments, folder.path()).stdout(writer));
            assert_eq!(text(&output.stderr), "", "{arguments:?}");
            assert_eq!(output.status.code(), Some(0), "{arguments:?}");
        }
        assert_eq!(names(folder.path()), ["05-shading--combined.png", "a.png"]);
    }

    #[test]
    fn an_argument_that_is_not_utf_8_is_refused_unless_it_is_a_path() {
        let folder = temp();
        let odd = OsStr::from_bytes(b"\xff.png");
        let options = ["--view", "--knob", "--size"].map(|option| (SHADOWS, option));
        let tasks = ["--study", "--peers"].map(|task| (SPEED_AND_ACCURACY, task));
        for (binary, option) in options.into_iter().chain(tasks) {
            let arguments = [OsStr::new(option), odd];
            let mut command = command(binary, &arguments, folder.path());
            assert_refused(&mut command, folder.path(), 2, &["UTF-8", "--help"]);
        }
        // Linux takes any bytes for a name.
        if cfg!(target_os = "linux") {
            let arguments = ["--size", SMALL.0, "--png"].map(OsStr::new);
            let arguments = [&arguments[..], &[odd]].concat();
            let output = output(&mut command(SHADOWS, &arguments, folder.path()));
            assert_eq!(output.status.code(), Some(0));
            assert!(folder.path().join(odd).is_file());
        }
    }

    #[test]
    fn a_picture_that_replaces_another_is_an_ordinary_file() {
        let folder = temp();
        let at = |name: &str| folder.path().join(name);
        let mode = |name| {
            let metadata = fs::metadata(at(name)).expect("a file");
            metadata.permissions().mode() & 0o777
        };
        // Whatever the umask leaves of 0666.
        fs::write(at("ordinary"), "").expect("a file");
        fs::write(at("old.png"), "an old picture").expect("a file");
        symlink("old.png", at("link.png")).expect("a link");
        for name in ["old.png", "new.png", "link.png"] {
            let arguments = ["--size", SMALL.0, "--png", name];
            assert_eq!(accepted(SHADOWS, &arguments, folder.path()), [name]);
            assert_shows(&at(name), STAGES[4], STAGES[4].views[0].name, 0.0, SMALL.1);
            assert_eq!(mode(name), mode("ordinary"), "{name}");
        }
        assert!(at("link.png").is_symlink(), "a link stays a link");
        let all = ["link.png", "new.png", "old.png", "ordinary"];
        assert_eq!(names(folder.path()), all);
    }
}
