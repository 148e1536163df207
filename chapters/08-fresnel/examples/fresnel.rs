//! What the page has the reader write as a program of their own.
// ANCHOR: main
use canvas::RgbImage;
use fresnel::{fresnel, trace};
use glam::UVec2;
use ray_casting::scene::still_life_camera;
use reflection::{MAX_DEPTH, PathBudget};
use refraction::scene::{AIR, GLASS, still_life_with_glass};

fn picture() -> RgbImage {
    let camera = still_life_camera();
    let scene = still_life_with_glass(GLASS, AIR);
    let budget = PathBudget::new(MAX_DEPTH);
    canvas::render(UVec2::new(800, 600), |pixel| {
        trace(&scene, &camera.ray(pixel.centre()), budget, fresnel)
    })
}

fn main() -> preview::ImageResult<()> {
    preview::save_and_show(&picture(), "fresnel")
}

#[test]
fn is_the_books_picture() {
    let book = "../pictures/08-fresnel--still-life.snap.png";
    assert_eq!(canvas::differing(&picture(), book).expect(book), 0);
}
// ANCHOR_END: main
