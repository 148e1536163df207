//! The chapter's exercises: functions for you to write.

// ANCHOR: uses
use crate::scene::{AIR, CLEAR, GLASS};
use crate::{Material, Optics, refract_or_reflect, trace};
use glam::Vec3;
use plane_hit::{Object, Shape};
use ray_casting::Ray;
use reflection::PathBudget;
use shadows::Scene;
// ANCHOR_END: uses

// ANCHOR: exercise-1
/// Returns the surface of a sea: the plane y = 1, with water of an index of 1.33 below it and
/// air above.
pub fn sea() -> Object<Material> {
    // Yours to write.
    let optics = Optics::Dielectric {
        eta_inside: AIR,
        eta_outside: AIR,
    };
    Object {
        name: "sea",
        shape: Shape::plane(Vec3::Y, Vec3::Y),
        material: Material {
            phong: CLEAR,
            optics,
        },
    }
}
// ANCHOR_END: exercise-1

// ANCHOR: exercise-2
/// Returns a bubble of air of some radius in the still life's ball of glass, with the same
/// centre as the ball: (0.9, 0.6, −1.2).
pub fn bubble_in_glass(radius: f32) -> Object<Material> {
    // Yours to write.
    let optics = Optics::Dielectric {
        eta_inside: GLASS,
        eta_outside: GLASS,
    };
    Object {
        name: "bubble",
        shape: Shape::sphere(Vec3::new(0.9, 0.6, -1.2), radius),
        material: Material {
            phong: CLEAR,
            optics,
        },
    }
}
// ANCHOR_END: exercise-2

// ANCHOR: exercise-4
/// Returns the light along a ray, as [`trace`] does with [`refract_or_reflect`], but red, green
/// and blue each from a scene of their own, in which the glass has another index.
pub fn trace_dispersed(
    scenes: &[Scene<Material>; 3],
    ray: &Ray,
    budget: PathBudget,
) -> Vec3 {
    // Yours to write.
    trace(&scenes[1], ray, budget, refract_or_reflect)
}
// ANCHOR_END: exercise-4
