//! Every picture of every chapter, compared for equality with the one in the book.

use ::canvas::{Canvas, Picture, Stage, View};
use glam::UVec2;
use image::{ImageFormat, Rgb, RgbImage};
use insta::Comparator;
use insta::internals::SnapshotContents;
use insta::{Snapshot, assert_binary_snapshot};
use std::fmt::Write;
use std::fs;
use std::io::Cursor;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::{Path, PathBuf};
use std::sync::Mutex;

macro_rules! chapters {
    ($($chapter:ident)*) => {
        $(mod $chapter {
            #[test]
            fn every_picture_is_the_one_in_the_book() {
                super::check_pictures(&::$chapter::STAGE);
            }

            #[test]
            fn the_bits_are_the_same_on_1_2_and_7_threads() {
                super::check_threads(&::$chapter::STAGE);
            }
        })*

        #[test]
        fn no_chapter_is_left_out() {
            let tested = [$(::$chapter::STAGE.name),*];
            assert_eq!(tested, light_backwards::STAGES.map(|stage| stage.name));
        }
    };
}

chapters!(
    canvas ray_casting sphere_hit plane_hit shadows shading reflection refraction fresnel
    anti_aliasing shadow_acne transparency packets speed_and_accuracy interactive
);

fn check_pictures(stage: &Stage) {
    let mut complaints = String::new();
    for (index, view) in stage.views.iter().enumerate() {
        if is_chart(stage, view) {
            continue;
        }
        let pinned = view.knob.as_ref().map_or(&[][..], |knob| knob.pinned);
        for &setting in [view.default_setting()].iter().chain(pinned) {
            // The chapter's hero is large, all others small.
            let is_hero = index == 0 && setting == view.default_setting();
            let (width, height) = if is_hero { (800, 600) } else { (320, 240) };
            let canvas =
                Canvas::paint(&(view.picture)(setting), UVec2::new(width, height));
            let name = stage.picture_name(view, setting);
            if let Err(complaint) = check_picture(&name, &canvas) {
                writeln!(complaints, "\n{name}: {complaint}")
                    .expect("a String takes everything");
            }
        }
    }
    assert!(
        complaints.is_empty(),
        "{complaints}
If that is what you wanted, accept it: INSTA_UPDATE=always cargo test --test snapshots
(or `cargo insta review`, if you have cargo-insta), and look at the changed files in book/src/pictures.\n"
    );
}

/// Whether a view shows a study's chart: its times change with every measurement, so the
/// tests of the studies compare it with its table.
fn is_chart(stage: &Stage, view: &View) -> bool {
    let charts = ::speed_and_accuracy::STAGE.name;
    let studies = ::speed_and_accuracy::STUDIES;
    stage.name == charts && studies.iter().any(|study| study.name == view.name)
}

/// Compares a picture with the one in the book; the error says how they differ.
fn check_picture(name: &str, canvas: &Canvas) -> Result<(), String> {
    let comparator = ByPixels::default();
    let mut settings = insta::Settings::new();
    settings.set_snapshot_path("../book/src/pictures");
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
            .expect("nobody panics with the lock")
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
            *self.0.lock().expect("nobody panics with the lock") = Some((book, yours));
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

/// How many pixels differ, and the worst of them, in words.
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

/// Writes expected, yours and the difference side by side, and returns where.
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
    let target = Path::new(env!("CARGO_TARGET_TMPDIR")).parent();
    let folder = target.expect("a folder in target").join("image-diffs");
    let path = folder.join(format!("{name}.png"));
    let saved = fs::create_dir_all(&folder).is_ok() && sheet.save(&path).is_ok();
    assert!(saved, "cannot write {}", path.display());
    path
}

fn check_threads(stage: &Stage) {
    let View { knob, picture, .. } = &stage.views[0];
    let setting = knob.as_ref().map_or(0.0, |knob| knob.default);
    let [one, two, seven] = [1, 2, 7].map(|threads| paint_on(threads, &picture(setting)));
    assert_eq!(one, two);
    assert_eq!(one, seven);
}

/// The bits of a picture painted on so many threads, and its rays.
fn paint_on(threads: usize, picture: &Picture) -> (Vec<[u32; 3]>, u64) {
    let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build();
    let pool = pool.expect("a few threads");
    let canvas = pool.install(|| Canvas::paint(picture, UVec2::new(160, 120)));
    let bits = |light: &glam::Vec3| light.to_array().map(f32::to_bits);
    (canvas.light.iter().map(bits).collect(), canvas.rays)
}
