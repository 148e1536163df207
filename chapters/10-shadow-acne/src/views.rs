//! The chapter's pictures.

use crate::scene::balls_on_a_planet;
use crate::{
    SpawnRay, from_eye, from_surface, trace, with_fixed_offset, with_scaled_offset,
    without_offset,
};
use canvas::{Knob, Picture, Scale, Stage, View, folder_name};
use ray_casting::Camera;
use ray_casting::scene::still_life_camera;
use reflection::{MAX_DEPTH, PathBudget};
use refraction::Material;
use refraction::scene::{AIR, GLASS, still_life_with_glass};
use shadows::Scene;

/// The chapter's description.
pub const STAGE: Stage = Stage {
    name: folder_name(env!("CARGO_MANIFEST_DIR")),
    title: "Shadow acne: how a ray leaves a surface",
    hero: "still-life",
    bugs: &["acne", "fixed"],
    views: &[
        View {
            name: "still-life",
            caption: "The still life without any offset, and without acne: every ray knows the surface that it starts on.",
            knob: None,
            picture: |_| {
                let camera = still_life_camera();
                let scene = still_life_with_glass(GLASS, AIR);
                picture_of(scene, camera, from_surface)
            },
        },
        View {
            name: "acne",
            caption: "The bug: rays start at the computed point, which is on either side of the surface, and the ground and the balls shadow themselves.",
            knob: Some(SCALE),
            picture: |scale| planet_by(scale, without_offset),
        },
        View {
            name: "fixed",
            caption: "A fixed offset from the surface: nearly right at one size of the world, acne in a large one, and shadows lost in a small one.",
            knob: Some(SCALE),
            picture: |scale| planet_by(scale, with_fixed_offset),
        },
        View {
            name: "scaled",
            caption: "An offset that grows with the numbers: right at every size, but for a few pixels.",
            knob: Some(SCALE),
            picture: |scale| planet_by(scale, with_scaled_offset),
        },
        View {
            name: "from-surface",
            caption: "The cure: no offset at all. Practically the same picture at every size.",
            knob: Some(SCALE),
            picture: |scale| planet_by(scale, from_surface),
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
    snapshot_settings: &[1e-3, 1e3, 1e6],
};

fn picture_of(scene: Scene<Material>, camera: Camera, spawn: SpawnRay) -> Picture {
    let budget = PathBudget::new(MAX_DEPTH);
    let start = from_eye(&scene.objects, camera.eye);
    Picture::new(move |pixel| {
        let ray = start(camera.ray(pixel.centre()));
        trace(&scene, &ray, budget, spawn)
    })
}

fn planet_by(scale: f32, spawn: SpawnRay) -> Picture {
    let (scene, camera) = balls_on_a_planet(scale);
    picture_of(scene, camera, spawn)
}
