//! The exercises' solutions, as the book prints them.

use ::ray_casting::scene::{STILL_LIFE_FOCAL_LENGTH, still_life_camera};
use ::ray_casting::{Camera, Ray, SKY};
use glam::{Vec2, Vec3};

// ANCHOR: exercise-1
pub fn camera_from_behind() -> Camera {
    let eye = Vec3::new(0.0, 2.0, 7.0);
    let forward = Vec3::new(0.0, -1.1, -7.0);
    let camera = Camera::new(eye, forward, Vec3::Y, STILL_LIFE_FOCAL_LENGTH);
    camera.expect("it looks back, not up")
}
// ANCHOR_END: exercise-1

// ANCHOR: exercise-2
pub fn sky(direction: Vec3) -> Vec3 {
    Vec3::ONE.lerp(SKY, direction.y)
}
// ANCHOR_END: exercise-2

// ANCHOR: exercise-3
pub fn rolled_camera() -> Camera {
    let level = still_life_camera();
    let up = Vec3::new(0.5, 1.0, 0.0);
    let camera = Camera::new(level.eye, level.forward, up, level.focal_length);
    camera.expect("it looks ahead, not up")
}
// ANCHOR_END: exercise-3

// ANCHOR: exercise-4
pub fn parallel_ray(camera: &Camera, point: Vec2) -> Ray {
    Ray {
        origin: camera.eye + point.x * camera.right + point.y * camera.up,
        direction: camera.forward,
    }
}
// ANCHOR_END: exercise-4
