//! What the page has the reader write as a program of their own.
// ANCHOR: main
use canvas::RgbImage;
use glam::UVec2;
use ray_casting::scene::still_life_camera;
use shading::scene::still_life_surfaces;
use shading::trace;
use shadows::scene::lit_still_life;

fn picture() -> RgbImage {
    let camera = still_life_camera();
    let mut surfaces = still_life_surfaces();
    for ball in &mut surfaces[1..] {
        ball.specular = 5.0;
    }
    let scene = lit_still_life(surfaces);
    canvas::render(UVec2::new(320, 240), |pixel| {
        trace(&scene, &camera.ray(pixel.centre()))
    })
}

fn main() -> preview::ImageResult<()> {
    preview::save_and_show(&picture(), "too-much-light")
}

#[test]
fn is_the_books_picture() {
    let book = "../pictures/05-shading--too-much-light.snap.png";
    assert_eq!(canvas::differing(&picture(), book).expect(book), 0);
}
// ANCHOR_END: main
