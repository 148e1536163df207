//! What the page has the reader write as a program of their own.
// ANCHOR: main
use image::{Rgb, RgbImage};

fn main() -> image::ImageResult<()> {
    let picture = RgbImage::from_fn(320, 240, |x, y| {
        let [x, y] = [x, y].map(|i| i as f32 + 0.5);
        Rgb([x / 320.0, 1.0 - y / 240.0, 0.25].map(|part| (255.0 * part).round() as u8))
    });
    picture.save("first.png")
}
// ANCHOR_END: main
