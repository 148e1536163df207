//! The chapter's pictures.

use crate::scene::{STILL_LIFE_FOCAL_LENGTH, still_life_camera};
use crate::{Camera, trace};
use canvas::{Knob, Picture, Scale, Stage, View, folder_name};
use glam::{Vec2, Vec3};

/// The chapter's description.
pub const STAGE: Stage = Stage {
    name: folder_name(env!("CARGO_MANIFEST_DIR")),
    title: "Ray casting: a ray for every pixel",
    hero: "directions",
    bugs: &["upside-down"],
    views: &[
        View {
            name: "directions",
            caption: "Each pixel's ray as a colour: red grows with its x, green with its y, blue with its z.",
            knob: Some(FOCAL_LENGTH),
            picture: |focal_length| directions(with_focal_length(focal_length)),
        },
        View {
            name: "sky-and-ground",
            caption: "Sky where the ray rises, ground where it falls. A short focal length sees much of \
                      the world, a long one little of it.",
            knob: Some(FOCAL_LENGTH),
            picture: |focal_length| {
                let camera = with_focal_length(focal_length);
                Picture::new(move |pixel| trace(&camera.ray(pixel.centre())))
            },
        },
        View {
            name: "upside-down",
            caption: "The bug: y counts downwards on the image plane, as the rows do in the picture, and the sky is below.",
            knob: None,
            picture: |_| {
                let camera = still_life_camera();
                Picture::new(move |pixel| {
                    let Vec2 { x, y } = pixel.centre();
                    trace(&camera.ray(Vec2::new(x, -y)))
                })
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
    snapshot_settings: &[0.5],
};

/// Returns the still life's camera with another focal length, in half-heights of the image.
fn with_focal_length(focal_length: f32) -> Camera {
    Camera {
        focal_length,
        ..still_life_camera()
    }
}

/// Returns the picture of each camera ray's direction as a colour.
pub fn directions(camera: Camera) -> Picture {
    Picture::new(move |pixel| {
        let ray = camera.ray(pixel.centre());
        canvas::count_ray();
        (ray.direction + Vec3::ONE) / 2.0
    })
}
