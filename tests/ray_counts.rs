//! How many rays a picture takes: what it costs, on every machine and at any time of day.
//!
//! A slower way to the same picture hides in the noise of a clock; not in a count.

#[expect(dead_code, reason = "nothing here is a share of a whole")]
mod numbers_file;

use ::canvas::Canvas;
use glam::UVec2;
use light_backwards::STAGES;
use numbers_file::{Numbers, three_digits};

const SIZE: UVec2 = UVec2::new(160, 120);

/// Each chapter's first view, the still life where it draws it; but for chapters that cast no ray.
#[test]
fn every_chapter_casts_as_many_rays_as_the_book_says() {
    let mut rows = Vec::new();
    for stage in STAGES {
        let view = &stage.views[0];
        let canvas = Canvas::paint(&(view.picture)(view.default_setting()), SIZE);
        if canvas.rays > 0 {
            let per_pixel = canvas.rays as f64 / f64::from(SIZE.x * SIZE.y);
            rows.push(format!(
                "| {} | {} | {} |",
                stage.name,
                canvas.rays,
                three_digits(per_pixel)
            ));
        }
    }
    let mut numbers = Numbers::default();
    numbers.note("chapters", rows.join("\n"));
    // The same rays, one by one and sixteen at once.
    rows.retain(|row| {
        ["10", "12"]
            .iter()
            .any(|chapter| row.starts_with(&format!("| {chapter}")))
    });
    numbers.note("packets", rows.join("\n"));
    numbers.check("ray-counts");
}
