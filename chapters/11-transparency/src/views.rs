//! What chapter 11 shows.

use crate::{Tinted, trace};
use canvas::{Knob, Picture, Scale, Stage, View};
use glam::Vec3;
use ray_casting::Camera;
use ray_casting::views::{STILL_LIFE_FOCAL_LENGTH, still_life_camera};
use reflection::{MAX_DEPTH, Reach};
use refraction::Body;
use refraction::views::{AIR, GLASS, close_up, still_life_with_glass};
use shadow_acne::from_the_eye;
use shadows::Scene;

/// Chapter 11.
pub const STAGE: Stage = Stage {
    name: "11-transparency",
    title: "Coloured glass, and light that gets through",
    views: &[
        View {
            name: "still-life",
            caption: "The still life with a ball of amber glass: its shadow has its colour.",
            knob: Some(ABSORPTION),
            picture: |absorption| {
                picture_of(absorption, still_life_camera(STILL_LIFE_FOCAL_LENGTH))
            },
        },
        View {
            name: "ball",
            caption: "The ball from near: the longer the way through the glass, the deeper the colour.",
            knob: Some(ABSORPTION),
            picture: |absorption| picture_of(absorption, close_up()),
        },
    ],
};

const ABSORPTION: Knob = Knob {
    name: "absorption",
    unit: "",
    min: 0.0,
    max: 4.0,
    default: 1.0,
    scale: Scale::Linear,
    pinned: &[0.0, 4.0],
};

/// What amber glass takes up of red, green and blue in a unit of length, at an absorption of 1.
pub const AMBER: Vec3 = Vec3::new(0.1, 0.7, 2.5);

fn picture_of(absorption: f32, camera: Camera) -> Picture {
    let scene = tinted_still_life(absorption * AMBER);
    let reach = Reach::new(MAX_DEPTH);
    Picture::new(move |pixel| {
        trace(&scene, from_the_eye(camera.ray(pixel.centre())), reach)
    })
}

/// The still life, its ball of glass with some `absorption`.
#[must_use]
pub fn tinted_still_life(absorption: Vec3) -> Scene<Tinted> {
    let scene = still_life_with_glass(GLASS, AIR);
    let tinted = |object: plane_hit::Object<refraction::Material>| plane_hit::Object {
        name: object.name,
        shape: object.shape,
        material: Tinted {
            material: object.material,
            absorption: match object.material.body {
                Body::Clear { .. } => absorption,
                Body::Opaque { .. } => Vec3::ZERO,
            },
        },
    };
    Scene {
        objects: scene.objects.into_iter().map(tinted).collect(),
        lights: scene.lights,
        background: scene.background,
    }
}
