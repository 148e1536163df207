// ANCHOR: scene
//! The floor and its horizon, where a picture is hardest to sample.

use glam::{Vec2, Vec3};
use plane_hit::scene::{STILL_LIFE_COLOURS, still_life};
use plane_hit::trace;
use ray_casting::Camera;

/// Returns a camera that looks at the far floor.
pub fn horizon_camera() -> Camera {
    let eye = Vec3::new(0.0, 2.0, -7.0);
    let camera = Camera::new(eye, Vec3::new(0.0, -0.6, 7.0), Vec3::Y, 5.0);
    camera.expect("it looks ahead, not up")
}

/// Returns the radiance of the floor alone, in flat colours, as a function of the point of the
/// horizon camera's image plane.
pub fn horizon_radiance() -> impl Fn(Vec2) -> Vec3 + Send + Sync {
    let camera = horizon_camera();
    let mut floor = still_life(STILL_LIFE_COLOURS);
    floor.truncate(1);
    move |point| trace(&floor, &camera.ray(point))
}
// ANCHOR_END: scene
