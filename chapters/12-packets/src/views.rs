//! The chapter's pictures.

use crate::{LANES, packets_so_far, render};
use canvas::{Knob, Picture, Pixel, Scale, Stage, View, folder_name, rays_so_far};
use glam::Vec3;
use ray_casting::scene::still_life_camera;
use reflection::{MAX_DEPTH, PathBudget};
use refraction::scene::{AIR, GLASS, still_life_with_glass};

/// The chapter's description.
pub const STAGE: Stage = Stage {
    name: folder_name(env!("CARGO_MANIFEST_DIR")),
    title: "SIMD packets: sixteen rays at once",
    hero: "still-life",
    bugs: &[],
    views: &[
        View {
            name: "still-life",
            caption: "The still life by n × n rays per pixel, sixteen at once: faster, and the same to the last bit.",
            knob: Some(Knob {
                name: "n",
                unit: "",
                min: 1.0,
                max: 20.0,
                default: 1.0,
                scale: Scale::Whole,
                snapshot_settings: &[4.0],
            }),
            picture: |n| {
                let render = still_life();
                Picture::from_spans(move |first, span| render(n as u32, first, span))
            },
        },
        View {
            name: "divergence",
            caption: "How full the lanes are: white where sixteen rays stay together, grey where some of them hit another object than their neighbours, at edges and in glass.",
            knob: None,
            picture: |_| divergence(),
        },
    ],
};

/// Returns a function that renders spans of the still life, by n × n rays per pixel.
fn still_life() -> impl Fn(u32, Pixel, &mut [Vec3]) + Send + Sync {
    let camera = still_life_camera();
    let scene = still_life_with_glass(GLASS, AIR);
    let budget = PathBudget::new(MAX_DEPTH);
    move |n, first, span| render(&scene, &camera, budget, n, first, span)
}

/// Returns the picture of the fraction of lanes that are active in each pixel's packet and in all
/// packets spawned from it.
fn divergence() -> Picture {
    let render = still_life();
    Picture::new(move |pixel| {
        let x = pixel.x - pixel.x % LANES as u32;
        let run = Ord::min(LANES, (pixel.size.x - x) as usize);
        let (rays, packets) = (rays_so_far(), packets_so_far());
        render(1, Pixel { x, ..pixel }, &mut [Vec3::ZERO; LANES][..run]);
        let (rays, packets) = (rays_so_far() - rays, packets_so_far() - packets);
        Vec3::splat(rays as f32 / (LANES as u64 * packets) as f32)
    })
}
