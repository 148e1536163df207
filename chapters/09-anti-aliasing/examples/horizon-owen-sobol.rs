//! What the page has the reader write as a program of their own.
// ANCHOR: main
use anti_aliasing::scene::horizon_radiance;
use anti_aliasing::sobol::low_discrepancy;
use canvas::RgbImage;
use glam::UVec2;

fn picture() -> RgbImage {
    let radiance = horizon_radiance();
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
