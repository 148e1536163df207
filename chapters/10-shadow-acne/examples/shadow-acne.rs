//! What the page has the reader write as a program of their own.
// ANCHOR: main
use canvas::RgbImage;
use glam::UVec2;
use ray_casting::scene::still_life_camera;
use reflection::{MAX_DEPTH, PathBudget};
use refraction::scene::{AIR, GLASS, still_life_with_glass};
use shadow_acne::{from_eye, from_surface, trace};

fn picture() -> RgbImage {
    let camera = still_life_camera();
    let scene = still_life_with_glass(GLASS, AIR);
    let budget = PathBudget::new(MAX_DEPTH);
    let start = from_eye(&scene.objects, camera.eye);
    canvas::render(UVec2::new(800, 600), |pixel| {
        let ray = start(camera.ray(pixel.centre()));
        trace(&scene, &ray, budget, from_surface)
    })
}

fn main() -> preview::ImageResult<()> {
    preview::save_and_show(&picture(), "shadow-acne")
}

#[test]
fn is_the_books_picture() {
    let book = "../pictures/10-shadow-acne--still-life.snap.png";
    assert_eq!(canvas::differing(&picture(), book).expect(book), 0);
}
// ANCHOR_END: main
