// ANCHOR: scene
//! The floor and its horizon, where a picture is hardest to sample.

use glam::Vec3;
use ray_casting::Camera;

/// Returns a camera that looks at the far floor.
pub fn horizon_camera() -> Camera {
    let eye = Vec3::new(0.0, 2.0, -7.0);
    let camera = Camera::new(eye, Vec3::new(0.0, -0.6, 7.0), Vec3::Y, 5.0);
    camera.expect("it looks ahead, not up")
}
// ANCHOR_END: scene
