//! The program: what it says of bad input and of good, on one screen.

use crate::rates::drawn;
use check::fault::Fault;
use check::figures::figures;
use check::image::{Image, book, write};
use check::mutations;
use harness::Numbers;
use std::ffi::OsStr;
use std::fs;
use std::path::Path;
use std::process::{Command, Output};

fn check(folder: &Path, arguments: &[&str]) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_check"));
    command.args(arguments).current_dir(folder);
    command.output().expect("the program runs")
}

fn folder() -> tempfile::TempDir {
    tempfile::tempdir().expect("a temporary folder")
}

fn image(size: [u32; 2]) -> Image {
    Image {
        size,
        levels: vec![[9, 9, 9]; (size[0] * size[1]) as usize],
    }
}

fn of_book(name: &str) -> Image {
    let pictures = book().expect("the book's pictures");
    let picture = pictures.into_iter().find(|(other, _)| other == name);
    picture.expect(name).1
}

/// Returns the picture of a figure, drawn with a fault.
fn with_fault(name: &str, size: [u32; 2], fault: Fault) -> Image {
    let figures = figures(book().expect("the book's pictures"));
    let figure = figures.iter().find(|figure| figure.name() == name);
    drawn(figure.expect(name), size, fault)
}

/// Bad input is refused with exit code 2 and one line that says what would be right.
#[test]
fn bad_input_is_refused_in_one_line() {
    let folder = folder();
    let path = |name: &str| folder.path().join(name);
    fs::create_dir(path("folder.png")).expect("a folder");
    fs::write(path("photo.jpg"), b"\xff\xd8\xff\xe0....JFIF").expect("a JPEG");
    fs::write(path("empty.png"), b"").expect("an empty file");
    fs::write(path("words.png"), b"not a picture").expect("a text");
    write(&path("one.png"), &image([1, 1])).expect("a PNG");
    write(&path("good.png"), &image([64, 48])).expect("a PNG");
    let good = fs::read(path("good.png")).expect("it was written");
    fs::write(path("cut.png"), &good[..good.len() - 20]).expect("half a PNG");
    fs::write(path("head.png"), &good[..20]).expect("less of a PNG");
    let mut changed = good.clone();
    changed[50] ^= 0xff;
    fs::write(path("changed.png"), changed).expect("a damaged PNG");
    // The header alone says 16384x16384: nothing of it must be read, nor room be made for it.
    let mut huge = good.clone();
    huge[16..24].copy_from_slice(&[0, 0, 64, 0, 0, 0, 64, 0]);
    let crc = png_crc(&huge[12..29]);
    huge[29..33].copy_from_slice(&crc.to_be_bytes());
    fs::write(path("huge.png"), huge).expect("a large PNG");
    for (arguments, words) in [
        (&[][..], "check mine.png"),
        (&["none.png"], "there is no such file"),
        (&["99"], "a chapter's number"),
        (&["folder.png"], "name one PNG in it"),
        (&["photo.jpg"], "a JPEG"),
        (&["empty.png"], "save the picture as a PNG"),
        (&["words.png"], "it is no PNG; save the picture as a PNG"),
        (&["cut.png"], "damaged"),
        (&["head.png"], "damaged"),
        (&["changed.png"], "damaged"),
        (&["one.png"], "each side must be from 32 to 4096"),
        (&["huge.png"], "16384x16384 pixels cannot be compared"),
        (
            &["good.png", "--picture", "06-reflection--bouncy"],
            "06-reflection--bouncing",
        ),
        (
            &["good.png", "--picture", "nonsense"],
            "all are in book/src/pictures",
        ),
        (&["good.png", "one.png"], "unexpected argument 'one.png'"),
        (
            &["06", "--picture", "06-reflection--bouncing"],
            "--picture is for a PNG",
        ),
        (&["good.png", "--pictures"], "check mine.png"),
    ] {
        let output = check(folder.path(), arguments);
        let stderr = String::from_utf8(output.stderr).expect("UTF-8");
        assert_eq!(output.status.code(), Some(2), "{arguments:?}: {stderr}");
        assert!(
            stderr.starts_with("error: ") && stderr.contains(words),
            "{arguments:?}: {stderr}"
        );
        assert_eq!(stderr.lines().count(), 1, "{arguments:?}: {stderr}");
        assert!(output.stdout.is_empty(), "{arguments:?}");
    }
}

