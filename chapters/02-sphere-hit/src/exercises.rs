//! The chapter's exercises: functions for you to write.

// ANCHOR: uses
use crate::{Sphere, T_MAX};
use glam::Vec3;
use ray_casting::Ray;
// ANCHOR_END: uses

// ANCHOR: exercise-1
/// Returns the distance to the first hit with 0 < t < `t_max`, as
/// [`Sphere::distance_quadratic`] does, but for a direction of any length: in units of that
/// length.
pub fn distance_of_any_direction(sphere: &Sphere, ray: &Ray, t_max: f32) -> Option<f32> {
    // Yours to write.
    sphere.distance_quadratic(ray, t_max)
}
// ANCHOR_END: exercise-1

// ANCHOR: exercise-2
/// Returns the distance at which the ray leaves the sphere: that of the hit on its far wall.
/// `None` if the ray is never in the sphere.
pub fn far_distance(sphere: &Sphere, ray: &Ray) -> Option<f32> {
    // Yours to write.
    sphere.distance(ray, T_MAX)
}
// ANCHOR_END: exercise-2

// ANCHOR: exercise-4
/// Returns the distance to the first hit with 0 < t < `t_max` on an ellipsoid: the points at
/// which (x/a)² + (y/b)² + (z/c)² = 1, where x, y and z are measured from its `centre`, and a, b
/// and c are its `semi_axes`.
pub fn ellipsoid_distance(
    centre: Vec3,
    semi_axes: Vec3,
    ray: &Ray,
    t_max: f32,
) -> Option<f32> {
    // Yours to write.
    let radius = semi_axes.y;
    Sphere { centre, radius }.distance(ray, t_max)
}
// ANCHOR_END: exercise-4
