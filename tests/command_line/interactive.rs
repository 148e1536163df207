//! The arguments of the walk that no other chapter has.

use super::*;
use ::interactive::{CameraPose, STAGE};
use canvas::Picture;
use reflection::{MAX_DEPTH, PathBudget};
use refraction::scene::{AIR, GLASS, still_life_with_glass};
use shadow_acne::{from_surface, trace, untracked};
use std::collections::BTreeSet;

#[test]
fn camera_and_trace_and_target_say_what_is_wrong_with_them() {
    let folder = temp();
    let refused = |arguments: &[&str], words: &[&str]| {
        let mut command = command(STAGE.name, arguments, folder.path());
        assert_refused(&mut command, folder.path(), 2, words);
    };
    #[rustfmt::skip]
    let cameras = [
        "", "1,2,3", "0,2,-7,0,NaN,7,2", "0,2,-7,0,1,0,2", "0,2,-7,0,-1,7,99", "2000,2,-7,0,-1,7,2", "two\nlines",
    ];
    for camera in cameras {
        for other in [["--png", "a.png"], ["--trace", "1,1"], ["--size", "8x6"]] {
            let arguments = [&["--camera", camera], &other[..]].concat();
            refused(&arguments, &["--camera", "seven numbers", "0,2,-7,"]);
        }
    }
    for pixel in ["", "1", "1,", "-1,0", "1.5,0", "1,2,3", "99999999999,0"] {
        refused(&["--trace", pixel, "--size", "8x6"], &["--trace", "X,Y"]);
    }
    for pixel in ["8,0", "0,6"] {
        let arguments = ["--trace", pixel, "--size", "8x6"];
        refused(&arguments, &["--trace", pixel, "8x6", "0,0 to 7,5"]);
    }
    for target in ["", "0", "-3", "fast", "33ms", "10001", "NaN"] {
        let words = ["--target", "milliseconds", "1 to 10000"];
        refused(&["--target", target], &words);
    }
    for other in [["--png", "a.png"], ["--all", "."], ["--target", "33"]] {
        let arguments = [&["--trace", "1,1"], &other[..]].concat();
        refused(&arguments, &["--trace", other[0]]);
    }
    let camera = ["--camera", "0,2,-7,0,-1,7,2"];
    refused(
        &[&camera[..], &["--list"]].concat(),
        &["--camera", "--list"],
    );
    let help = accepted(STAGE.name, &["--help"], folder.path()).join("\n");
    #[rustfmt::skip]
    let words = ["--camera <NUMBERS>", "--trace <X,Y>", "--target <MS>", "W A S D", "Space"];
    for word in words {
        assert!(help.contains(word), "--help does not name {word}");
    }
    // No other chapter has them.
    let mut command = command(SHADING.name, &["--trace", "1,1"], folder.path());
    assert_refused(&mut command, folder.path(), 2, &["--trace", "--help"]);
}

#[test]
fn camera_says_from_where_and_the_picture_knows_it() {
    let folder = temp();
    let text = "1,1.5,-5,-0.2,-0.1,1,1.5";
    let pose: CameraPose = text.parse().expect("a pose");
    let camera = format!("--camera={text}");
    let arguments = ["--knob", "2", "--size", SMALL.0, &camera];
    // Without a display it is saved under the view's own name.
    let lines = accepted(STAGE.name, &arguments, folder.path());
    assert!(lines[0].starts_with("no window"), "{lines:?}");
    let path = folder.path().join(&lines[1]);
    let saved = image::open(&path).expect("a PNG");
    // The anti-aliasing chapter's sampler over the shadow-acne chapter's trace.
    let (scene, camera) = (still_life_with_glass(GLASS, AIR), pose.camera());
    let picture = Picture::new(move |pixel| {
        anti_aliasing::regular(pixel, 2, &|point| {
            let ray = untracked(camera.ray(point));
            trace(&scene, &ray, PathBudget::new(MAX_DEPTH), from_surface)
        })
    });
    let expected = Canvas::render(&picture, SMALL.1);
    assert!(saved.as_bytes() == expected.levels.as_flattened());
    let bytes = fs::read(&path).expect("its bytes");
    let bytes = String::from_utf8_lossy(&bytes);
    assert!(bytes.contains(&format!("--camera={pose} ")));
    let command = format!("cargo run --release --bin {} -- --view ", STAGE.name);
    assert!(bytes.contains(&command));
}

