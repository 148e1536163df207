//! The chapter's exercises: functions for you to write.

// ANCHOR: uses
use crate::Absorbing;
use crate::scene::AMBER;
use glam::Vec3;
use plane_hit::{Object, Shape, Texture};
use refraction::{Material, Optics};
use shading::Phong;
// ANCHOR_END: uses

// ANCHOR: exercise-1
/// Returns what is left of a light of some colour behind a pane of glass, `thickness` thick,
/// with the given absorption.
pub fn light_behind_glass(colour: Vec3, _absorption: Vec3, _thickness: f32) -> Vec3 {
    // Yours to write.
    colour
}
// ANCHOR_END: exercise-1

// ANCHOR: exercise-2
/// Returns the fraction of light that goes straight through a ball with some index of
/// refraction inside and 1 outside, when a part of it is reflected at each of the two surfaces.
/// The light arrives at an angle with the cosine `cos_theta`, and leaves at the angle at which it
/// came in. Reflections within the ball do not count.
pub fn through_two_interfaces(_cos_theta: f32, _eta: f32) -> f32 {
    // Yours to write.
    1.0
}
// ANCHOR_END: exercise-2

// ANCHOR: exercise-3
/// Returns a matte white ball, a pearl, with a radius of 0.2, in the middle of the still life's
/// ball of glass: at (0.9, 0.6, −1.2).
pub fn pearl() -> Object<Absorbing> {
    // Yours to write.
    Object {
        name: "pearl",
        shape: Shape::sphere(Vec3::new(0.9, 0.6, -1.2), 0.2),
        material: Absorbing {
            material: Material {
                phong: Phong {
                    colour: Texture::Solid(Vec3::ONE),
                    ambient: 0.1,
                    diffuse: 0.8,
                    specular: 0.0,
                    shininess: 1,
                },
                optics: Optics::Dielectric {
                    eta_inside: 1.5,
                    eta_outside: 1.0,
                },
            },
            absorption: AMBER,
        },
    }
}
// ANCHOR_END: exercise-3

// ANCHOR: exercise-4
/// Returns the pool's objects with the water last, and the others in their order.
pub fn water_last(objects: Vec<Object<Absorbing>>) -> Vec<Object<Absorbing>> {
    // Yours to write.
    objects
}
// ANCHOR_END: exercise-4

// ANCHOR: exercise-5
/// Returns the light of something seen through fog, from a `distance`: the fog absorbs all
/// colours at the rate `density`, and adds the colour of the `sky` for what it has absorbed.
pub fn through_fog(light: Vec3, _sky: Vec3, _density: f32, _distance: f32) -> Vec3 {
    // Yours to write.
    light
}
// ANCHOR_END: exercise-5
