//! What chapter 10 shows.

use crate::{
    Leave, at_the_point, by_a_fixed_offset, by_a_scaled_offset, from_the_eye,
    from_the_surface, trace,
};
use canvas::{Knob, Picture, Scale, Stage, View};
use glam::Vec3;
use plane_hit::{Object, Pattern, Shape};
use ray_casting::views::{STILL_LIFE_FOCAL_LENGTH, still_life_camera};
use ray_casting::{Camera, SKY};
use reflection::{MAX_DEPTH, Reach};
use refraction::views::{AIR, GLASS, still_life_with_glass};
use refraction::{Body, Material};
use shading::Phong;
use shadows::{PointLight, Scene};
use sphere_hit::Sphere;

/// Chapter 10.
pub const STAGE: Stage = Stage {
    name: "10-shadow-acne",
    title: "How a ray leaves a surface",
    views: &[
        View {
            name: "still-life",
            caption: "The still life without any offset, and without acne: every ray knows which surface it left.",
            knob: None,
            picture: |_| {
                let camera = still_life_camera(STILL_LIFE_FOCAL_LENGTH);
                let scene = still_life_with_glass(GLASS, AIR);
                picture_of(scene, camera, from_the_surface)
            },
        },
        View {
            name: "acne",
            caption: "The bug: rays start at the computed point, which is on either side of the surface, and \
                      the ground and the balls shadow themselves.",
            knob: Some(SCALE),
            picture: |scale| planet_by(scale, at_the_point),
        },
        View {
            name: "fixed",
            caption: "A fixed step off the surface: nearly right at one size of the world, acne in a large one, and \
                      shadows lost in a small one.",
            knob: Some(SCALE),
            picture: |scale| planet_by(scale, by_a_fixed_offset),
        },
        View {
            name: "scaled",
            caption: "A step that grows with the numbers: right at every size.",
            knob: Some(SCALE),
            picture: |scale| planet_by(scale, by_a_scaled_offset),
        },
        View {
            name: "from-surface",
            caption: "The cure: no step at all. The same picture at every size.",
            knob: Some(SCALE),
            picture: |scale| planet_by(scale, from_the_surface),
        },
    ],
};

const SCALE: Knob = Knob {
    name: "scale",
    unit: "",
    min: 1e-3,
    max: 1e6,
    default: 1.0,
    scale: Scale::Logarithmic,
    pinned: &[1e-3, 1e3, 1e6],
};

fn picture_of(scene: Scene<Material>, camera: Camera, leave: Leave<Material>) -> Picture {
    let reach = Reach::new(MAX_DEPTH);
    Picture::new(move |pixel| {
        let leaving = from_the_eye(camera.ray(pixel.centre()));
        trace(&scene, leaving, reach, leave)
    })
}

fn planet_by(scale: f32, leave: Leave<Material>) -> Picture {
    let (scene, camera) = balls_on_a_planet(scale);
    picture_of(scene, camera, leave)
}

/// Balls of radius 1 to 1/200 on a planet of radius 1000, one of them a mirror, all times `scale`, and a
/// camera.
#[must_use]
pub fn balls_on_a_planet(scale: f32) -> (Scene<Material>, Camera) {
    let plastic = |colour, reflectivity| Material {
        phong: Phong {
            colour: Pattern::Plain(colour),
            ambient: 0.1,
            diffuse: 0.8,
            specular: 0.3,
            shininess: 50,
        },
        body: Body::Opaque { reflectivity },
    };
    // A ball whose lowest point is at a height above the planet's pole.
    let ball = |name, (x, height, z), radius, material| Object {
        name,
        shape: Shape::Sphere(
            Sphere::new(scale * Vec3::new(x, height + radius, z), scale * radius)
                .expect("a sphere"),
        ),
        material,
    };
    let grey = plastic(Vec3::splat(0.6), 0.0);
    let red = plastic(Vec3::new(0.9, 0.15, 0.1), 0.0);
    let blue = plastic(Vec3::new(0.15, 0.2, 0.9), 0.0);
    let mirror = plastic(Vec3::splat(0.1), 0.8);
    let scene = Scene {
        objects: vec![
            ball("planet", (0.0, -2000.0, 0.0), 1000.0, grey),
            ball("large", (0.0, 0.0, 1.2), 1.0, red),
            ball("mirror", (-1.4, 0.0, 0.0), 0.5, mirror),
            ball("small", (0.5, 0.0, -1.4), 0.05, blue),
            ball("tiny", (0.4, 0.0, -1.45), 0.005, blue),
            ball("hovering", (0.7, 0.002, -1.5), 0.05, red),
        ],
        lights: vec![PointLight {
            position: scale * Vec3::new(-3.0, 4.0, -4.0),
            intensity: 1.0,
        }],
        background: SKY,
    };
    let eye = Vec3::new(0.4, 0.9, -3.6);
    let towards = Vec3::new(-0.1, 0.35, 0.0) - eye;
    let camera = Camera::new(scale * eye, towards, Vec3::Y, 2.0).expect("a camera");
    (scene, camera)
}
