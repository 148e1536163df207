//! What the page has the reader write as a program of their own.
// ANCHOR: main
use anti_aliasing::mean_of_levels;
use anti_aliasing::scene::horizon_radiance;
use canvas::RgbImage;
use glam::UVec2;

fn picture() -> RgbImage {
    let radiance = horizon_radiance();
    canvas::render(UVec2::new(320, 240), |pixel| {
        mean_of_levels(pixel, 8, &radiance)
    })
}

fn main() -> preview::ImageResult<()> {
    preview::save_and_show(&picture(), "levels")
}

#[test]
fn is_the_books_picture() {
    let book = "../pictures/09-anti-aliasing--levels.snap.png";
    assert_eq!(canvas::differing(&picture(), book).expect(book), 0);
}
// ANCHOR_END: main
