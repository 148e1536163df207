//! What chapter 8 shows.

use crate::{Reflectance, fresnel, schlick, trace};
use canvas::{Picture, Stage, View};
use glam::Vec3;
use plane_hit::nearest;
use ray_casting::Camera;
use ray_casting::views::{STILL_LIFE_FOCAL_LENGTH, still_life_camera};
use reflection::{MAX_DEPTH, Reach};
use refraction::views::{AIR, GLASS, close_up, index, still_life_with_glass};
use refraction::{Body, Crossing};

/// Chapter 8.
pub const STAGE: Stage = Stage {
    name: "08-fresnel",
    title: "How much is mirrored, and how much goes through",
    views: &[
        View {
            name: "still-life",
            caption: "The still life, complete: the glass mirrors and lets through, each as much as it should.",
            knob: Some(index(&[1.0, 2.42])),
            picture: |index| {
                let camera = still_life_camera(STILL_LIFE_FOCAL_LENGTH);
                picture_of(index, AIR, camera, fresnel)
            },
        },
        View {
            name: "reflectance",
            caption: "The mirrored share alone, black for none and white for all: little in the middle of the \
                      ball, everything at its rim.",
            knob: Some(index(&[1.33, 2.42])),
            picture: |index| reflectance_of(index, AIR, fresnel),
        },
        View {
            name: "leaving",
            caption: "The mirrored share at a bubble of air in glass: all of it, from the critical angle outwards.",
            knob: None,
            picture: |_| reflectance_of(AIR, GLASS, fresnel),
        },
        View {
            name: "leaving-schlick",
            caption: "The mirrored share at the bubble by Schlick's formula with the wrong cosine: next to nothing where it should be all.",
            knob: None,
            picture: |_| reflectance_of(AIR, GLASS, schlick),
        },
    ],
};

/// The still life with glass of the index `inside`, its two ways shared out by `reflectance`.
#[must_use]
pub fn picture_of(
    inside: f32,
    outside: f32,
    camera: Camera,
    reflectance: Reflectance,
) -> Picture {
    let scene = still_life_with_glass(inside, outside);
    let reach = Reach::new(MAX_DEPTH);
    Picture::new(move |pixel| {
        trace(&scene, &camera.ray(pixel.centre()), reach, reflectance)
    })
}

/// The share that is mirrored where a ray meets the clear ball from near; all else is flat.
fn reflectance_of(inside: f32, outside: f32, reflectance: Reflectance) -> Picture {
    let objects = still_life_with_glass(inside, outside).objects;
    Picture::new(move |pixel| {
        let ray = close_up().ray(pixel.centre());
        let Some((object, hit)) = nearest(&objects, &ray) else {
            return BACKDROP;
        };
        let Body::Clear { inside, outside } = object.material.body else {
            return BACKDROP;
        };
        let Crossing {
            normal,
            eta_i,
            eta_t,
        } = Crossing::new(ray.direction, hit.normal, inside, outside);
        Vec3::splat(reflectance(-normal.dot(ray.direction), eta_i, eta_t))
    })
}

/// What is not the ball.
const BACKDROP: Vec3 = Vec3::new(0.05, 0.1, 0.2);
