//! What the page has the reader write as a program of their own.
// ANCHOR: main
use canvas::RgbImage;
use glam::UVec2;
use plane_hit::scene::{STILL_LIFE_COLOURS, still_life};
use plane_hit::trace;
use ray_casting::scene::still_life_camera;

fn picture() -> RgbImage {
    let camera = still_life_camera();
    let objects = still_life(STILL_LIFE_COLOURS);
    canvas::render(UVec2::new(800, 600), |pixel| {
        trace(&objects, &camera.ray(pixel.centre()))
    })
}

fn main() -> preview::ImageResult<()> {
    preview::save_and_show(&picture(), "flat")
}

#[test]
fn is_the_books_picture() {
    let book = "../pictures/03-plane-hit--flat.snap.png";
    assert_eq!(canvas::differing(&picture(), book).expect(book), 0);
}
// ANCHOR_END: main
