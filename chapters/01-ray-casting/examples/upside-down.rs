//! What the page has the reader write as a program of their own.
// ANCHOR: main
use canvas::RgbImage;
use glam::{UVec2, Vec2};
use ray_casting::scene::still_life_camera;
use ray_casting::trace;

fn picture() -> RgbImage {
    let camera = still_life_camera();
    canvas::render(UVec2::new(320, 240), |pixel| {
        let Vec2 { x, y } = pixel.centre();
        trace(&camera.ray(Vec2::new(x, -y)))
    })
}

fn main() -> preview::ImageResult<()> {
    let picture = picture();
    println!("{} rays", canvas::rays_traced());
    preview::save_and_show(&picture, "upside-down")
}

#[test]
fn is_the_books_picture() {
    let book = "../pictures/01-ray-casting--upside-down.snap.png";
    assert_eq!(canvas::differing(&picture(), book).expect(book), 0);
}
// ANCHOR_END: main
