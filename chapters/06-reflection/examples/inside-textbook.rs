//! What the page has the reader write as a program of their own.
// ANCHOR: main
use canvas::RgbImage;
use glam::{UVec2, Vec3};
use ray_casting::Camera;
use reflection::reflect_unnormalized;
use reflection::scene::colour_inside;

fn picture() -> RgbImage {
    let eye = Vec3::new(0.0, 0.0, -0.6);
    let camera = Camera::new(eye, Vec3::Z, Vec3::Y, 1.0).expect("a camera");
    canvas::render(UVec2::new(320, 240), |pixel| {
        colour_inside(camera.ray(pixel.centre()), 6, reflect_unnormalized)
    })
}

fn main() -> preview::ImageResult<()> {
    preview::save_and_show(&picture(), "inside-textbook")
}

#[test]
fn is_the_books_picture() {
    let book = "../pictures/06-reflection--inside-textbook.snap.png";
    assert_eq!(canvas::differing(&picture(), book).expect(book), 0);
}
// ANCHOR_END: main
