//! What the page has the reader write as a program of their own.
// ANCHOR: main
use canvas::RgbImage;
use glam::UVec2;
use plane_hit::scene::STILL_LIFE_COLOURS;
use ray_casting::scene::still_life_camera;
use shadows::scene::lit_still_life;
use shadows::{is_visible, trace};

fn picture() -> RgbImage {
    let camera = still_life_camera();
    let scene = lit_still_life(STILL_LIFE_COLOURS);
    canvas::render(UVec2::new(800, 600), |pixel| {
        trace(&scene, &camera.ray(pixel.centre()), is_visible)
    })
}

fn main() -> preview::ImageResult<()> {
    preview::save_and_show(&picture(), "shadows")
}

#[test]
fn is_the_books_picture() {
    let book = "../pictures/04-shadows--hard.snap.png";
    assert_eq!(canvas::differing(&picture(), book).expect(book), 0);
}
// ANCHOR_END: main
