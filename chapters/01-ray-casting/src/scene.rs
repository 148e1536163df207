// ANCHOR: camera
//! The still life's camera.

use crate::Camera;
use glam::Vec3;

/// 1 / tan(45°/2) = 1 + √2: a vertical field of view of 45°.
pub const STILL_LIFE_FOCAL_LENGTH: f32 = 1.0 + std::f32::consts::SQRT_2;

/// Returns the still life's camera.
pub fn still_life_camera() -> Camera {
    let eye = Vec3::new(0.0, 2.0, -7.0);
    let forward = Vec3::new(0.0, -1.1, 7.0);
    let camera = Camera::new(eye, forward, Vec3::Y, STILL_LIFE_FOCAL_LENGTH);
    camera.expect("it looks ahead, not up")
}
// ANCHOR_END: camera
