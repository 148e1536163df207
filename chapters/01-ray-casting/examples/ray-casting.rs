//! What the page has the reader write as a program of their own.
// ANCHOR: main
use canvas::RgbImage;
use glam::{UVec2, Vec3};
use ray_casting::scene::still_life_camera;

fn picture() -> RgbImage {
    let camera = still_life_camera();
    canvas::render(UVec2::new(800, 600), |pixel| {
        let ray = camera.ray(pixel.centre());
        (ray.direction + Vec3::ONE) / 2.0
    })
}

fn main() -> preview::ImageResult<()> {
    preview::save_and_show(&picture(), "directions")
}

#[test]
fn is_the_books_picture() {
    let book = "../pictures/01-ray-casting--directions.snap.png";
    assert_eq!(canvas::differing(&picture(), book).expect(book), 0);
}
// ANCHOR_END: main
