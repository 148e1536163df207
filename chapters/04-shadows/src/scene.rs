// ANCHOR: lit
//! The still life in the light of its two lights, and a light between two balls.

use crate::{PointLight, Scene};
use glam::Vec3;
use plane_hit::scene::still_life;
use ray_casting::SKY;

/// Returns the still life, made of `materials`, with its two lights.
///
/// # Panics
/// Never: both lights are valid, and no two objects have the same surface.
pub fn lit_still_life<M>(materials: [M; 6]) -> Scene<M> {
    let light = |x, y, z, intensity| {
        PointLight::new(Vec3::new(x, y, z), intensity).expect("a valid light")
    };
    let lights = vec![light(-5.0, 7.0, -6.0, 0.6), light(4.0, 6.0, -4.0, 0.4)];
    Scene::new(still_life(materials), lights, SKY).expect("six surfaces")
}
// ANCHOR_END: lit

// ANCHOR: between
use plane_hit::{Object, Shape, Texture};
use ray_casting::Camera;

/// Returns a scene of a ball on the floor, another high above it, and a light between the
/// two; and a camera.
pub fn light_between_balls() -> (Scene<Texture>, Camera) {
    let ball = |name, height, colour| Object {
        name,
        shape: Shape::sphere(Vec3::new(0.0, height, 0.0), 0.5),
        material: Texture::Solid(colour),
    };
    let floor = Object {
        name: "floor",
        shape: Shape::plane(Vec3::ZERO, Vec3::Y),
        material: Texture::Solid(Vec3::splat(0.7)),
    };
    let objects = vec![
        floor,
        ball("lower", 0.5, Vec3::new(0.9, 0.3, 0.05)),
        ball("upper", 3.0, Vec3::new(0.1, 0.5, 0.6)),
    ];
    let light = PointLight::new(Vec3::new(0.7, 2.0, 0.0), 1.0).expect("a valid light");
    let scene = Scene::new(objects, vec![light], SKY).expect("three surfaces");
    let eye = Vec3::new(0.0, 2.5, -8.0);
    let towards = Vec3::new(0.3, 1.5, 0.0) - eye;
    let camera = Camera::new(eye, towards, Vec3::Y, 3.0).expect("a camera");
    (scene, camera)
}
// ANCHOR_END: between
