//! What the page has the reader write as a program of their own.
// ANCHOR: main
use canvas::RgbImage;
use glam::UVec2;
use ray_casting::scene::still_life_camera;
use reflection::scene::still_life_mirrors;
use reflection::{MAX_DEPTH, PathBudget, trace};
use shadows::scene::lit_still_life;

fn picture() -> RgbImage {
    let camera = still_life_camera();
    let scene = lit_still_life(still_life_mirrors());
    let budget = PathBudget::new(MAX_DEPTH);
    canvas::render(UVec2::new(800, 600), |pixel| {
        trace(&scene, &camera.ray(pixel.centre()), budget)
    })
}

fn main() -> preview::ImageResult<()> {
    preview::save_and_show(&picture(), "reflection")
}

#[test]
fn is_the_books_picture() {
    let book = "../pictures/06-reflection--bouncing.snap.png";
    assert_eq!(canvas::differing(&picture(), book).expect(book), 0);
}
// ANCHOR_END: main
