//! The chapter's pictures.

use crate::scene::{colour_inside, facing_mirrors, still_life_mirrors};
use crate::{MAX_DEPTH, Mirror, PathBudget, reflect, reflect_unnormalized, trace};
use canvas::{Knob, Picture, Scale, Stage, View, folder_name};
use glam::Vec3;
use ray_casting::Camera;
use ray_casting::scene::still_life_camera;
use shadows::Scene;
use shadows::scene::lit_still_life;

/// The chapter's description.
pub const STAGE: Stage = Stage {
    name: folder_name(env!("CARGO_MANIFEST_DIR")),
    title: "Reflection: mirrors, and what is seen in them",
    hero: "bouncing",
    bugs: &["inside-textbook"],
    views: &[
        View {
            name: "bouncing",
            caption: "The still life with its mirror, and a green ball that reflects a little: the more bounces, the more is seen in them.",
            knob: Some(depth_knob(MAX_DEPTH, &[0.0, 2.0])),
            picture: |depth| {
                let camera = still_life_camera();
                picture_of(lit_still_life(still_life_mirrors()), camera, depth)
            },
        },
        View {
            name: "one-bounce",
            caption: "One bounce and no more: the mirror shows a green ball that reflects nothing.",
            knob: None,
            picture: |_| {
                let camera = still_life_camera();
                picture_of(lit_still_life(still_life_mirrors()), camera, 1.0)
            },
        },
        View {
            name: "facing-mirrors",
            caption: "Two mirrors that face each other, each reflecting nine tenths of the light.",
            knob: Some(depth_knob(MAX_DEPTH, &[5.0, 20.0])),
            picture: |depth| {
                let (scene, camera) = facing_mirrors(0.9);
                picture_of(scene, camera, depth)
            },
        },
        View {
            name: "inside-textbook",
            caption: "Inside a mirror sphere with a checkered skin, after some bounces by the textbook's formulas. The black pixels' rays are lost.",
            knob: Some(BOUNCES),
            picture: |bounces| inside_a_sphere(bounces, reflect_unnormalized),
        },
        View {
            name: "inside-stable",
            caption: "The same bounces, each direction made a unit vector again.",
            knob: Some(BOUNCES),
            picture: |bounces| inside_a_sphere(bounces, reflect),
        },
    ],
};

/// Returns the knob of the greatest number of bounces.
pub const fn depth_knob(default: u32, snapshot_settings: &'static [f32]) -> Knob {
    Knob {
        name: "depth",
        unit: "bounces",
        min: 0.0,
        max: MAX_DEPTH as f32,
        default: default as f32,
        scale: Scale::Whole,
        snapshot_settings,
    }
}

const BOUNCES: Knob = Knob {
    name: "number of bounces",
    unit: "",
    min: 0.0,
    max: 16.0,
    default: 6.0,
    scale: Scale::Whole,
    snapshot_settings: &[3.0, 5.0, 10.0],
};

/// Returns the picture of a scene with mirrors, each ray followed for `depth` bounces.
pub fn picture_of(scene: Scene<Mirror>, camera: Camera, depth: f32) -> Picture {
    let budget = PathBudget::new(depth as u32);
    Picture::new(move |pixel| trace(&scene, &camera.ray(pixel.centre()), budget))
}

/// Returns the picture of the inside of a mirror sphere with a checkered surface, after a
/// number of bounces.
fn inside_a_sphere(bounces: f32, reflect: fn(Vec3, Vec3) -> Vec3) -> Picture {
    let eye = Vec3::new(0.0, 0.0, -0.6);
    let camera = Camera::new(eye, Vec3::Z, Vec3::Y, 1.0).expect("a camera");
    Picture::new(move |pixel| {
        colour_inside(camera.ray(pixel.centre()), bounces as u32, reflect)
    })
}
