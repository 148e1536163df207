//! What the page has the reader write as a program of their own.
// ANCHOR: main
use canvas::RgbImage;
use glam::{UVec2, Vec3};

fn picture() -> RgbImage {
    canvas::render(UVec2::new(800, 600), |pixel| {
        let [x, y] = [pixel.x, pixel.y].map(|i| i as f32 + 0.5);
        Vec3::new(x / 800.0, 1.0 - y / 600.0, 0.25)
    })
}

fn main() -> preview::ImageResult<()> {
    preview::save_and_show(&picture(), "gradient")
}
// ANCHOR_END: main

// ANCHOR: test
#[test]
fn is_the_books_picture() {
    let book = "../pictures/00-canvas--gradient.snap.png";
    assert_eq!(canvas::differing(&picture(), book).expect(book), 0);
}
// ANCHOR_END: test
