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
        match sphere.distance(&ray, T_MAX) {
            Some(t) => (sphere.normal(ray.at(t)) + Vec3::ONE) / 2.0,
            None => SKY,
        }
    })
}

fn main() -> preview::ImageResult<()> {
    preview::save_and_show(&picture(), "far-stable")
}

#[test]
fn is_the_books_picture() {
    let book = "../pictures/02-sphere-hit--far-stable.snap.png";
    assert_eq!(canvas::differing(&picture(), book).expect(book), 0);
}
// ANCHOR_END: main

// ANCHOR: f64
#[test]
fn f64_finds_the_same_hits() {
    let camera = camera_at(1000.0);
    let sphere = Sphere::new(Vec3::ZERO, 1.0).expect("a sphere");
    for x in 0..320 {
        let (y, size) = (120, UVec2::new(320, 240));
        let ray = camera.ray(canvas::Pixel { x, y, size }.centre());
        let exact = sphere.hit_in_f64(&ray, T_MAX).map(|hit| hit.t);
        let t = sphere.distance(&ray, T_MAX);
        assert!(t == exact || (t.unwrap() - exact.unwrap()).abs() < 0.001);
    }
}
// ANCHOR_END: f64
