//! What the page has the reader write as a program of their own.
// ANCHOR: main
use canvas::RgbImage;
use glam::UVec2;
use reflection::{MAX_DEPTH, PathBudget};
use shadow_acne::from_eye;
use transparency::scene::pool;
use transparency::{as_if_alone, trace};

fn picture() -> RgbImage {
    let (scene, camera) = pool();
    let budget = PathBudget::new(MAX_DEPTH);
    let start = from_eye(&scene.objects, camera.eye);
    canvas::render(UVec2::new(320, 240), |pixel| {
        let ray = start(camera.ray(pixel.centre()));
        trace(&scene, &ray, budget, as_if_alone)
    })
}

fn main() -> preview::ImageResult<()> {
    preview::save_and_show(&picture(), "alone")
}

#[test]
fn is_the_books_picture() {
    let book = "../pictures/11-transparency--alone.snap.png";
    assert_eq!(canvas::differing(&picture(), book).expect(book), 0);
}
// ANCHOR_END: main
