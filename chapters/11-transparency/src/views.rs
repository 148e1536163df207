//! The chapter's pictures.

use crate::scene::{AMBER, absorbing_still_life};
use crate::trace;
use canvas::{Knob, Picture, Scale, Stage, View, folder_name};
use ray_casting::Camera;
use ray_casting::scene::still_life_camera;
use reflection::{MAX_DEPTH, PathBudget};
use refraction::scene::close_up;
use shadow_acne::untracked;

/// The chapter's description.
pub const STAGE: Stage = Stage {
    name: folder_name(env!("CARGO_MANIFEST_DIR")),
    title: "Coloured glass, and light that gets through",
    hero: "still-life",
    bugs: &[],
    views: &[
        View {
            name: "still-life",
            caption: "The still life with a ball of amber glass: its shadow has its colour.",
            knob: Some(ABSORPTION),
            picture: |absorption| picture_of(absorption, still_life_camera()),
        },
        View {
            name: "ball",
            caption: "The ball from nearby: the longer the path through the glass, the deeper the colour.",
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
    snapshot_settings: &[0.0, 4.0],
};

fn picture_of(absorption: f32, camera: Camera) -> Picture {
    let scene = absorbing_still_life(absorption * AMBER);
    let budget = PathBudget::new(MAX_DEPTH);
    Picture::new(move |pixel| {
        trace(&scene, &untracked(camera.ray(pixel.centre())), budget)
    })
}
