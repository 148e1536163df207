//! The chapter's pictures.

use crate::scene::{AIR, GLASS, close_up, still_life_with_glass};
use crate::{
    Transmission, refract_or_reflect, refract_without_inverting,
    refract_without_total_reflection, trace,
};
use canvas::{Knob, Picture, Scale, Stage, View, folder_name};
use ray_casting::Camera;
use ray_casting::scene::still_life_camera;
use reflection::{MAX_DEPTH, PathBudget};

/// The chapter's description.
pub const STAGE: Stage = Stage {
    name: folder_name(env!("CARGO_MANIFEST_DIR")),
    title: "Refraction: glass, and how it bends light",
    hero: "glass",
    bugs: &["failed-ratio", "failed-total"],
    views: &[
        View {
            name: "glass",
            caption: "The still life with its ball of glass, in which the world is seen upside down.",
            knob: Some(eta_knob(&[])),
            picture: |index| {
                let camera = still_life_camera();
                picture_of(index, AIR, camera, refract_or_reflect)
            },
        },
        View {
            name: "ball",
            caption: "The ball from nearby: the larger its index, the more it refracts the light.",
            knob: Some(eta_knob(&[1.0, 1.33, 2.42])),
            picture: |index| picture_of(index, AIR, close_up(), refract_or_reflect),
        },
        View {
            name: "bubble",
            caption: "A bubble of air, and we are in the glass: towards its rim, light cannot enter, and the bubble is a mirror.",
            knob: None,
            picture: |_| picture_of(AIR, GLASS, close_up(), refract_or_reflect),
        },
        View {
            name: "failed-ratio",
            caption: "Refraction, failed: on leaving, the ratio of the indices is the same as on entering.",
            knob: None,
            picture: |_| picture_of(GLASS, AIR, close_up(), refract_without_inverting),
        },
        View {
            name: "failed-total",
            caption: "Refraction, failed: light that cannot enter the bubble is lost, and the rim is black.",
            knob: None,
            picture: |_| {
                picture_of(AIR, GLASS, close_up(), refract_without_total_reflection)
            },
        },
    ],
};

/// Returns the knob of an object's index of refraction.
pub const fn eta_knob(snapshot_settings: &'static [f32]) -> Knob {
    Knob {
        name: "index",
        unit: "",
        min: 1.0,
        max: 3.0,
        default: GLASS,
        scale: Scale::Linear,
        snapshot_settings,
    }
}

/// Returns the picture of the still life with glass of the given indices, which scatters
/// rays as `transmission` says.
pub fn picture_of(
    eta_inside: f32,
    eta_outside: f32,
    camera: Camera,
    transmission: Transmission,
) -> Picture {
    let scene = still_life_with_glass(eta_inside, eta_outside);
    let budget = PathBudget::new(MAX_DEPTH);
    Picture::new(move |pixel| {
        trace(&scene, &camera.ray(pixel.centre()), budget, transmission)
    })
}
