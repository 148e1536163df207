//! What the page has the reader write as a program of their own.
// ANCHOR: main
use anti_aliasing::clamped;
use canvas::RgbImage;
use glam::{UVec2, Vec2, Vec3};
use ray_casting::SKY;

fn picture() -> RgbImage {
    let radiance = |point: Vec2| {
        if point.length() < 0.5 {
            Vec3::splat(100.0)
        } else {
            0.1 * SKY
        }
    };
    canvas::render(UVec2::new(320, 240), |pixel| clamped(pixel, 8, &radiance))
}

fn main() -> preview::ImageResult<()> {
    preview::save_and_show(&picture(), "lamp-clamped")
}

#[test]
fn is_the_books_picture() {
    let book = "../pictures/09-anti-aliasing--lamp-clamped.snap.png";
    assert_eq!(canvas::differing(&picture(), book).expect(book), 0);
}
// ANCHOR_END: main
