//! What the page has the reader write as a program of their own.
// ANCHOR: main
use canvas::RgbImage;
use glam::UVec2;
use reflection::scene::facing_mirrors;
use reflection::{MAX_DEPTH, PathBudget, trace};

fn picture() -> RgbImage {
    let (scene, camera) = facing_mirrors(0.9);
    let budget = PathBudget::new(MAX_DEPTH);
    canvas::render(UVec2::new(320, 240), |pixel| {
        trace(&scene, &camera.ray(pixel.centre()), budget)
    })
}

fn main() -> preview::ImageResult<()> {
    preview::save_and_show(&picture(), "facing-mirrors")
}

#[test]
fn is_the_books_picture() {
    let book = "../pictures/06-reflection--facing-mirrors.snap.png";
    assert_eq!(canvas::differing(&picture(), book).expect(book), 0);
}
// ANCHOR_END: main
