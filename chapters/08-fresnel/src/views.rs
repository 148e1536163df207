//! The chapter's pictures.

use crate::scene::reflectance_along;
use crate::{Reflectance, fresnel, schlick, trace};
use canvas::{Picture, Stage, View, folder_name};
use ray_casting::Camera;
use ray_casting::scene::still_life_camera;
use reflection::{MAX_DEPTH, PathBudget};
use refraction::scene::{AIR, GLASS, close_up, still_life_with_glass};
use refraction::views::eta_knob;

/// The chapter's description.
pub const STAGE: Stage = Stage {
    name: folder_name(env!("CARGO_MANIFEST_DIR")),
    title: "Fresnel: how much is reflected, and how much is transmitted",
    hero: "still-life",
    bugs: &["leaving-schlick"],
    views: &[
        View {
            name: "still-life",
            caption: "The still life, complete: the glass reflects and transmits, each as much as it should.",
            knob: Some(eta_knob(&[1.0, 2.42])),
            picture: |index| {
                let camera = still_life_camera();
                picture_of(index, AIR, camera, fresnel)
            },
        },
        View {
            name: "reflectance",
            caption: "The reflectance alone, black for none and white for all: little in the middle of the ball, everything at its rim.",
            knob: Some(eta_knob(&[1.33, 2.42])),
            picture: |index| reflectance_of(index, AIR, fresnel),
        },
        View {
            name: "leaving",
            caption: "The reflectance at a bubble of air in glass: all of it, from the critical angle outwards.",
            knob: None,
            picture: |_| reflectance_of(AIR, GLASS, fresnel),
        },
        View {
            name: "leaving-schlick",
            caption: "The reflectance at the bubble by Schlick's formula with the wrong cosine: next to nothing where it should be all.",
            knob: None,
            picture: |_| reflectance_of(AIR, GLASS, schlick),
        },
    ],
};

/// Returns the picture of the still life with glass of the given indices and `reflectance`.
pub fn picture_of(
    eta_inside: f32,
    eta_outside: f32,
    camera: Camera,
    reflectance: Reflectance,
) -> Picture {
    let scene = still_life_with_glass(eta_inside, eta_outside);
    let budget = PathBudget::new(MAX_DEPTH);
    Picture::new(move |pixel| {
        trace(&scene, &camera.ray(pixel.centre()), budget, reflectance)
    })
}

/// Returns the picture of the reflectance at each point of the glass ball's surface, seen
/// from nearby.
fn reflectance_of(
    eta_inside: f32,
    eta_outside: f32,
    reflectance: Reflectance,
) -> Picture {
    let objects = still_life_with_glass(eta_inside, eta_outside).objects;
    Picture::new(move |pixel| {
        reflectance_along(&close_up().ray(pixel.centre()), &objects, reflectance)
    })
}
