// ANCHOR: mirrors
//! The still life with its mirrors, two mirrors that face each other, and a mirror sphere from
//! within.

use crate::{Mirror, bounce_inside};
use glam::{Vec2, Vec3};
use plane_hit::{Object, Shape, Texture, is_even};
use ray_casting::{Camera, Ray, SKY};
use shading::Phong;
use shading::scene::still_life_surfaces;
use shadows::{PointLight, Scene};
use sphere_hit::{Sphere, T_MAX};

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

// ANCHOR: inside
/// Returns the colour of the checkered inside of a mirror sphere of radius 1 where a `ray` from
/// within it arrives after a number of bounces, each by `reflect`: red, green and blue grow with
/// x, y and z. Black if the ray is lost.
pub fn colour_inside(
    mut ray: Ray,
    bounces: u32,
    reflect: fn(Vec3, Vec3) -> Vec3,
) -> Vec3 {
    let sphere = Sphere::new(Vec3::ZERO, 1.0).expect("a sphere");
    canvas::count_ray();
    let Some(t) = sphere.distance(&ray, T_MAX) else {
        return Vec3::ZERO;
    };
    // The first wall, then one more for every bounce.
    let normal = sphere.normal(ray.at(t));
    ray.direction = reflect(ray.direction, normal);
    ray.origin = normal;
    for _ in 0..bounces {
        ray = bounce_inside(&sphere, &ray, reflect);
    }
    let end = ray.origin;
    if !((end.length() - 1.0).abs() < LOST) {
        return Vec3::ZERO;
    }
    let colour = (end + Vec3::ONE) / 2.0;
    if is_even(6.0 * Vec2::new(end.x, end.y)) {
        colour
    } else {
        0.6 * colour
    }
}

/// A point this far from the sphere of radius 1 that it should be on is lost.
const LOST: f32 = 0.1;
// ANCHOR_END: inside
