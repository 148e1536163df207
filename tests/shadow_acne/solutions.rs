//! The exercises' solutions, as the book prints them.

use ::plane_hit::Shape;
use ::ray_casting::Ray;
use ::shadow_acne::{SurfaceRay, from_surface, untracked};
use ::shadows::Interaction;
use ::sphere_hit::{Sphere, face_forward};
use glam::Vec3;

// ANCHOR: exercise-1
pub fn with_offset_by(factor: f32, at: &Interaction, direction: Vec3) -> SurfaceRay {
    let point = from_surface(at, direction).ray.origin;
    let others = match at.shape {
        Shape::Sphere(Sphere { centre, radius }) => [centre.length(), radius],
        Shape::Plane(plane) => [plane.point.length(), 0.0],
    };
    let mut largest = point.length();
    for other in others {
        if other > largest {
            largest = other;
        }
    }
    let offset = factor * f32::EPSILON * largest;
    let normal = face_forward(at.outward, -direction);
    untracked(Ray {
        origin: point + offset * normal,
        direction,
    })
}
// ANCHOR_END: exercise-1

// ANCHOR: exercise-5
pub fn with_steps_of_floats(at: &Interaction, direction: Vec3) -> SurfaceRay {
    let normal = face_forward(at.outward, -direction);
    let mut origin = at.point;
    for axis in 0..3 {
        for _ in 0..32 {
            if normal[axis] > 0.0 {
                origin[axis] = origin[axis].next_up();
            } else if normal[axis] < 0.0 {
                origin[axis] = origin[axis].next_down();
            }
        }
    }
    untracked(Ray { origin, direction })
}
// ANCHOR_END: exercise-5
