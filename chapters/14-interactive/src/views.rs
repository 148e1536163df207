//! What chapter 14 shows: the still life as each chapter draws it, from wherever we stand.

use crate::explain::explain;
use crate::{Walker, block_of, overlay};
use anti_aliasing::views::n;
use canvas::{Knob, Picture, Pixel, Scale, Stage, View, decode, encode};
use fresnel::fresnel;
use glam::{UVec2, Vec2, Vec3};
use packets::{LANES, Lanes};
use ray_casting::Camera;
use reflection::views::{depth, still_life_mirrors};
use reflection::{MAX_DEPTH, Reach};
use refraction::views::{AIR, GLASS, index, still_life_with_glass};
use refraction::{Material, redirect};
use shadows::views::{lit_still_life, still_life_by};
use shadows::{Scene, light_reaches};
use std::sync::Mutex;

/// Chapter 14. A key from 1 to 9 shows the view of that index, the last of them the first.
pub const STAGE: Stage = Stage {
    name: "14-interactive",
    title: "A walk through the picture",
    views: &[
        View {
            name: "still-life",
            caption: "The still life, finished: n × n rays for every pixel, and none that starts at the wrong place.",
            knob: Some(n(4, &[])),
            picture: |n| whole(0, Walker::START.camera(), n),
        },
        View {
            name: "ray-casting",
            caption: "Chapter 1: where each ray goes.",
            knob: None,
            picture: |_| whole(1, Walker::START.camera(), 0.0),
        },
        View {
            name: "sphere-hit",
            caption: "Chapter 2: what is hit, a sphere.",
            knob: None,
            picture: |_| whole(2, Walker::START.camera(), 0.0),
        },
        View {
            name: "plane-hit",
            caption: "Chapter 3: which of many is hit first.",
            knob: None,
            picture: |_| whole(3, Walker::START.camera(), 0.0),
        },
        View {
            name: "shadows",
            caption: "Chapter 4: which lamps reach it.",
            knob: None,
            picture: |_| whole(4, Walker::START.camera(), 0.0),
        },
        View {
            name: "shading",
            caption: "Chapter 5: how it answers their light.",
            knob: None,
            picture: |_| whole(5, Walker::START.camera(), 0.0),
        },
        View {
            name: "reflection",
            caption: "Chapter 6: what is mirrored in it.",
            knob: Some(depth(MAX_DEPTH, &[])),
            picture: |depth| whole(6, Walker::START.camera(), depth),
        },
        View {
            name: "refraction",
            caption: "Chapter 7: what is seen through it.",
            knob: Some(index(&[])),
            picture: |index| whole(7, Walker::START.camera(), index),
        },
        View {
            name: "fresnel",
            caption: "Chapter 8: how much of each.",
            knob: Some(index(&[])),
            picture: |index| whole(8, Walker::START.camera(), index),
        },
        View {
            name: "coarse",
            caption: "What is shown while we move: one ray for a block of pixels, whose sides are doubled until a frame is \
                      fast enough.",
            knob: Some(Knob {
                name: "halvings",
                unit: "",
                min: 0.0,
                max: crate::MOST_HALVINGS as f32,
                default: 2.0,
                scale: Scale::Whole,
                pinned: &[],
            }),
            picture: |halvings| whole(9, Walker::START.camera(), halvings),
        },
        View {
            name: "explained",
            caption: "A pixel's ray, explained: where it is mirrored, where it goes through glass, and which lamps are seen \
                      from there.",
            knob: None,
            picture: |_| whole(10, Walker::START.camera(), 0.0),
        },
    ],
};

/// How many samples of each pixel the view of that index is the mean of.
#[must_use]
pub fn samples(view: usize, setting: f32) -> u32 {
    match view {
        0 => setting as u32 * setting as u32,
        _ => 1,
    }
}

