//! Every picture of every chapter, compared for equality with the one in the book.

use crate::{HERO, SMALL};
use canvas::{Canvas, Stage};
use image::{ImageFormat, Rgb, RgbImage};
use insta::internals::SnapshotContents;
use insta::{Comparator, Snapshot, assert_binary_snapshot};
use std::fmt::Write;
use std::fs;
use std::io::Cursor;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::{Path, PathBuf};
use std::sync::Mutex;

/// Compares every picture of a chapter with the one in the book: of each view, at its default
/// setting and at its knob's `snapshot_settings`.
///
/// # Panics
/// If any differs; the message names all that do.
pub fn check_pictures(stage: &Stage) {
    let mut complaints = String::new();
    for view in stage.views {
        let others = view
            .knob
            .as_ref()
            .map_or(&[][..], |knob| knob.snapshot_settings);
        for &setting in [view.default_setting()].iter().chain(others) {
            let is_hero = view.name == stage.hero && setting == view.default_setting();
            let size = if is_hero { HERO } else { SMALL };
            let canvas = Canvas::render(&(view.picture)(setting), size);
            let name = stage.picture_name(view, setting);
            if let Err(complaint) = check_picture_in("", &name, &canvas) {
                writeln!(complaints, "\n{name}: {complaint}")
                    .expect("a String takes everything");
            }
        }
    }
    assert!(
        complaints.is_empty(),
        "{complaints}{}",
        advice("book/src/pictures")
    );
}

/// Returns what to do if a difference is wanted: a command that accepts it, of this very test.
pub(crate) fn advice(folder: &str) -> String {
    // This program is target/debug/deps/NAME-HASH.
    let program = std::env::current_exe().unwrap_or_default();
    let program = program.file_stem().unwrap_or_default().to_string_lossy();
    let (test, _) = program.rsplit_once('-').unwrap_or((&program, ""));
    format!(
        "
If that is what you wanted, accept it: INSTA_UPDATE=always cargo test --test {test}
and look at the changed files in {folder}.\n"
    )
}

/// Compares a picture with the one in a folder of the book's pictures, or in "" for that
/// folder itself; the error says how they differ.
pub(crate) fn check_picture_in(
    folder: &str,
    name: &str,
    canvas: &Canvas,
) -> Result<(), String> {
    let comparator = ByPixels::default();
    let mut settings = insta::Settings::new();
    let pictures = concat!(env!("CARGO_MANIFEST_DIR"), "/../../book/src/pictures");
    settings.set_snapshot_path(Path::new(pictures).join(folder));
    settings.set_prepend_module_to_snapshot(false);
    settings.set_omit_expression(true);
    settings.set_comparator(comparator.dyn_clone());
    let file = format!("{name}.png");
    let matched = catch_unwind(AssertUnwindSafe(|| {
        settings.bind(|| assert_binary_snapshot!(&file, png(&image_of(canvas))));
    }));
    matched.map_err(|_| {
        let seen = comparator
            .0
            .lock()
            .expect("no thread panics while it holds the lock")
            .take();
        let Some((book, yours)) = seen else {
            return "the book has no such picture yet".to_string();
        };
        if book.dimensions() != yours.dimensions() {
            return format!(
                "the book's picture is {:?} pixels large, yours is {:?}",
                book.dimensions(),
                yours.dimensions()
            );
        }
        let path = save_difference(name, &book, &yours);
        format!("{}\n  {}", difference(&book, &yours), path.display())
    })
}

/// Two pictures match if all their pixels do, however they were compressed.
///
/// Keeps the two that did not match: the one in the book, and the new one.
#[derive(Clone, Default)]
struct ByPixels(std::sync::Arc<Mutex<Option<(RgbImage, RgbImage)>>>);

impl Comparator for ByPixels {
    fn matches(&self, reference: &Snapshot, test: &Snapshot) -> bool {
        let (Some(book), Some(yours)) = (decode(reference), decode(test)) else {
            return false;
        };
        let same = book == yours;
        if !same {
            *self
                .0
                .lock()
                .expect("no thread panics while it holds the lock") = Some((book, yours));
        }
        same
    }

    fn dyn_clone(&self) -> Box<dyn Comparator> {
        Box::new(self.clone())
    }
}

fn decode(snapshot: &Snapshot) -> Option<RgbImage> {
    match snapshot.contents() {
        SnapshotContents::Binary(Some(png)) => {
            let image =
                image::load_from_memory_with_format(png, ImageFormat::Png).ok()?;
            Some(image.into_rgb8())
        }
        _ => None,
    }
}

fn image_of(canvas: &Canvas) -> RgbImage {
    let bytes = canvas.levels.as_flattened().to_vec();
    RgbImage::from_raw(canvas.size.x, canvas.size.y, bytes).expect("three levels a pixel")
}

fn png(image: &RgbImage) -> Vec<u8> {
    let mut bytes = Cursor::new(Vec::new());
    let written = image.write_to(&mut bytes, ImageFormat::Png);
    written.expect("memory takes everything");
    bytes.into_inner()
}

fn distance(a: &Rgb<u8>, b: &Rgb<u8>) -> u8 {
    let channels = a.0.into_iter().zip(b.0);
    channels.map(|(a, b)| a.abs_diff(b)).fold(0, Ord::max)
}

/// Returns the number of pixels that differ, and the worst of them, in words.
fn difference(book: &RgbImage, yours: &RgbImage) -> String {
    let differing = book
        .enumerate_pixels()
        .zip(yours.pixels())
        .filter(|((_, _, book), yours)| book != yours);
    let ((x, y, worst), its_other) = differing
        .clone()
        .max_by_key(|((_, _, book), yours)| distance(book, yours))
        .expect("two pictures that differ have a pixel that does");
    format!(
        "{} of {} pixels differ; the worst, at x = {x}, y = {y}, is {:?} in the book and {:?} in yours
  expected | yours | difference:",
        differing.count(),
        book.pixels().len(),
        worst.0,
        its_other.0,
    )
}

/// Saves expected, yours and the difference side by side, and returns the path.
fn save_difference(name: &str, book: &RgbImage, yours: &RgbImage) -> PathBuf {
    let (width, height) = book.dimensions();
    let sheet = RgbImage::from_fn(3 * width, height, |x, y| {
        let (expected, actual) =
            (book.get_pixel(x % width, y), yours.get_pixel(x % width, y));
        match x / width {
            0 => *expected,
            1 => *actual,
            // Even a difference of one level must be seen.
            _ => match distance(expected, actual) {
                0 => Rgb([0; 3]),
                distance => Rgb([128 + distance / 2; 3]),
            },
        }
    });
    // This program is target/debug/deps/NAME.
    let program = std::env::current_exe().unwrap_or_default();
    let target = program.ancestors().nth(3).unwrap_or(Path::new("target"));
    let folder = target.join("image-diffs");
    let path = folder.join(format!("{name}.png"));
    let saved = fs::create_dir_all(&folder).is_ok() && sheet.save(&path).is_ok();
    assert!(saved, "cannot write {}", path.display());
    path
}
