//! The chapter's pictures.

use crate::scene::horizon_radiance;
use crate::sobol::low_discrepancy;
use crate::{Sampler, adaptive, clamped, jittered, mean_of_levels, regular};
use canvas::{Knob, Picture, Scale, Stage, View, folder_name};
use fresnel::{fresnel, trace};
use glam::{Vec2, Vec3};
use ray_casting::SKY;
use ray_casting::scene::still_life_camera;
use reflection::{MAX_DEPTH, PathBudget};
use refraction::scene::{AIR, GLASS, still_life_with_glass};

/// The chapter's description.
pub const STAGE: Stage = Stage {
    name: folder_name(env!("CARGO_MANIFEST_DIR")),
    title: "Anti-aliasing: many rays per pixel",
    hero: "grid",
    bugs: &["dots-adaptive", "levels"],
    views: &[
        View {
            name: "grid",
            caption: "The still life by n × n rays per pixel: the larger n, the smoother its edges.",
            knob: Some(samples_knob(4, &[1.0, 2.0, 10.0, 20.0])),
            picture: |n| still_life_by(n, regular),
        },
        View {
            name: "jittered",
            caption: "As many rays, each somewhere in its cell: what was a pattern becomes noise.",
            knob: Some(samples_knob(4, &[])),
            picture: |n| still_life_by(n, jittered),
        },
        View {
            name: "adaptive",
            caption: "Four rays per pixel, and n × n more only where those four differ.",
            knob: Some(samples_knob(4, &[])),
            picture: |n| still_life_by(n, adaptive),
        },
        View {
            name: "horizon-grid",
            caption: "The floor near the horizon by n × n rays on a grid: false rings.",
            knob: Some(samples_knob(4, &[])),
            picture: |n| horizon_by(n, regular),
        },
        View {
            name: "horizon-jittered",
            caption: "The same, jittered: the rings are gone, and a little noise has come.",
            knob: Some(samples_knob(4, &[])),
            picture: |n| horizon_by(n, jittered),
        },
        View {
            name: "horizon-owen-sobol",
            caption: "The same by Owen-Sobol: no rings, and less noise.",
            knob: Some(samples_knob(4, &[])),
            picture: |n| horizon_by(n, low_discrepancy),
        },
        View {
            name: "dots-grid",
            caption: "Dots with a radius of a quarter of a pixel, by n × n rays: where these are dense, all of the dots are there, faint as they should be.",
            knob: Some(samples_knob(8, &[])),
            picture: |n| dots_by(n, regular),
        },
        View {
            name: "dots-adaptive",
            caption: "Such dots, adaptively: those that fall between the first four rays are never seen.",
            knob: Some(samples_knob(8, &[])),
            picture: |n| dots_by(n, adaptive),
        },
        View {
            name: "levels",
            caption: "The bug: the mean of levels, not of light. The floor darkens where its squares are small.",
            knob: Some(samples_knob(8, &[])),
            picture: |n| horizon_by(n, mean_of_levels),
        },
        View {
            name: "light",
            caption: "The cure: the mean of light, encoded once. The far floor is as bright as the near one.",
            knob: Some(samples_knob(8, &[])),
            picture: |n| horizon_by(n, regular),
        },
        View {
            name: "lamp-grid",
            caption: "A lamp a hundred times as bright as white: whatever touches it is white, and its edge has stairs.",
            knob: Some(samples_knob(8, &[])),
            picture: |n| lamp_by(n, regular),
        },
        View {
            name: "lamp-clamped",
            caption: "The same, each sample clamped to white: a smooth edge, and less light.",
            knob: Some(samples_knob(8, &[])),
            picture: |n| lamp_by(n, clamped),
        },
    ],
};

/// Returns the knob of the number of rows and columns of samples in a pixel.
pub const fn samples_knob(default: u32, snapshot_settings: &'static [f32]) -> Knob {
    Knob {
        name: "n",
        unit: "",
        min: 1.0,
        max: 20.0,
        default: default as f32,
        scale: Scale::Whole,
        snapshot_settings,
    }
}

fn still_life_by(n: f32, sampler: Sampler) -> Picture {
    let camera = still_life_camera();
    let scene = still_life_with_glass(GLASS, AIR);
    let budget = PathBudget::new(MAX_DEPTH);
    sampled(n, sampler, move |point| {
        trace(&scene, &camera.ray(point), budget, fresnel)
    })
}

/// Returns the picture of the floor alone, in flat colours.
fn horizon_by(n: f32, sampler: Sampler) -> Picture {
    sampled(n, sampler, horizon_radiance())
}

/// Returns the picture of white dots on black, their radius a quarter of a pixel in a
/// picture of 240 rows.
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

/// Returns the picture of a disc, a hundred times as bright as white, before a dark sky.
fn lamp_by(n: f32, sampler: Sampler) -> Picture {
    sampled(n, sampler, |point| {
        if point.length() < 0.5 {
            Vec3::splat(100.0)
        } else {
            0.1 * SKY
        }
    })
}

fn sampled(
    n: f32,
    sampler: Sampler,
    radiance: impl Fn(Vec2) -> Vec3 + Send + Sync + 'static,
) -> Picture {
    Picture::new(move |pixel| sampler(pixel, n as u32, &radiance))
}
