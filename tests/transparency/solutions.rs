//! The exercises' solutions, as the book prints them.

use ::fresnel::fresnel;
use ::plane_hit::{Object, Shape, Texture};
use ::refraction::{Material, Optics};
use ::shading::Phong;
use ::transparency::{Absorbing, transmittance};
use glam::Vec3;

// ANCHOR: exercise-1
pub fn light_behind_glass(colour: Vec3, absorption: Vec3, thickness: f32) -> Vec3 {
    colour * transmittance(absorption, thickness)
}
// ANCHOR_END: exercise-1

// ANCHOR: exercise-2
pub fn through_two_interfaces(cos_theta: f32, eta: f32) -> f32 {
    // On leaving, the reflectance is the same: it is that of the same path, backwards.
    let transmitted = 1.0 - fresnel(cos_theta, 1.0, eta);
    transmitted * transmitted
}
// ANCHOR_END: exercise-2

// ANCHOR: exercise-3
pub fn pearl() -> Object<Absorbing> {
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
                optics: Optics::Opaque { reflectivity: 0.0 },
            },
            absorption: Vec3::ZERO,
        },
    }
}
// ANCHOR_END: exercise-3

// ANCHOR: exercise-4
pub fn water_last(mut objects: Vec<Object<Absorbing>>) -> Vec<Object<Absorbing>> {
    // The sort keeps the order of those that it cannot tell apart, and false comes first.
    objects.sort_by_key(|object| object.name == "water");
    objects
}
// ANCHOR_END: exercise-4

// ANCHOR: exercise-5
pub fn through_fog(light: Vec3, sky: Vec3, density: f32, distance: f32) -> Vec3 {
    let transmitted = transmittance(Vec3::splat(density), distance);
    transmitted * light + (Vec3::ONE - transmitted) * sky
}
// ANCHOR_END: exercise-5
