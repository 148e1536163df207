//! What the page has the reader write as a program of their own.
// ANCHOR: main
use canvas::RgbImage;
use glam::{UVec2, Vec3};
use plane_hit::{Plane, is_even_in_space};
use ray_casting::SKY;
use ray_casting::scene::still_life_camera;
use sphere_hit::T_MAX;

fn picture() -> RgbImage {
    let camera = still_life_camera();
    let floor = Plane::new(Vec3::NEG_Y, Vec3::Y).expect("a plane");
    canvas::render(UVec2::new(320, 240), |pixel| {
        let ray = camera.ray(pixel.centre());
        match floor.distance(&ray, T_MAX) {
            Some(t) if is_even_in_space(ray.at(t)) => Vec3::splat(0.1),
            Some(_) => Vec3::splat(0.9),
            None => SKY,
        }
    })
}

fn main() -> preview::ImageResult<()> {
    preview::save_and_show(&picture(), "checker-in-space")
}

#[test]
fn is_the_books_picture() {
    let book = "../pictures/03-plane-hit--checker-in-space.snap.png";
    assert_eq!(canvas::differing(&picture(), book).expect(book), 0);
}
// ANCHOR_END: main
