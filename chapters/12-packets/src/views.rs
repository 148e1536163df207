//! What chapter 12 shows.

use crate::{LANES, packets_so_far, paint};
use canvas::{Knob, Picture, Pixel, Scale, Stage, View, rays_so_far};
use glam::Vec3;
use ray_casting::views::{STILL_LIFE_FOCAL_LENGTH, still_life_camera};
use reflection::{MAX_DEPTH, Reach};
use refraction::views::{AIR, GLASS, still_life_with_glass};

/// Chapter 12.
pub const STAGE: Stage = Stage {
    name: "12-packets",
    title: "Sixteen rays at once",
    views: &[
        View {
            name: "still-life",
            caption: "Chapter 10's still life by n × n rays for every pixel, sixteen at once: faster, and the same \
                      to the last bit.",
            knob: Some(Knob {
                name: "n",
                unit: "",
                min: 1.0,
                max: 20.0,
                default: 1.0,
                scale: Scale::Whole,
                pinned: &[4.0],
            }),
            picture: |n| {
                let paint = still_life();
                Picture::by_runs(move |first, run| paint(n as u32, first, run))
            },
        },
        View {
            name: "divergence",
            caption: "How full the lanes are: white where sixteen rays stay together, grey where some of them go \
                      another way than their neighbours, at edges and in glass.",
            knob: None,
            picture: |_| divergence(),
        },
    ],
};

/// Paints runs of the still life, by n × n rays for every pixel.
fn still_life() -> impl Fn(u32, Pixel, &mut [Vec3]) + Send + Sync {
    let camera = still_life_camera(STILL_LIFE_FOCAL_LENGTH);
    let scene = still_life_with_glass(GLASS, AIR);
    let reach = Reach::new(MAX_DEPTH);
    move |n, first, run| paint(&scene, &camera, reach, n, first, run)
}

/// For every pixel the share of lanes that are live in its packet, and in all packets that follow from it.
fn divergence() -> Picture {
    let paint = still_life();
    Picture::new(move |pixel| {
        let x = pixel.x - pixel.x % LANES as u32;
        let run = Ord::min(LANES, (pixel.size.x - x) as usize);
        let (rays, packets) = (rays_so_far(), packets_so_far());
        paint(1, Pixel { x, ..pixel }, &mut [Vec3::ZERO; LANES][..run]);
        let (rays, packets) = (rays_so_far() - rays, packets_so_far() - packets);
        Vec3::splat(rays as f32 / (LANES as u64 * packets) as f32)
    })
}
