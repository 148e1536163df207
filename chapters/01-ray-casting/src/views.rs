//! What chapter 1 shows, and where the still life's camera stands.

use crate::{Camera, trace};
use canvas::{Knob, Picture, Scale, Stage, View};
use glam::Vec3;

/// Chapter 1.
pub const STAGE: Stage = Stage {
    name: "01-ray-casting",
    title: "A ray for every pixel",
    views: &[
        View {
            name: "directions",
            caption: "Each pixel's ray as a colour: red grows with its x, green with its y, blue with its z.",
            knob: Some(FOCAL_LENGTH),
            picture: |focal_length| directions(still_life_camera(focal_length)),
        },
        View {
            name: "sky-and-ground",
            caption: "Sky where the ray rises, ground where it falls. A short focal length sees much of \
                      the world, a long one little of it.",
            knob: Some(FOCAL_LENGTH),
            picture: |focal_length| {
                let camera = still_life_camera(focal_length);
                Picture::new(move |pixel| trace(&camera.ray(pixel.centre())))
            },
        },
    ],
};

const FOCAL_LENGTH: Knob = Knob {
    name: "focal length",
    unit: "",
    min: 0.25,
    max: 16.0,
    default: STILL_LIFE_FOCAL_LENGTH,
    scale: Scale::Logarithmic,
    pinned: &[0.5],
};

/// 1 / tan(45°/2) = 1 + √2: a vertical field of view of 45°.
pub const STILL_LIFE_FOCAL_LENGTH: f32 = 1.0 + std::f32::consts::SQRT_2;

/// The camera that every chapter looks at the still life with.
///
/// # Panics
/// If `focal_length` is not a positive number.
#[must_use]
pub fn still_life_camera(focal_length: f32) -> Camera {
    let eye = Vec3::new(0.0, 2.0, -7.0);
    let forward = Vec3::new(0.0, -1.1, 7.0);
    Camera::new(eye, forward, Vec3::Y, focal_length).expect("a camera that looks ahead")
}

/// Each ray's direction as a colour.
#[must_use]
pub fn directions(camera: Camera) -> Picture {
    Picture::new(move |pixel| {
        let ray = camera.ray(pixel.centre());
        (ray.direction + Vec3::ONE) / 2.0
    })
}
