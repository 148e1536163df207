//! What the page has the reader write as a program of their own.
// ANCHOR: main
use canvas::RgbImage;
use glam::UVec2;
use reflection::{MAX_DEPTH, PathBudget};
use shadow_acne::scene::balls_on_a_planet;
use shadow_acne::{from_eye, trace, without_offset};

fn picture() -> RgbImage {
    let (scene, camera) = balls_on_a_planet(1.0);
    let budget = PathBudget::new(MAX_DEPTH);
    canvas::render(UVec2::new(320, 240), |pixel| {
        let ray = from_eye(&scene.objects, camera.ray(pixel.centre()));
        trace(&scene, &ray, budget, without_offset)
    })
}

fn main() -> preview::ImageResult<()> {
    preview::save_and_show(&picture(), "acne")
}

#[test]
fn is_the_books_picture() {
    let book = "../pictures/10-shadow-acne--acne.snap.png";
    assert_eq!(canvas::differing(&picture(), book).expect("a picture"), 0);
}
// ANCHOR_END: main
