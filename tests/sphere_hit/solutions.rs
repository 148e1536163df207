//! The exercises' solutions, as the book prints them.

use ::ray_casting::Ray;
use ::sphere_hit::{Sphere, T_MAX};
use glam::Vec3;

// ANCHOR: exercise-1
pub fn distance_of_any_direction(sphere: &Sphere, ray: &Ray, t_max: f32) -> Option<f32> {
    let oc = ray.origin - sphere.centre;
    let a = ray.direction.dot(ray.direction);
    let b = ray.direction.dot(oc);
    let discriminant = b * b - a * (oc.dot(oc) - sphere.radius * sphere.radius);
    if !(discriminant >= 0.0) {
        return None;
    }
    let root = discriminant.sqrt();
    let roots = [(-b - root) / a, (-b + root) / a];
    roots.into_iter().find(|&t| t > 0.0 && t < t_max)
}
// ANCHOR_END: exercise-1

// ANCHOR: exercise-2
pub fn far_distance(sphere: &Sphere, ray: &Ray) -> Option<f32> {
    let first = sphere.distance(ray, T_MAX)?;
    if !sphere.is_entered(ray, first) {
        return Some(first);
    }
    // Both hits are as far from the closest approach to the centre.
    let closest =
        -ray.direction.dot(ray.origin - sphere.centre) / ray.direction.dot(ray.direction);
    Some(closest + (closest - first))
}
// ANCHOR_END: exercise-2

// ANCHOR: exercise-4
pub fn ellipsoid_distance(
    centre: Vec3,
    semi_axes: Vec3,
    ray: &Ray,
    t_max: f32,
) -> Option<f32> {
    let unit_sphere = Sphere {
        centre: Vec3::ZERO,
        radius: 1.0,
    };
    let squeezed = Ray {
        origin: (ray.origin - centre) / semi_axes,
        direction: ray.direction / semi_axes,
    };
    unit_sphere.distance(&squeezed, t_max)
}
// ANCHOR_END: exercise-4
