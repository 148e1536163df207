//! What chapter 4 shows, and the still life's lights.

use crate::{PointLight, Reaches, Scene, light_reaches, light_reaches_buggy, trace};
use canvas::{Picture, Stage, View};
use glam::Vec3;
use plane_hit::views::STILL_LIFE_COLOURS;
use plane_hit::{Object, Pattern, Plane, Shape, still_life};
use ray_casting::views::{STILL_LIFE_FOCAL_LENGTH, still_life_camera};
use ray_casting::{Camera, SKY};
use sphere_hit::Sphere;

/// Chapter 4.
pub const STAGE: Stage = Stage {
    name: "04-shadows",
    title: "What the light does not reach",
    views: &[
        View {
            name: "hard",
            caption: "The still life with the shadows of its two lights: half-dark where one is hidden, black where both are.",
            knob: None,
            picture: |_| {
                still_life_by(still_life_camera(STILL_LIFE_FOCAL_LENGTH), light_reaches)
            },
        },
        View {
            name: "none",
            caption: "Without shadows: every light reaches everything, and the spheres seem to float.",
            knob: None,
            picture: |_| {
                still_life_by(still_life_camera(STILL_LIFE_FOCAL_LENGTH), |_, _, _, _| {
                    true
                })
            },
        },
        View {
            name: "lamp-buggy",
            caption: "The bug: the lamp hangs between the balls, and the upper ball, beyond the lamp, darkens the floor.",
            knob: None,
            picture: |_| lamp_between_balls(light_reaches_buggy),
        },
        View {
            name: "lamp",
            caption: "The cure: only what lies before the light can block it. The lower ball has a shadow, the upper one has none.",
            knob: None,
            picture: |_| lamp_between_balls(light_reaches),
        },
    ],
};

/// The still life, made of any `materials`, with its two lights.
#[must_use]
pub fn lit_still_life<M>(materials: [M; 6]) -> Scene<M> {
    let light = |x, y, z, intensity| PointLight {
        position: Vec3::new(x, y, z),
        intensity,
    };
    Scene {
        objects: still_life(materials),
        lights: vec![light(-5.0, 7.0, -6.0, 0.6), light(4.0, 6.0, -4.0, 0.4)],
        background: SKY,
    }
}

fn picture_of(
    scene: Scene<Pattern>,
    camera: Camera,
    reaches: Reaches<Pattern>,
) -> Picture {
    Picture::new(move |pixel| trace(&scene, &camera.ray(pixel.centre()), reaches))
}

/// The still life with whichever shadows `reaches` finds.
#[must_use]
pub fn still_life_by(camera: Camera, reaches: Reaches<Pattern>) -> Picture {
    picture_of(lit_still_life(STILL_LIFE_COLOURS), camera, reaches)
}

/// A ball on the floor, another high above it, and a lamp between the two.
fn lamp_between_balls(reaches: Reaches<Pattern>) -> Picture {
    let ball = |name, height, colour| Object {
        name,
        shape: Shape::Sphere(
            Sphere::new(Vec3::new(0.0, height, 0.0), 0.5).expect("a sphere"),
        ),
        material: Pattern::Plain(colour),
    };
    let floor = Object {
        name: "floor",
        shape: Shape::Plane(Plane::new(Vec3::ZERO, Vec3::Y).expect("a plane")),
        material: Pattern::Plain(Vec3::splat(0.7)),
    };
    let scene = Scene {
        objects: vec![
            floor,
            ball("lower", 0.5, Vec3::new(0.9, 0.3, 0.05)),
            ball("upper", 3.0, Vec3::new(0.1, 0.5, 0.6)),
        ],
        lights: vec![PointLight {
            position: Vec3::new(0.7, 2.0, 0.0),
            intensity: 1.0,
        }],
        background: SKY,
    };
    let eye = Vec3::new(0.0, 2.5, -8.0);
    let towards = Vec3::new(0.3, 1.5, 0.0) - eye;
    let camera = Camera::new(eye, towards, Vec3::Y, 3.0).expect("a camera");
    picture_of(scene, camera, reaches)
}
