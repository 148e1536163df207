//! What the page has the reader write as a program of their own.
// ANCHOR: main
use canvas::RgbImage;
use glam::UVec2;
use shadows::scene::light_between_balls;
use shadows::{is_visible_buggy, trace};

fn picture() -> RgbImage {
    let (scene, camera) = light_between_balls();
    canvas::render(UVec2::new(320, 240), |pixel| {
        trace(&scene, &camera.ray(pixel.centre()), is_visible_buggy)
    })
}

fn main() -> preview::ImageResult<()> {
    preview::save_and_show(&picture(), "beyond-buggy")
}

#[test]
fn is_the_books_picture() {
    let book = "../pictures/04-shadows--beyond-buggy.snap.png";
    assert_eq!(canvas::differing(&picture(), book).expect(book), 0);
}
// ANCHOR_END: main
