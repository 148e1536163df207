//! The exercises' solutions, as the book prints them.

use ::plane_hit::{Object, Shape};
use ::ray_casting::Ray;
use ::reflection::PathBudget;
use ::refraction::scene::{AIR, CLEAR, GLASS};
use ::refraction::{Material, Optics, refract_or_reflect, trace};
use ::shadows::Scene;
use glam::Vec3;

// ANCHOR: exercise-1
pub fn sea() -> Object<Material> {
    let optics = Optics::Dielectric {
        eta_inside: 1.33,
        eta_outside: AIR,
    };
    Object {
        name: "sea",
        // The inside is the side from which the normal points away: below.
        shape: Shape::plane(Vec3::Y, Vec3::Y),
        material: Material {
            phong: CLEAR,
            optics,
        },
    }
}
// ANCHOR_END: exercise-1

// ANCHOR: exercise-2
pub fn bubble_in_glass(radius: f32) -> Object<Material> {
    let optics = Optics::Dielectric {
        eta_inside: AIR,
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
pub fn trace_dispersed(
    scenes: &[Scene<Material>; 3],
    ray: &Ray,
    budget: PathBudget,
) -> Vec3 {
    let [red, green, blue] = [0, 1, 2].map(|channel| {
        let scene = &scenes[channel];
        trace(scene, ray, budget, refract_or_reflect)[channel]
    });
    Vec3::new(red, green, blue)
}
// ANCHOR_END: exercise-4
