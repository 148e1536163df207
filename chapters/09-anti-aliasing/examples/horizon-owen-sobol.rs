//! What the page has the reader write as a program of their own.
// ANCHOR: main
use anti_aliasing::scene::horizon_camera;
use anti_aliasing::sobol::low_discrepancy;
use canvas::RgbImage;
use glam::{UVec2, Vec2};
use plane_hit::scene::{STILL_LIFE_COLOURS, still_life};
use plane_hit::trace;

fn picture() -> RgbImage {
    let camera = horizon_camera();
    let mut floor = still_life(STILL_LIFE_COLOURS);
    floor.truncate(1);
    let radiance = |point: Vec2| trace(&floor, &camera.ray(point));
    canvas::render(UVec2::new(320, 240), |pixel| {
        low_discrepancy(pixel, 4, &radiance)
    })
}

fn main() -> preview::ImageResult<()> {
    preview::save_and_show(&picture(), "horizon-owen-sobol")
}

#[test]
fn is_the_books_picture() {
    let book = "../pictures/09-anti-aliasing--horizon-owen-sobol.snap.png";
    assert_eq!(canvas::differing(&picture(), book).expect(book), 0);
}
// ANCHOR_END: main
