//! What the page has the reader write as a program of their own.
// ANCHOR: main
use canvas::RgbImage;
use glam::{UVec2, Vec3};
use ray_casting::scene::still_life_camera;
use sphere_hit::{Sphere, T_MAX};

fn picture() -> RgbImage {
    let camera = still_life_camera();
    let sphere = Sphere::new(Vec3::new(-2.2, 0.8, 1.0), 0.8).expect("a sphere");
    canvas::render(UVec2::new(800, 600), |pixel| {
        let ray = camera.ray(pixel.centre());
        match sphere.distance_quadratic(&ray, T_MAX) {
            Some(_) => Vec3::new(0.9, 0.15, 0.1),
            None => ray_casting::trace(&ray),
        }
    })
}

fn main() -> preview::ImageResult<()> {
    preview::save_and_show(&picture(), "sphere")
}

#[test]
fn is_the_books_picture() {
    let book = "../pictures/02-sphere-hit--flat.snap.png";
    assert_eq!(canvas::differing(&picture(), book).expect(book), 0);
}
// ANCHOR_END: main
