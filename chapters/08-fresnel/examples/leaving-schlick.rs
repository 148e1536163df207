//! What the page has the reader write as a program of their own.
// ANCHOR: main
use canvas::RgbImage;
use fresnel::scene::reflectance_along;
use fresnel::schlick;
use glam::UVec2;
use refraction::scene::{AIR, GLASS, close_up, still_life_with_glass};

fn picture() -> RgbImage {
    let camera = close_up();
    let objects = still_life_with_glass(AIR, GLASS).objects;
    canvas::render(UVec2::new(320, 240), |pixel| {
        reflectance_along(&camera.ray(pixel.centre()), &objects, schlick)
    })
}

fn main() -> preview::ImageResult<()> {
    preview::save_and_show(&picture(), "leaving-schlick")
}

#[test]
fn is_the_books_picture() {
    let book = "../pictures/08-fresnel--leaving-schlick.snap.png";
    assert_eq!(canvas::differing(&picture(), book).expect(book), 0);
}
// ANCHOR_END: main
