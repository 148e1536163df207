//! The chapter's pictures.

use crate::scene::{light_between_balls, lit_still_life};
use crate::{Scene, Visibility, is_visible, is_visible_buggy, trace};
use canvas::{Picture, Stage, View, folder_name};
use plane_hit::Texture;
use plane_hit::scene::STILL_LIFE_COLOURS;
use ray_casting::Camera;
use ray_casting::scene::still_life_camera;

/// The chapter's description.
pub const STAGE: Stage = Stage {
    name: folder_name(env!("CARGO_MANIFEST_DIR")),
    title: "Shadows: what the light does not reach",
    hero: "hard",
    bugs: &["beyond-buggy"],
    views: &[
        View {
            name: "hard",
            caption: "The still life with the shadows of its two lights: darker where one is hidden, black where both are.",
            knob: None,
            picture: |_| still_life_by(still_life_camera(), is_visible),
        },
        View {
            name: "none",
            caption: "Without shadows: every light reaches everything, and the spheres seem to float.",
            knob: None,
            picture: |_| still_life_by(still_life_camera(), |_, _, _| true),
        },
        View {
            name: "beyond-buggy",
            caption: "The bug: the light hangs between the balls, and the upper ball, beyond it, darkens the floor.",
            knob: None,
            picture: |_| light_between_balls_by(is_visible_buggy),
        },
        View {
            name: "beyond",
            caption: "The cure: only an object in front of the light can occlude it. The lower ball has a shadow, the upper one has none.",
            knob: None,
            picture: |_| light_between_balls_by(is_visible),
        },
    ],
};

fn picture_of(
    scene: Scene<Texture>,
    camera: Camera,
    is_visible: Visibility<Texture>,
) -> Picture {
    Picture::new(move |pixel| trace(&scene, &camera.ray(pixel.centre()), is_visible))
}

/// Returns the picture of the still life with the shadows that `is_visible` finds.
pub fn still_life_by(camera: Camera, is_visible: Visibility<Texture>) -> Picture {
    picture_of(lit_still_life(STILL_LIFE_COLOURS), camera, is_visible)
}

/// Returns the picture of a light between two balls.
fn light_between_balls_by(is_visible: Visibility<Texture>) -> Picture {
    let (scene, camera) = light_between_balls();
    picture_of(scene, camera, is_visible)
}
