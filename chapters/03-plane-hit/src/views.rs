//! The chapter's pictures.

use crate::scene::{DARK, LIGHT, STILL_LIFE_COLOURS, still_life};
use crate::{Plane, is_even, is_even_in_space, trace};
use canvas::{Picture, Stage, View, folder_name};
use glam::{Vec2, Vec3};
use ray_casting::scene::still_life_camera;
use ray_casting::{Camera, SKY};
use sphere_hit::T_MAX;
use sphere_hit::views::{drawing, ray_on_paper};

/// The chapter's description.
pub const STAGE: Stage = Stage {
    name: folder_name(env!("CARGO_MANIFEST_DIR")),
    title: "Planes: a floor, and the nearest of many",
    hero: "flat",
    bugs: &["checker-in-space"],
    views: &[
        View {
            name: "flat",
            caption: "The still life in flat colours: every ray returns the colour of the first object that it hits.",
            knob: None,
            picture: |_| flat(still_life_camera()),
        },
        View {
            name: "point",
            caption: "d·n is not 0: the line meets the plane in one point, and the ray hits it there if t is positive, as here.",
            knob: None,
            picture: |_| above_a_floor(Vec2::new(-1.1, 0.6), Vec2::new(0.8, -0.6)),
        },
        View {
            name: "none",
            caption: "d·n is 0, (x₀ − o)·n is not: the ray is parallel to the plane and never hits it.",
            knob: None,
            picture: |_| above_a_floor(Vec2::new(-1.1, 0.3), Vec2::X),
        },
        View {
            name: "contained",
            caption: "Both dot products are 0: the ray lies in the plane. There is no first point, so it counts as a miss.",
            knob: None,
            picture: |_| above_a_floor(Vec2::new(-1.1, FLOOR_ON_PAPER.y), Vec2::X),
        },
        View {
            name: "checker-in-space",
            caption: "The bug: squares by all three coordinates. Rounding puts a point of the floor above or below it, and speckles the squares.",
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

/// Returns the picture of the still life in flat colours.
pub fn flat(camera: Camera) -> Picture {
    let objects = still_life(STILL_LIFE_COLOURS);
    Picture::new(move |pixel| trace(&objects, &camera.ray(pixel.centre())))
}

/// Returns the picture of a floor at height −1, whose dark squares are those for which `is_even`
/// holds.
fn checkered_floor(is_even: fn(Vec3) -> bool) -> Picture {
    let camera = still_life_camera();
    let floor = Plane::new(Vec3::NEG_Y, Vec3::Y).expect("a plane");
    Picture::new(move |pixel| {
        let ray = camera.ray(pixel.centre());
        canvas::count_ray();
        match floor.distance(&ray, T_MAX) {
            Some(t) if is_even(ray.at(t)) => DARK,
            Some(_) => LIGHT,
            None => SKY,
        }
    })
}

/// The height of the drawings' floor, as a point of it.
const FLOOR_ON_PAPER: Vec2 = Vec2::new(0.0, -0.4);

/// Returns the drawing of a ray above a floor, seen from the side.
fn above_a_floor(start: Vec2, direction: Vec2) -> Picture {
    let floor = Plane::new(FLOOR_ON_PAPER.extend(0.0), Vec3::Y).expect("a plane");
    let ray = ray_on_paper(start, direction);
    let hit = floor.distance(&ray, T_MAX);
    let end = hit.map_or(start + 2.3 * direction, |t| ray.at(t).truncate());
    drawing(start, end, hit.iter().map(|_| end).collect(), |point| {
        (point.y - FLOOR_ON_PAPER.y).abs() - 0.012
    })
}
