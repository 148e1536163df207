//! The chapter's pictures.

use crate::scene::still_life_surfaces;
use crate::{Phong, trace};
use canvas::{Knob, Picture, Scale, Stage, View, folder_name};
use ray_casting::Camera;
use ray_casting::scene::still_life_camera;
use shadows::scene::lit_still_life;

/// The chapter's description.
pub const STAGE: Stage = Stage {
    name: folder_name(env!("CARGO_MANIFEST_DIR")),
    title: "Shading: ambient, diffuse, specular",
    hero: "combined",
    bugs: &["too-much-light"],
    views: &[
        View {
            name: "combined",
            caption: "All three together: the still life, shaded.",
            knob: None,
            picture: |_| still_life_of(still_life_camera(), |surface| surface),
        },
        View {
            name: "ambient",
            caption: "Ambient light alone: everything glows a little, shadows or not.",
            knob: None,
            picture: |_| {
                still_life_of(still_life_camera(), |surface| Phong {
                    diffuse: 0.0,
                    specular: 0.0,
                    ..surface
                })
            },
        },
        View {
            name: "diffuse",
            caption: "Diffuse light alone: bright where a surface faces the light, dark where it turns away.",
            knob: None,
            picture: |_| {
                still_life_of(still_life_camera(), |surface| Phong {
                    ambient: 0.0,
                    specular: 0.0,
                    ..surface
                })
            },
        },
        View {
            name: "specular",
            caption: "Specular light alone, every sphere with the same shininess: the larger it is, the smaller the highlights.",
            knob: Some(Knob {
                name: "shininess",
                unit: "",
                min: 1.0,
                max: 256.0,
                default: 50.0,
                scale: Scale::Whole,
                snapshot_settings: &[1.0, 10.0, 200.0],
            }),
            picture: |shininess| {
                still_life_of(still_life_camera(), move |surface| Phong {
                    ambient: 0.0,
                    diffuse: 0.0,
                    shininess: shininess as u32,
                    ..surface
                })
            },
        },
        View {
            name: "too-much-light",
            caption: "The bug: every ball has a kₛ of 5. What is brighter than white is shown as white, and the highlights are flat white patches.",
            knob: None,
            picture: |_| {
                let mut surfaces = still_life_surfaces();
                for ball in &mut surfaces[1..] {
                    ball.specular = 5.0;
                }
                picture_of(still_life_camera(), surfaces)
            },
        },
    ],
};

/// Returns the picture of the still life with every surface changed by `change`.
pub fn still_life_of(camera: Camera, change: impl Fn(Phong) -> Phong) -> Picture {
    picture_of(camera, still_life_surfaces().map(change))
}

fn picture_of(camera: Camera, surfaces: [Phong; 6]) -> Picture {
    let scene = lit_still_life(surfaces);
    Picture::new(move |pixel| trace(&scene, &camera.ray(pixel.centre())))
}
