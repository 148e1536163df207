//! The chapter's exercises: functions for you to write.

// ANCHOR: uses
use crate::scene::still_life_camera;
use crate::{Camera, Ray, SKY};
use glam::{Vec2, Vec3};
// ANCHOR_END: uses

// ANCHOR: exercise-1
/// Returns a camera on the other side of the still life, at (0, 2, 7): it looks back, as far
/// down as the still life's camera does, and has its focal length.
pub fn camera_from_behind() -> Camera {
    // Yours to write.
    still_life_camera()
}
// ANCHOR_END: exercise-1

// ANCHOR: exercise-2
/// Returns the sky's radiance in a unit direction that rises: white at the horizon, [`SKY`] at
/// the zenith, and the deeper the higher the direction points.
pub fn sky(_direction: Vec3) -> Vec3 {
    // Yours to write.
    SKY
}
// ANCHOR_END: exercise-2

// ANCHOR: exercise-3
/// Returns the still life's camera with a roll: what points along (½, 1, 0) is upright in the
/// picture.
pub fn rolled_camera() -> Camera {
    // Yours to write.
    still_life_camera()
}
// ANCHOR_END: exercise-3

// ANCHOR: exercise-4
/// Returns the ray through a `point` of the camera's image plane that goes straight ahead. It
/// starts in the plane through the eye that is parallel to the image plane.
pub fn parallel_ray(camera: &Camera, point: Vec2) -> Ray {
    // Yours to write.
    camera.ray(point)
}
// ANCHOR_END: exercise-4
