//! What the pages have the reader write around an exercise's function, in a project of their own.
// ANCHOR: main
use canvas::RgbImage;
use glam::{UVec2, Vec3};
use ray_casting::Camera;
use ray_casting::scene::still_life_camera;

fn camera_from_behind() -> Camera {
    // Yours to write.
    still_life_camera()
}

fn picture() -> RgbImage {
    let camera = camera_from_behind();
    canvas::render(UVec2::new(320, 240), |pixel| {
        (camera.ray(pixel.centre()).direction + Vec3::ONE) / 2.0
    })
}

fn main() -> preview::ImageResult<()> {
    preview::save_and_show(&picture(), "from-behind")
}

#[test]
fn is_the_solutions_picture() {
    let book = "../pictures/01-ray-casting--exercise-1.snap.png";
    assert_eq!(canvas::differing(&picture(), book).expect(book), 0);
}
// ANCHOR_END: main
