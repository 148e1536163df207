//! What the page has the reader write as a program of their own.
// ANCHOR: main
use canvas::RgbImage;
use glam::UVec2;
use reflection::{MAX_DEPTH, PathBudget};
use refraction::scene::{AIR, GLASS, close_up, still_life_with_glass};
use refraction::{refract_without_total_reflection, trace};

fn picture() -> RgbImage {
    let camera = close_up();
    let scene = still_life_with_glass(AIR, GLASS);
    let budget = PathBudget::new(MAX_DEPTH);
    canvas::render(UVec2::new(320, 240), |pixel| {
        let ray = camera.ray(pixel.centre());
        trace(&scene, &ray, budget, refract_without_total_reflection)
    })
}

fn main() -> preview::ImageResult<()> {
    preview::save_and_show(&picture(), "failed-total")
}

#[test]
fn is_the_books_picture() {
    let book = "../pictures/07-refraction--failed-total.snap.png";
    assert_eq!(canvas::differing(&picture(), book).expect("a picture"), 0);
}
// ANCHOR_END: main
