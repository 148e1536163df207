//! What the page has the reader write as a program of their own.
// ANCHOR: main
use image::{Rgb, RgbImage};

fn main() -> image::ImageResult<()> {
    let picture = RgbImage::from_fn(256, 192, |x, y| Rgb([x as u8, 255 - y as u8, 64]));
    picture.save("first.png")
}
// ANCHOR_END: main
