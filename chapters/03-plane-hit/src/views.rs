//! What chapter 3 shows, and the still life's colours.

use crate::{Pattern, Plane, is_even, is_even_in_space, still_life, trace};
use canvas::{Picture, Stage, View};
use glam::{Vec2, Vec3};
use ray_casting::views::{STILL_LIFE_FOCAL_LENGTH, still_life_camera};
use ray_casting::{Camera, SKY};
use sphere_hit::FARTHEST;
use sphere_hit::views::{drawing, ray_on_paper};

/// Chapter 3.
pub const STAGE: Stage = Stage {
    name: "03-plane-hit",
    title: "A floor, and the nearest of many",
    views: &[
        View {
            name: "flat",
            caption: "The still life in flat colours: every ray brings back the colour of what it meets first.",
            knob: None,
            picture: |_| flat(still_life_camera(STILL_LIFE_FOCAL_LENGTH)),
        },
        View {
            name: "point",
            caption: "d·n is not 0: the ray meets the plane in one point.",
            knob: None,
            picture: |_| above_a_floor(Vec2::new(-1.1, 0.6), Vec2::new(0.8, -0.6)),
        },
        View {
            name: "none",
            caption: "d·n is 0, (x₀ − o)·n is not: the ray runs beside the plane and never meets it.",
            knob: None,
            picture: |_| above_a_floor(Vec2::new(-1.1, 0.3), Vec2::X),
        },
        View {
            name: "contained",
            caption: "Both dot products are 0: the ray lies in the plane. No point is the first, so it counts as no hit.",
            knob: None,
            picture: |_| above_a_floor(Vec2::new(-1.1, FLOOR_ON_PAPER.y), Vec2::X),
        },
        View {
            name: "checker-in-space",
            caption: "The bug: squares by all three coordinates. Rounding puts a point of the floor above \
                      or below it, and speckles the squares.",
            knob: None,
            picture: |_| checkered_floor(is_even_in_space),
        },
        View {
            name: "checker-in-plane",
            caption: "The cure: squares by the two coordinates in the plane, clean up to the horizon.",
            knob: None,
            // At the odd height the cubes' colours have changed places.
            picture: |_| checkered_floor(|point| !is_even(Vec2::new(point.x, point.z))),
        },
    ],
};

/// The floor's even squares.
const DARK: Vec3 = Vec3::splat(0.1);
/// The floor's odd squares.
const LIGHT: Vec3 = Vec3::splat(0.9);

/// The still life's colours: floor, red, mirror, green, blue, glass. The mirror and the glass wait
/// for their chapters as grey and pale blue.
pub const STILL_LIFE_COLOURS: [Pattern; 6] = [
    Pattern::Checker(DARK, LIGHT),
    Pattern::Plain(Vec3::new(0.9, 0.15, 0.1)),
    Pattern::Plain(Vec3::splat(0.6)),
    Pattern::Plain(Vec3::new(0.1, 0.7, 0.2)),
    Pattern::Plain(Vec3::new(0.15, 0.2, 0.9)),
    Pattern::Plain(Vec3::new(0.55, 0.75, 0.8)),
];

/// The still life in flat colours.
#[must_use]
pub fn flat(camera: Camera) -> Picture {
    let objects = still_life(STILL_LIFE_COLOURS);
    Picture::new(move |pixel| trace(&objects, &camera.ray(pixel.centre())))
}

/// The floor at height −1, looked at by the still life's camera, with whatever says which squares are dark.
fn checkered_floor(is_even: fn(Vec3) -> bool) -> Picture {
    let camera = still_life_camera(STILL_LIFE_FOCAL_LENGTH);
    let floor = Plane::new(Vec3::NEG_Y, Vec3::Y).expect("a plane");
    Picture::new(move |pixel| {
        let ray = camera.ray(pixel.centre());
        match floor.hit(&ray, FARTHEST) {
            Some(hit) if is_even(ray.at(hit.t)) => DARK,
            Some(_) => LIGHT,
            None => SKY,
        }
    })
}

/// The height of the drawings' floor, as a point of it.
const FLOOR_ON_PAPER: Vec2 = Vec2::new(0.0, -0.4);

/// A ray above a floor, seen from the side.
fn above_a_floor(start: Vec2, direction: Vec2) -> Picture {
    let floor = Plane::new(FLOOR_ON_PAPER.extend(0.0), Vec3::Y).expect("a plane");
    let ray = ray_on_paper(start, direction);
    let hit = floor.hit(&ray, FARTHEST);
    let end = hit.map_or(start + 2.3 * direction, |hit| ray.at(hit.t).truncate());
    drawing(start, end, hit.iter().map(|_| end).collect(), |point| {
        (point.y - FLOOR_ON_PAPER.y).abs() - 0.012
    })
}
