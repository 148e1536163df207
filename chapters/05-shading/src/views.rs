//! What chapter 5 shows, and what the still life is made of.

use crate::{Phong, trace};
use canvas::{Knob, Picture, Scale, Stage, View};
use plane_hit::views::STILL_LIFE_COLOURS;
use ray_casting::Camera;
use ray_casting::views::{STILL_LIFE_FOCAL_LENGTH, still_life_camera};
use shadows::views::lit_still_life;

/// Chapter 5.
pub const STAGE: Stage = Stage {
    name: "05-shading",
    title: "Ambient, diffuse, specular",
    views: &[
        View {
            name: "combined",
            caption: "All three together: the still life, shaded.",
            knob: None,
            picture: |_| {
                still_life_of(still_life_camera(STILL_LIFE_FOCAL_LENGTH), |surface| {
                    surface
                })
            },
        },
        View {
            name: "ambient",
            caption: "Ambient light alone: everything glows a little, shadows or not.",
            knob: None,
            picture: |_| {
                still_life_of(still_life_camera(STILL_LIFE_FOCAL_LENGTH), |surface| {
                    Phong {
                        diffuse: 0.0,
                        specular: 0.0,
                        ..surface
                    }
                })
            },
        },
        View {
            name: "diffuse",
            caption: "Diffuse light alone: bright where a surface faces the lamp, dark where it turns away.",
            knob: None,
            picture: |_| {
                still_life_of(still_life_camera(STILL_LIFE_FOCAL_LENGTH), |surface| {
                    Phong {
                        ambient: 0.0,
                        specular: 0.0,
                        ..surface
                    }
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
                pinned: &[1.0, 10.0, 200.0],
            }),
            picture: |shininess| {
                still_life_of(
                    still_life_camera(STILL_LIFE_FOCAL_LENGTH),
                    move |surface| Phong {
                        ambient: 0.0,
                        diffuse: 0.0,
                        shininess: shininess as u32,
                        ..surface
                    },
                )
            },
        },
    ],
};

/// The still life's surfaces: floor, red, mirror, green, blue, glass. The mirror and the glass wait
/// for their chapters as plastic.
#[must_use]
pub fn still_life_surfaces() -> [Phong; 6] {
    let [floor, red, mirror, green, blue, glass] = STILL_LIFE_COLOURS;
    let phong = |colour, specular, shininess| Phong {
        colour,
        ambient: 0.1,
        diffuse: 0.8,
        specular,
        shininess,
    };
    [
        phong(floor, 0.0, 1),
        phong(red, 0.5, 50),
        phong(mirror, 0.8, 200),
        phong(green, 0.5, 50),
        phong(blue, 0.8, 100),
        phong(glass, 0.8, 200),
    ]
}

/// The still life, every surface of it changed by `change`.
#[must_use]
pub fn still_life_of(camera: Camera, change: impl Fn(Phong) -> Phong) -> Picture {
    let scene = lit_still_life(still_life_surfaces().map(change));
    Picture::new(move |pixel| trace(&scene, &camera.ray(pixel.centre())))
}
