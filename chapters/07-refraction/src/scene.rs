// ANCHOR: glass
//! The still life with its ball of glass.

use crate::{Material, Optics};
use glam::Vec3;
use plane_hit::Texture;
use ray_casting::Camera;
use reflection::Mirror;
use reflection::scene::still_life_mirrors;
use shading::Phong;
use shadows::Scene;
use shadows::scene::lit_still_life;

/// The index of refraction of air, rounded to that of a vacuum.
pub const AIR: f32 = 1.0;
/// The index of refraction of common glass.
pub const GLASS: f32 = 1.5;

/// A clear surface. It reflects nothing diffusely: of the lights it shows the highlights alone.
pub const CLEAR: Phong = Phong {
    colour: Texture::Solid(Vec3::ONE),
    ambient: 0.0,
    diffuse: 0.0,
    specular: 0.8,
    shininess: 200,
};

/// Returns the still life with its last ball of a dielectric, with an index of refraction
/// inside and another all around it.
pub fn still_life_with_glass(eta_inside: f32, eta_outside: f32) -> Scene<Material> {
    let [floor, red, mirror, green, blue, _] = still_life_mirrors().map(opaque);
    let optics = Optics::Dielectric {
        eta_inside,
        eta_outside,
    };
    let glass = Material {
        phong: CLEAR,
        optics,
    };
    lit_still_life([floor, red, mirror, green, blue, glass])
}

/// Returns the same surface as an opaque material.
pub fn opaque(mirror: Mirror) -> Material {
    let Mirror {
        phong,
        reflectivity,
    } = mirror;
    let optics = Optics::Opaque { reflectivity };
    Material { phong, optics }
}
// ANCHOR_END: glass

// ANCHOR: close-up
/// Returns a camera that looks at the ball of glass from nearby.
pub fn close_up() -> Camera {
    let eye = Vec3::new(0.7, 1.2, -4.2);
    let towards = Vec3::new(0.9, 0.6, -1.2) - eye;
    Camera::new(eye, towards, Vec3::Y, 3.4).expect("a camera")
}
// ANCHOR_END: close-up
