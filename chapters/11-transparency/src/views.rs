//! The chapter's pictures.

use crate::scene::{AMBER, absorbing_still_life, pool};
use crate::{Absorbing, OpticsAt, as_if_alone, between_media, trace};
use canvas::{Knob, Picture, Scale, Stage, View, folder_name};
use ray_casting::Camera;
use ray_casting::scene::still_life_camera;
use reflection::{MAX_DEPTH, PathBudget};
use refraction::scene::close_up;
use shadow_acne::from_eye;
use shadows::Scene;

/// The chapter's description.
pub const STAGE: Stage = Stage {
    name: folder_name(env!("CARGO_MANIFEST_DIR")),
    title: "Transparency: coloured glass, and light that gets through",
    hero: "still-life",
    bugs: &["alone"],
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
        View {
            name: "alone",
            caption: "The bug: every surface bends and reflects light as if its object were alone in the air.",
            knob: None,
            picture: |_| pool_by(as_if_alone),
        },
        View {
            name: "displaced",
            caption: "The cure: ice and glass displace the water, and the bubble displaces the glass.",
            knob: None,
            picture: |_| pool_by(between_media),
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
    render(scene, camera, between_media)
}

fn pool_by(optics_at: OpticsAt) -> Picture {
    let (scene, camera) = pool();
    render(scene, camera, optics_at)
}

fn render(scene: Scene<Absorbing>, camera: Camera, optics_at: OpticsAt) -> Picture {
    let budget = PathBudget::new(MAX_DEPTH);
    let start = from_eye(&scene.objects, camera.eye);
    Picture::new(move |pixel| {
        let ray = start(camera.ray(pixel.centre()));
        trace(&scene, &ray, budget, optics_at)
    })
}
