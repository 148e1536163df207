// ANCHOR: scene
//! A scene that provokes shadow acne: balls of very different sizes on a planet.

use glam::Vec3;
use plane_hit::{Object, Shape, Texture};
use ray_casting::{Camera, SKY};
use refraction::{Material, Optics};
use shading::Phong;
use shadows::{PointLight, Scene};

/// Returns balls of radius 1 to 1/200 on a planet of radius 1000, one of them a mirror, all
/// times `scale`, and a camera.
pub fn balls_on_a_planet(scale: f32) -> (Scene<Material>, Camera) {
    let plastic = |colour, reflectivity| Material {
        phong: Phong {
            colour: Texture::Solid(colour),
            ambient: 0.1,
            diffuse: 0.8,
            specular: 0.3,
            shininess: 50,
        },
        optics: Optics::Opaque { reflectivity },
    };
    // A ball whose lowest point is at a height above the planet's pole.
    let ball = |name, (x, height, z), radius, material| Object {
        name,
        shape: Shape::sphere(scale * Vec3::new(x, height + radius, z), scale * radius),
        material,
    };
    let grey = plastic(Vec3::splat(0.6), 0.0);
    let red = plastic(Vec3::new(0.9, 0.15, 0.1), 0.0);
    let blue = plastic(Vec3::new(0.15, 0.2, 0.9), 0.0);
    let mirror = plastic(Vec3::splat(0.1), 0.8);
    let objects = vec![
        ball("planet", (0.0, -2000.0, 0.0), 1000.0, grey),
        ball("large", (0.0, 0.0, 1.2), 1.0, red),
        ball("mirror", (-1.4, 0.0, 0.0), 0.5, mirror),
        ball("small", (0.5, 0.0, -1.4), 0.05, blue),
        ball("tiny", (0.4, 0.0, -1.45), 0.005, blue),
        ball("hovering", (0.7, 0.002, -1.5), 0.05, red),
    ];
    let light =
        PointLight::new(scale * Vec3::new(-3.0, 4.0, -4.0), 1.0).expect("a valid light");
    let scene = Scene::new(objects, vec![light], SKY).expect("six surfaces");
    let eye = Vec3::new(0.4, 0.9, -3.6);
    let towards = Vec3::new(-0.1, 0.35, 0.0) - eye;
    let camera = Camera::new(scale * eye, towards, Vec3::Y, 2.0).expect("a camera");
    (scene, camera)
}
// ANCHOR_END: scene