/// One of the [`samples`] of every pixel of the view of that index.
#[must_use]
pub fn sample(view: usize, camera: Camera, setting: f32, i: u32) -> Picture {
    match view {
        0 => packets_of(camera, setting as u32, i),
        1 => ray_casting::views::directions(camera),
        2 => sphere_hit::views::first_sphere(camera, sphere_hit::views::red),
        3 => plane_hit::views::flat(camera),
        4 => still_life_by(camera, light_reaches),
        5 => shading::views::still_life_of(camera, |surface| surface),
        6 => {
            let scene = lit_still_life(still_life_mirrors());
            reflection::views::picture_of(scene, camera, setting)
        }
        7 => refraction::views::picture_of(setting, AIR, camera, redirect),
        8 => fresnel::views::picture_of(setting, AIR, camera, fresnel),
        9 => coarse(camera, setting as u32),
        _ => explained(camera),
    }
}

/// One sample in the middle of every pixel of the view of that index.
#[must_use]
pub fn central(view: usize, camera: Camera, setting: f32) -> Picture {
    match view {
        0 => packets_of(camera, 1, 0),
        _ => sample(view, camera, setting, 0),
    }
}

/// The whole picture of the view of that index.
#[must_use]
pub fn whole(view: usize, camera: Camera, setting: f32) -> Picture {
    if view != 0 {
        return sample(view, camera, setting, 0);
    }
    let scene = scene(view, setting);
    Picture::by_runs(move |first, run| {
        packets::paint(&scene, &camera, REACH, setting as u32, first, run);
    })
}

/// How far the finished picture's rays are followed.
pub const REACH: Reach = Reach {
    depth: MAX_DEPTH,
    weight: 1.0,
    least_weight: reflection::LEAST_WEIGHT,
};

/// The finished scene that the view of that index is on its way to.
#[must_use]
pub fn scene(view: usize, setting: f32) -> Scene<Material> {
    let index = if [7, 8].contains(&view) {
        setting
    } else {
        GLASS
    };
    still_life_with_glass(index, AIR)
}

/// The i-th of n × n samples of every pixel, by chapter 12's packets.
fn packets_of(camera: Camera, n: u32, i: u32) -> Picture {
    let scene = scene(0, 0.0);
    Picture::by_runs(move |first, run| {
        for (x, places) in (first.x..).step_by(LANES).zip(run.chunks_mut(LANES)) {
            let first = Pixel { x, ..first };
            let from_centre = packets::from_centre(first, n, i);
            let rays = packets::rays(&camera, first, places.len(), from_centre);
            packets::trace(&scene, &rays, REACH, Lanes::splat(REACH.weight))
                .write(places);
        }
    })
}

fn coarse(camera: Camera, halvings: u32) -> Picture {
    let sample = packets_of(camera, 1, 0);
    Picture::new(move |pixel| sample.light(block_of(pixel, halvings)))
}

/// The still life with the path of one pixel's ray, which meets the glass.
///
/// A path is drawn over a whole picture: the first run to be painted paints it all, for the others.
fn explained(camera: Camera) -> Picture {
    let scene = scene(0, 0.0);
    let painted = Mutex::new((UVec2::ZERO, Vec::new()));
    Picture::by_runs(move |first, run| {
        let mut painted = painted.lock().expect("nobody panics with it");
        if painted.0 != first.size {
            *painted = (first.size, with_path(&scene, &camera, first.size));
        }
        let start = first.y as usize * first.size.x as usize + first.x as usize;
        for (place, &level) in run.iter_mut().zip(&painted.1[start..]) {
            *place = Vec3::from_array(level.map(decode));
        }
    })
}

fn with_path(scene: &Scene<Material>, camera: &Camera, size: UVec2) -> Vec<[u8; 3]> {
    let mut light = vec![Vec3::ZERO; size.x as usize * size.y as usize];
    for (y, run) in (0..).zip(light.chunks_mut(size.x as usize)) {
        packets::paint(scene, camera, REACH, 1, Pixel { x: 0, y, size }, run);
    }
    let mut levels: Vec<_> = light.into_iter().map(encode).collect();
    let at = (size.as_vec2() * Vec2::new(0.6, 0.64)).as_uvec2();
    let pixel = Pixel {
        x: at.x,
        y: at.y,
        size,
    };
    let explained = explain(scene, camera, pixel.centre(), REACH);
    overlay::draw(&explained, camera, size, &mut levels);
    levels
}