/// Clear glass without absorption lets light through its shadow: so does chapter 8's with one
/// mistake. Nobody can know which of the two pictures is meant, so both are named.
#[test]
fn what_may_be_another_picture_is_said() {
    let folder = folder();
    let fault = mutations::named("glass-no-shadow").expect("a row").faults[0];
    let mine = with_fault("08-fresnel--still-life", [100, 75], fault);
    write(&folder.path().join("mine.png"), &mine).expect("a PNG");
    let said = said(folder.path(), &["mine.png"], 1);
    let place = |words: &str| {
        said.find(words)
            .unwrap_or_else(|| panic!("no {words}: {said}"))
    };
    let first = place("glass has no shadow");
    let other = place("or, if it is meant to be 11-transparency--still-life--knob-0:");
    assert!(first < other && other < place("2. "), "{said}");
}

/// What cannot be printed is a failure, in one line.
#[cfg(target_os = "linux")]
#[test]
fn a_full_disk_is_a_failure() {
    let folder = folder();
    write(&folder.path().join("mine.png"), &image([64, 48])).expect("a PNG");
    for arguments in [
        &["mine.png", "--picture", "00-canvas--gradient"][..],
        &["--help"],
    ] {
        let full = fs::File::create("/dev/full").expect("the full device");
        let mut command = Command::new(env!("CARGO_BIN_EXE_check"));
        command.args(arguments).current_dir(folder.path());
        let output = command.stdout(full).output().expect("the program runs");
        let stderr = String::from_utf8(output.stderr).expect("UTF-8");
        assert_eq!(output.status.code(), Some(1), "{arguments:?}: {stderr}");
        assert!(stderr.starts_with("error: cannot print: "), "{stderr}");
        assert_eq!(stderr.lines().count(), 1, "{stderr}");
    }
}

/// The checksum of a PNG's chunk.
fn png_crc(bytes: &[u8]) -> u32 {
    !bytes.iter().fold(u32::MAX, |crc, &byte| {
        (0..8).fold(crc ^ u32::from(byte), |crc, _| {
            (crc >> 1) ^ if crc & 1 == 1 { 0xedb8_8320 } else { 0 }
        })
    })
}

fn said(folder: &Path, arguments: &[&str], code: i32) -> String {
    let output = check(folder, arguments);
    let stdout = String::from_utf8(output.stdout).expect("UTF-8");
    let stderr = String::from_utf8(output.stderr).expect("UTF-8");
    assert_eq!(
        output.status.code(),
        Some(code),
        "{arguments:?}: {stdout}{stderr}"
    );
    assert!(
        stdout.lines().count() <= 24,
        "{arguments:?}: more than a screen\n{stdout}"
    );
    stdout
}

/// Writes a picture as a PNG of another kind.
fn write_as(path: &Path, image: &Image, colour: png::ColorType, depth: png::BitDepth) {
    let file = fs::File::create(path).expect("a file");
    let mut encoder = png::Encoder::new(file, image.size[0], image.size[1]);
    encoder.set_color(colour);
    encoder.set_depth(depth);
    let mut bytes = Vec::new();
    for pixel in &image.levels {
        let mut channels = pixel.to_vec();
        if colour == png::ColorType::Rgba {
            channels.push(255);
        }
        for level in channels {
            bytes.push(level);
            if depth == png::BitDepth::Sixteen {
                bytes.push(level);
            }
        }
    }
    let mut writer = encoder.write_header().expect("a header");
    writer.write_image_data(&bytes).expect("pixels");
}

/// Equal pictures are, whatever their colour depth; and it is said.
#[test]
fn equal_pictures_are_equal_in_every_kind_of_png() {
    let folder = folder();
    let picture = of_book("05-shading--combined");
    for (colour, depth, words) in [
        (
            png::ColorType::Rgb,
            png::BitDepth::Eight,
            "equal to the book's 05-shading--combined",
        ),
        (
            png::ColorType::Rgb,
            png::BitDepth::Sixteen,
            "16 bits a channel",
        ),
        (png::ColorType::Rgba, png::BitDepth::Eight, "alpha channel"),
    ] {
        write_as(&folder.path().join("mine.png"), &picture, colour, depth);
        let stdout = said(folder.path(), &["mine.png"], 0);
        assert!(
            stdout.contains(words) && stdout.contains("equal to"),
            "{stdout}"
        );
    }
}

/// Linear light and gamma 2.2 in place of sRGB, and another size, are recognised, without being told
/// which picture it is.
#[test]
fn encodings_and_sizes_are_recognised() {
    let folder = folder();
    for (fault, code, words) in [
        (
            Fault::Linear,
            1,
            "1. light was written into the file without encoding",
        ),
        (Fault::Gamma(2.2), 1, "1. light was encoded by a power"),
        (Fault::None, 0, "which is 800x600: drawn anew at your size"),
    ] {
        let mine = with_fault("08-fresnel--still-life", [240, 180], fault);
        write(&folder.path().join("mine.png"), &mine).expect("a PNG");
        let stdout = said(folder.path(), &["mine.png"], code);
        assert!(
            stdout.contains("08-fresnel--still-life") && stdout.contains(words),
            "{stdout}"
        );
    }
}

