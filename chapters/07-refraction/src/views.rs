//! What chapter 7 shows, and the still life with its glass.

use crate::{
    Body, Material, Redirect, redirect, redirect_without_inverting,
    redirect_without_total_reflection, trace,
};
use canvas::{Knob, Picture, Scale, Stage, View};
use glam::Vec3;
use plane_hit::Pattern;
use ray_casting::Camera;
use ray_casting::views::{STILL_LIFE_FOCAL_LENGTH, still_life_camera};
use reflection::views::still_life_mirrors;
use reflection::{MAX_DEPTH, Mirror, Reach};
use shading::Phong;
use shadows::Scene;
use shadows::views::lit_still_life;

/// Chapter 7.
pub const STAGE: Stage = Stage {
    name: "07-refraction",
    title: "Glass, and how it bends light",
    views: &[
        View {
            name: "glass",
            caption: "The still life with its ball of glass, which shows the world upside down.",
            knob: Some(index(&[])),
            picture: |index| {
                let camera = still_life_camera(STILL_LIFE_FOCAL_LENGTH);
                picture_of(index, AIR, camera, redirect)
            },
        },
        View {
            name: "ball",
            caption: "The ball from near: the larger its index, the more it bends the light.",
            knob: Some(index(&[1.0, 1.33, 2.42])),
            picture: |index| picture_of(index, AIR, close_up(), redirect),
        },
        View {
            name: "bubble",
            caption: "A bubble of air, and we are in the glass: towards its rim, light cannot enter, and the \
                      bubble is a mirror.",
            knob: None,
            picture: |_| picture_of(AIR, GLASS, close_up(), redirect),
        },
        View {
            name: "failed-ratio",
            caption: "Refraction, failed: bent on entering, and bent the same way again on leaving.",
            knob: None,
            picture: |_| picture_of(GLASS, AIR, close_up(), redirect_without_inverting),
        },
        View {
            name: "failed-total",
            caption: "Refraction, failed: light that cannot enter the bubble is forgotten, and its rim is black.",
            knob: None,
            picture: |_| {
                picture_of(AIR, GLASS, close_up(), redirect_without_total_reflection)
            },
        },
    ],
};

/// The index of refraction of air, as good as a vacuum's.
pub const AIR: f32 = 1.0;
/// The index of refraction of common glass.
pub const GLASS: f32 = 1.5;

/// The knob of a thing's index of refraction.
#[must_use]
pub const fn index(pinned: &'static [f32]) -> Knob {
    Knob {
        name: "index",
        unit: "",
        min: 1.0,
        max: 3.0,
        default: GLASS,
        scale: Scale::Linear,
        pinned,
    }
}

/// The still life with glass of the index `inside`, and whichever way rays go on at it.
#[must_use]
pub fn picture_of(
    inside: f32,
    outside: f32,
    camera: Camera,
    redirect: Redirect,
) -> Picture {
    let scene = still_life_with_glass(inside, outside);
    let reach = Reach::new(MAX_DEPTH);
    Picture::new(move |pixel| trace(&scene, &camera.ray(pixel.centre()), reach, redirect))
}

/// The still life, its last ball clear, with an index `inside` and another all around it.
#[must_use]
pub fn still_life_with_glass(inside: f32, outside: f32) -> Scene<Material> {
    let [floor, red, mirror, green, blue, _] = still_life_mirrors().map(opaque);
    // A clear ball scatters nothing. What it has of its own is the highlight.
    let phong = Phong {
        colour: Pattern::Plain(Vec3::ONE),
        ambient: 0.0,
        diffuse: 0.0,
        specular: 0.8,
        shininess: 200,
    };
    let body = Body::Clear { inside, outside };
    let glass = Material { phong, body };
    lit_still_life([floor, red, mirror, green, blue, glass])
}

fn opaque(mirror: Mirror) -> Material {
    let Mirror {
        phong,
        reflectivity,
    } = mirror;
    let body = Body::Opaque { reflectivity };
    Material { phong, body }
}

/// A camera that looks at the still life's clear ball from near.
#[must_use]
pub fn close_up() -> Camera {
    let eye = Vec3::new(0.7, 1.2, -4.2);
    let towards = Vec3::new(0.9, 0.6, -1.2) - eye;
    Camera::new(eye, towards, Vec3::Y, 3.4).expect("a camera")
}
