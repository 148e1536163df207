//! What chapter 9 shows.

use crate::{adaptive, jittered, mean_of_levels, regular};
use canvas::{Knob, Picture, Pixel, Scale, Stage, View};
use fresnel::{fresnel, trace};
use glam::{Vec2, Vec3};
use plane_hit::still_life;
use plane_hit::views::STILL_LIFE_COLOURS;
use ray_casting::Camera;
use ray_casting::views::{STILL_LIFE_FOCAL_LENGTH, still_life_camera};
use reflection::{MAX_DEPTH, Reach};
use refraction::views::{AIR, GLASS, still_life_with_glass};

/// Chapter 9.
pub const STAGE: Stage = Stage {
    name: "09-anti-aliasing",
    title: "Many rays for one pixel",
    views: &[
        View {
            name: "grid",
            caption: "The still life by n × n rays for every pixel: the larger n, the smoother its edges.",
            knob: Some(n(4, &[1.0, 2.0, 10.0, 20.0])),
            picture: |n| still_life_by(n, regular),
        },
        View {
            name: "jittered",
            caption: "As many rays, each somewhere in its cell: what was a pattern becomes noise.",
            knob: Some(n(4, &[])),
            picture: |n| still_life_by(n, jittered),
        },
        View {
            name: "adaptive",
            caption: "Four rays for every pixel, and n × n more only where those four differ.",
            knob: Some(n(8, &[])),
            picture: |n| still_life_by(n, adaptive),
        },
        View {
            name: "horizon-grid",
            caption: "The floor near the horizon by 4 × 4 rays on a grid: false rings.",
            knob: Some(n(4, &[])),
            picture: |n| horizon_by(n, regular),
        },
        View {
            name: "horizon-jittered",
            caption: "The same, jittered: the rings are gone, and a little noise has come.",
            knob: Some(n(4, &[])),
            picture: |n| horizon_by(n, jittered),
        },
        View {
            name: "dots-grid",
            caption: "Dots with a radius of a quarter of a pixel, by n × n rays: all there, faint as they should be.",
            knob: Some(n(8, &[])),
            picture: |n| dots_by(n, regular),
        },
        View {
            name: "dots-adaptive",
            caption: "Such dots, adaptively: those that fall between the first four rays are never seen.",
            knob: Some(n(8, &[])),
            picture: |n| dots_by(n, adaptive),
        },
        View {
            name: "levels",
            caption: "The bug: the mean of levels, not of light. The floor darkens where its squares are small.",
            knob: Some(n(8, &[])),
            picture: |n| horizon_by(n, mean_of_levels),
        },
        View {
            name: "light",
            caption: "The cure: the mean of light, encoded once. The far floor is as bright as the near one.",
            knob: Some(n(8, &[])),
            picture: |n| horizon_by(n, regular),
        },
    ],
};

/// The knob of how many rows and columns of samples a pixel has.
#[must_use]
pub const fn n(default: u32, pinned: &'static [f32]) -> Knob {
    Knob {
        name: "n",
        unit: "",
        min: 1.0,
        max: 20.0,
        default: default as f32,
        scale: Scale::Whole,
        pinned,
    }
}

/// From a pixel, n, and what is seen at a point of the image plane, to the pixel's light.
type Sampler = fn(Pixel, u32, &dyn Fn(Vec2) -> Vec3) -> Vec3;

fn still_life_by(n: f32, sampler: Sampler) -> Picture {
    let camera = still_life_camera(STILL_LIFE_FOCAL_LENGTH);
    let scene = still_life_with_glass(GLASS, AIR);
    let reach = Reach::new(MAX_DEPTH);
    sampled(n, sampler, move |point| {
        trace(&scene, &camera.ray(point), reach, fresnel)
    })
}

/// A camera that looks at the far floor.
#[must_use]
pub fn horizon_camera() -> Camera {
    let eye = Vec3::new(0.0, 2.0, -7.0);
    Camera::new(eye, Vec3::new(0.0, -0.6, 7.0), Vec3::Y, 5.0).expect("a camera")
}

/// The floor alone, in flat colours.
fn horizon_by(n: f32, sampler: Sampler) -> Picture {
    let camera = horizon_camera();
    let mut floor = still_life(STILL_LIFE_COLOURS);
    floor.truncate(1);
    sampled(n, sampler, move |point| {
        plane_hit::trace(&floor, &camera.ray(point))
    })
}

/// White dots on black, their radius a quarter of a pixel in a picture of 240 rows.
fn dots_by(n: f32, sampler: Sampler) -> Picture {
    const PIXEL: f32 = 2.0 / 240.0;
    const APART: f32 = 8.3 * PIXEL;
    sampled(n, sampler, |point| {
        let cell = point / APART;
        let to_dot = (cell - cell.floor() - Vec2::splat(0.5)) * APART;
        Vec3::splat(if to_dot.length() < 0.25 * PIXEL {
            1.0
        } else {
            0.0
        })
    })
}

fn sampled(
    n: f32,
    sampler: Sampler,
    light: impl Fn(Vec2) -> Vec3 + Send + Sync + 'static,
) -> Picture {
    Picture::new(move |pixel| sampler(pixel, n as u32, &light))
}
