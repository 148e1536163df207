//! What the page has the reader write as a program of their own.
// ANCHOR: main
use canvas::RgbImage;
use glam::{UVec2, Vec3};

/// The light of a screen's level 128: ((128/255 + 0.055) / 1.055)^2.4.
const LEVEL_128: f32 = 0.215_860_5;

fn picture() -> RgbImage {
    canvas::render(UVec2::new(320, 240), |pixel| {
        Vec3::splat(match 3 * pixel.x / pixel.size.x {
            0 => ((pixel.x + pixel.y) % 2) as f32,
            1 => 0.5,
            _ => LEVEL_128,
        })
    })
}

fn main() -> preview::ImageResult<()> {
    preview::save_and_show(&picture(), "half-light")
}
// ANCHOR_END: main

// ANCHOR: test
#[test]
fn is_the_books_picture() {
    let book = "../pictures/00-canvas--half-light.snap.png";
    assert_eq!(canvas::differing(&picture(), book).expect("a picture"), 0);
}
// ANCHOR_END: test
