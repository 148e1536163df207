// ANCHOR: scene
//! A sphere seen from afar.

use glam::Vec3;
use ray_casting::Camera;

/// Returns a camera that looks at a sphere of radius 1 around the origin. The camera is at some
/// `distance` from its surface, and has a focal length so long that the sphere fills most of
/// the picture.
pub fn camera_at(distance: f32) -> Camera {
    let to_centre = 1.0 + distance;
    // The rays that touch the sphere make an angle with sin = 1 / to_centre: its tangent, times
    // the focal length, is the radius on the image plane.
    let focal_length = 0.8 * (to_centre * to_centre - 1.0).sqrt();
    let eye = Vec3::new(0.0, 0.0, -to_centre);
    Camera::new(eye, Vec3::Z, Vec3::Y, focal_length).expect("a camera")
}
// ANCHOR_END: scene
