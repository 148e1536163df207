//! The still life with its mirrors, and two mirrors that face each other.

use crate::Mirror;
use glam::Vec3;
use plane_hit::{Object, Shape, Texture};
use ray_casting::{Camera, SKY};
use shading::Phong;
use shading::scene::still_life_surfaces;
use shadows::{PointLight, Scene};

// ANCHOR: mirrors
/// Returns the still life's surfaces with the mirror and a little reflectivity of the green
/// ball. The glass is still of plastic.
pub fn still_life_mirrors() -> [Mirror; 6] {
    let [floor, red, _, green, blue, glass] = still_life_surfaces();
    let mirror = Phong {
        colour: Texture::Solid(Vec3::splat(0.9)),
        ambient: 0.02,
        diffuse: 0.1,
        specular: 0.8,
        shininess: 200,
    };
    let with = |phong, reflectivity| Mirror {
        phong,
        reflectivity,
    };
    [
        with(floor, 0.0),
        with(red, 0.0),
        with(mirror, 0.8),
        with(green, 0.2),
        with(blue, 0.0),
        with(glass, 0.0),
    ]
}
// ANCHOR_END: mirrors

// ANCHOR: facing
/// Returns a scene of a ball between two mirror walls of some reflectivity, and a camera
/// between them.
pub fn facing_mirrors(reflectivity: f32) -> (Scene<Mirror>, Camera) {
    let plain = |colour| Phong {
        colour,
        ambient: 0.1,
        diffuse: 0.8,
        specular: 0.3,
        shininess: 50,
    };
    let wall = Phong {
        colour: Texture::Solid(Vec3::splat(0.9)),
        ambient: 0.02,
        diffuse: 0.03,
        specular: 0.0,
        shininess: 1,
    };
    let object = |name, shape, phong, reflectivity| Object {
        name,
        shape,
        material: Mirror {
            phong,
            reflectivity,
        },
    };
    let ball = Shape::sphere(Vec3::new(0.0, 0.8, 0.3), 0.8);
    let floor = Texture::Checker(Vec3::splat(0.1), Vec3::splat(0.9));
    let red = Texture::Solid(Vec3::new(0.9, 0.15, 0.1));
    let objects = vec![
        object(
            "floor",
            Shape::plane(Vec3::ZERO, Vec3::Y),
            plain(floor),
            0.0,
        ),
        object(
            "left",
            Shape::plane(3.0 * Vec3::NEG_X, Vec3::X),
            wall,
            reflectivity,
        ),
        object(
            "right",
            Shape::plane(3.0 * Vec3::X, Vec3::NEG_X),
            wall,
            reflectivity,
        ),
        object("ball", ball, plain(red), 0.0),
    ];
    let light = PointLight::new(Vec3::new(0.5, 5.0, -2.0), 0.9).expect("a valid light");
    let scene = Scene::new(objects, vec![light], SKY).expect("four surfaces");
    let eye = Vec3::new(2.7, 1.9, -1.6);
    let towards = Vec3::new(-3.0, 0.9, 0.7) - eye;
    let camera = Camera::new(eye, towards, Vec3::Y, 1.5).expect("a camera");
    (scene, camera)
}
// ANCHOR_END: facing