/// What the page shows is what the program says, of a picture with the highlights in the wrong
/// colour.
#[test]
fn the_page_shows_what_the_program_says() {
    let folder = folder();
    let mine = with_fault("07-refraction--ball", [320, 240], Fault::RatioSame);
    write(&folder.path().join("mine.png"), &mine).expect("a PNG");
    let stdout = said(
        folder.path(),
        &["mine.png", "--picture", "07-refraction--ball"],
        1,
    );
    let map = stdout
        .lines()
        .find_map(|line| line.trim().strip_prefix("heat map: "));
    let map = map
        .and_then(|line| line.split(" (").next())
        .expect("a heat map");
    assert_eq!(Path::new(map).extension(), Some(OsStr::new("png")));
    assert_eq!(fs::read(map).expect("the heat map")[..4], *b"\x89PNG");
    // Where the project is differs from computer to computer.
    let place = map.find("target").expect("it is in target");
    let stdout = stdout.replace(&map[..place], "");
    let mut numbers = Numbers::default();
    numbers.note(
        "example",
        format!("```console\n{}```", stdout.replace('\\', "/")),
    );
    numbers.check("am-i-right");
}

/// A chapter is drawn by its own program and compared, each of its pictures.
#[test]
fn a_chapter_is_compared() {
    let folder = folder();
    let pictures = book().expect("the book's pictures");
    let names = pictures.iter().map(|(name, _)| name);
    let count = names.filter(|name| name.starts_with("01-")).count();
    let stdout = said(folder.path(), &["01"], 0);
    assert_eq!(
        stdout,
        format!("01-ray-casting: {count} pictures are equal to the book's\n")
    );
}

/// Of a chapter that cannot be built the compiler's first error is shown, and its place, in one line.
#[cfg(unix)]
#[test]
fn a_chapter_that_cannot_be_built_is_reported_in_one_line() {
    use std::os::unix::fs::PermissionsExt;
    let folder = folder();
    // In place of cargo: what it says of such a chapter.
    let cargo = folder.path().join("cargo");
    let script = "#!/bin/sh\ncat >&2 <<'END'
warning: unused variable: `y`
 --> chapters/06-reflection/src/lib.rs:7:9

error[E0425]: cannot find value `x` in this scope
  --> chapters/06-reflection/src/lib.rs:31:5
   |
31 |     x
   |     ^ not found in this scope

error[E0308]: mismatched types
  --> chapters/06-reflection/src/lib.rs:40:5

error: could not compile `reflection` (lib) due to 2 previous errors; 1 warning emitted
END
exit 101
";
    fs::write(&cargo, script).expect("a script");
    fs::set_permissions(&cargo, fs::Permissions::from_mode(0o755)).expect("to run it");
    let mut command = Command::new(env!("CARGO_BIN_EXE_check"));
    command.arg("06").current_dir(folder.path());
    let output = command
        .env("CARGO", &cargo)
        .output()
        .expect("the program runs");
    let stderr = String::from_utf8(output.stderr).expect("UTF-8");
    assert_eq!(output.status.code(), Some(1), "{stderr}");
    assert_eq!(
        stderr,
        "error: 06-reflection cannot be built: cannot find value `x` in this scope, \
         chapters/06-reflection/src/lib.rs:31:5; for more, cargo build --bin 06-reflection\n"
    );
    assert!(output.stdout.is_empty());
}

/// Every page that a cause refers to exists, and has the heading.
#[test]
fn causes_refer_to_places_of_the_book() {
    let pages = check::figures::folder().join("..");
    let rows = check::mutations::MUTATIONS.iter().map(|row| row.page);
    for place in rows.chain(check::report::PLACES) {
        let (page, anchor) = place.split_once('#').unwrap_or((place, ""));
        let text = fs::read_to_string(pages.join(page)).expect(page);
        // As mdBook makes anchors of headings.
        let anchors = text.lines().filter_map(|line| {
            let heading = line.trim_start_matches('#');
            (heading.len() < line.len()).then(|| {
                let kept = heading.trim().to_lowercase();
                let kept = kept
                    .chars()
                    .filter(|c| c.is_alphanumeric() || " -_".contains(*c));
                kept.collect::<String>().replace(' ', "-")
            })
        });
        assert!(
            anchor.is_empty() || anchors.into_iter().any(|a| a == anchor),
            "{place}"
        );
    }
}

/// Names and causes are different, so that a report is about one thing.
#[test]
fn rows_are_different() {
    for (i, row) in check::mutations::MUTATIONS.iter().enumerate() {
        let mut others = check::mutations::MUTATIONS[..i].iter();
        assert!(
            !others.any(|other| other.name == row.name || other.cause == row.cause),
            "{}",
            row.name
        );
    }
}
