// ANCHOR: amber
//! The still life with its ball of amber glass, and a pool of water with clear bodies in it.

use crate::Absorbing;
use glam::Vec3;
use plane_hit::{Object, Shape, Texture};
use ray_casting::{Camera, SKY};
use refraction::scene::{AIR, GLASS, still_life_with_glass};
use refraction::{Material, Optics};
use shading::Phong;
use shadows::{PointLight, Scene};

/// The absorption of amber glass, per unit of length: red, green and blue.
pub const AMBER: Vec3 = Vec3::new(0.1, 0.7, 2.5);

/// Returns the still life with glass of the given absorption.
pub fn absorbing_still_life(absorption: Vec3) -> Scene<Absorbing> {
    still_life_with_glass(GLASS, AIR).map(|material| Absorbing {
        material,
        absorption: match material.optics {
            Optics::Dielectric { .. } => absorption,
            Optics::Opaque { .. } => Vec3::ZERO,
        },
    })
}
// ANCHOR_END: amber

// ANCHOR: pool
/// Water's index of refraction.
pub const WATER: f32 = 1.33;
/// Ice's index of refraction.
pub const ICE: f32 = 1.31;

/// Returns a pool of blue-green water in which a ball of ice floats, and in which a ball of
/// amber glass with a bubble in it lies on the ground, and a camera above the water.
///
/// Each of them displaces what stands before it in the list: the ice and the glass the water,
/// the bubble the glass.
///
/// # Panics
/// Never: all objects are valid, and no two have the same surface.
pub fn pool() -> (Scene<Absorbing>, Camera) {
    let surface = |colour, diffuse, specular| Phong {
        colour,
        ambient: 0.1 * diffuse,
        diffuse,
        specular,
        shininess: 200,
    };
    let opaque = |name, shape, colour| Object {
        name,
        shape,
        material: Absorbing {
            material: Material {
                phong: surface(colour, 0.8, 0.0),
                optics: Optics::Opaque { reflectivity: 0.0 },
            },
            absorption: Vec3::ZERO,
        },
    };
    let clear = |name, shape, eta_inside, absorption| Object {
        name,
        shape,
        material: Absorbing {
            material: Material {
                phong: surface(Texture::Solid(Vec3::ONE), 0.0, 0.8),
                optics: Optics::Dielectric {
                    eta_inside,
                    eta_outside: AIR,
                },
            },
            absorption,
        },
    };
    let ball = |x, y, z, radius| Shape::sphere(Vec3::new(x, y, z), radius);
    let tiles = Texture::Checker(Vec3::new(0.5, 0.6, 0.7), Vec3::splat(0.9));
    let red = Texture::Solid(Vec3::new(0.9, 0.15, 0.1));
    let objects = vec![
        opaque("ground", Shape::plane(Vec3::NEG_Y, Vec3::Y), tiles),
        opaque("red", ball(-1.7, -0.5, 1.2, 0.5), red),
        clear(
            "water",
            Shape::plane(Vec3::ZERO, Vec3::Y),
            WATER,
            Vec3::new(0.5, 0.1, 0.15),
        ),
        clear("ice", ball(-0.5, 0.0, -0.4, 0.6), ICE, Vec3::ZERO),
        clear("glass", ball(0.9, -0.3, 0.0, 0.7), GLASS, AMBER),
        clear("bubble", ball(0.9, -0.3, 0.0, 0.35), AIR, Vec3::ZERO),
    ];
    let light = |x, y, z, intensity| {
        PointLight::new(Vec3::new(x, y, z), intensity).expect("a valid light")
    };
    let lights = vec![light(-4.0, 6.0, -3.0, 0.6), light(3.0, 5.0, -2.0, 0.4)];
    let scene = Scene::new(objects, lights, SKY).expect("six surfaces");
    let eye = Vec3::new(0.1, 1.7, -4.0);
    let towards = Vec3::new(0.05, -0.15, 0.0) - eye;
    let camera = Camera::new(eye, towards, Vec3::Y, 3.4).expect("a camera");
    (scene, camera)
}
// ANCHOR_END: pool