#[test]
fn from_the_start_every_view_is_the_books() {
    let folder = temp();
    let camera = format!("--camera={}", CameraPose::START);
    let path = folder.path().join("a.png");
    for view in STAGE.views {
        #[rustfmt::skip]
        let arguments = ["--view", view.name, &camera, "--size", SMALL.0, "--png", "a.png"];
        accepted(STAGE.name, &arguments, folder.path());
        assert_shows(&path, &STAGE, view.name, view.default_setting(), SMALL.1);
    }
}

#[test]
fn trace_explains_a_pixel_and_opens_no_window() {
    let folder = temp();
    let lines = accepted(STAGE.name, &["--trace", "480,390"], folder.path());
    assert!(lines[0].contains("480,390 of 800x600"), "{lines:?}");
    assert!(lines.iter().any(|line| line.contains("glass")), "{lines:?}");
    let arguments = ["--trace", "0,0", "--size", SMALL.0];
    let lines = accepted(STAGE.name, &arguments, folder.path());
    assert!(lines[0].contains("0,0 of 40x30"), "{lines:?}");
    assert!(
        !lines.iter().any(|line| line.contains("glass")),
        "{lines:?}"
    );
    assert!(names(folder.path()).is_empty());
}

/// Returns the command that a saved picture of the walk holds.
fn command_in(path: &Path) -> String {
    let info = programs::png_info(path);
    let latin = info.uncompressed_latin1_text.iter();
    let latin = latin.map(|text| (&text.keyword, text.text.clone()));
    let utf8 = info.utf8_text.iter();
    let utf8 = utf8.map(|text| (&text.keyword, text.get_text().expect("UTF-8")));
    let mut texts = latin.chain(utf8);
    let command = texts.find(|(keyword, _)| *keyword == "Command");
    command.expect("a command").1
}

/// Whatever a picture is called, a shell that is given its command draws it again, under the
/// same name, and does nothing else.
#[test]
#[cfg(unix)]
fn a_pictures_command_is_quoted_for_a_shell() {
    #[rustfmt::skip]
    let parts = [
        "plain", " ", "'", "\"", "$(touch x)", "`touch x`", ";touch x;", "\n", "\ntouch x\n", "-", "--", "--help", "-x ",
        "*", "?", "[a-z]", "{a,b}", "~", "#", " #", "&touch x&", "|touch x", "<a", ">x", "!", "!!", "\\", "\\\\", "\\'",
        "$HOME", "${HOME}", "$'a'", "%s", "=x", "(x)", "\t", "\r", "ü", "…", "日本", "''", "\"$(id)\"", "a'b\"c",
    ];
    // By itself, within a word, and behind a quote.
    let names: BTreeSet<_> = (parts.iter())
        .flat_map(|part| {
            ["{}.png", "a{}b.png", "'{}.png"].map(|form| form.replace("{}", part))
        })
        .collect();
    assert!(names.len() > 100);
    for name in names {
        let [folder, again] = [temp(), temp()];
        let png = format!("--png={name}");
        let arguments = ["--view", "shading", "--size", "8x6", &png];
        accepted(STAGE.name, &arguments, folder.path());
        let path = folder.path().join(&name);
        // What cargo would run.
        let cargo = "cargo() { shift 5; \"$PROGRAM\" \"$@\"; }";
        let mut sh = Command::new("sh");
        sh.args(["-c", &format!("{cargo}\n{}", command_in(&path))])
            .env("PROGRAM", programs::path(STAGE.name))
            .current_dir(again.path());
        let output = output(&mut sh);
        let stderr = text(&output.stderr);
        assert_eq!(output.status.code(), Some(0), "{name}: {stderr}");
        assert_eq!(super::names(again.path()), [name.as_str()]);
        let drawn = fs::read(again.path().join(&name)).expect("a picture");
        // Its command is the same as well.
        assert!(drawn == fs::read(&path).expect("a picture"), "{name}");
    }
}
