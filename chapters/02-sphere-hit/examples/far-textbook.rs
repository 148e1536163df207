//! What the page has the reader write as a program of their own.
// ANCHOR: main
use canvas::RgbImage;
use glam::{UVec2, Vec3};
use ray_casting::SKY;
use sphere_hit::scene::camera_at;
use sphere_hit::{Sphere, T_MAX};

fn picture() -> RgbImage {
    let camera = camera_at(1000.0);
    let sphere = Sphere::new(Vec3::ZERO, 1.0).expect("a sphere");
    canvas::render(UVec2::new(320, 240), |pixel| {
        let ray = camera.ray(pixel.centre());
        match sphere.distance_quadratic(&ray, T_MAX) {
            Some(t) => (sphere.normal(ray.at(t)) + Vec3::ONE) / 2.0,
            None => SKY,
        }
    })
}

fn main() -> preview::ImageResult<()> {
    preview::save_and_show(&picture(), "far-textbook")
}

#[test]
fn is_the_books_picture() {
    let book = "../pictures/02-sphere-hit--far-textbook.snap.png";
    assert_eq!(canvas::differing(&picture(), book).expect(book), 0);
}
// ANCHOR_END: main
