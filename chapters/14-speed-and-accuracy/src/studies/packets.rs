//! Packets against single rays: the gain, and how many rays of a packet stay together.

use crate::chart::{Axis, Chart, Quantity};
use crate::study::{Choice, Clock, Study, each};
use crate::table::Measurement;
use canvas::{Picture, rays_so_far};
use glam::{UVec2, Vec3};
use measure::pictures::{frame, packet_picture, scalar_picture};
use measure::scenes::plain_scene;
use packets::{LANES, packets_so_far};
use reflection::{MAX_DEPTH, PathBudget};
use refraction::Material;
use shadows::Scene;

/// One ray at once or a packet of sixteen: lanes in use, and lanes that stay active from
/// bounce to bounce.
///
/// Nanoseconds are those of one pixel. Of "lanes", the setting is how many of the sixteen
/// hold a camera ray, and work is what is traced for a pixel, rays or packets; of
/// "divergence", the bounces before, and the active lanes of the packets that are traced
/// there; of "all rays", those of all packets. A pixel is wrong if any bit differs from that
/// of one ray at once.
pub const STUDY: Study = Study {
    name: "packets",
    title: "What sixteen rays at once gain: lanes in use, and lanes that stay together",
    measure,
    chosen: &[Choice::of("packets")],
    charts: &[
        Chart::new("lanes", (Quantity::Setting, "pixels in a packet"), TIME)
            .titled("The still life: every lane in use makes a pixel cheaper"),
        Chart::new("divergence", (Quantity::Setting, "bounces"), ACTIVE)
            .titled("Divergence: the more bounces, the emptier the packets"),
    ],
};

pub(super) const TIME: Axis = (Quantity::Ns, "nanoseconds per pixel");
const ACTIVE: Axis = (Quantity::Work, "active lanes of sixteen");

/// A size at which starting a thread pays.
pub(super) const LARGE: UVec2 = UVec2::new(320, 240);

fn measure(clock: &Clock) -> Vec<Measurement> {
    let mut rows = lanes(clock);
    rows.extend(divergence("still life", "still-life"));
    rows.extend(divergence("nested glass", "nested"));
    rows
}

/// Returns the still life by n × n samples per pixel, one ray at once and in packets.
pub(super) fn still_life(n: u32) -> [Picture; 2] {
    let (scene, camera) = plain_scene("still-life");
    let budget = PathBudget::new(MAX_DEPTH);
    [
        scalar_picture(scene.clone(), camera, budget, n),
        packet_picture(scene, camera, budget, n),
    ]
}

/// Returns the radiance of a picture rendered in spans, and the numbers of rays and packets
/// that this took.
fn traced(picture: &Picture, size: UVec2, span: usize) -> (Vec<Vec3>, [u64; 2]) {
    let before = [rays_so_far(), packets_so_far()];
    let radiance = frame(picture, size, span);
    let [rays, packets] = [rays_so_far(), packets_so_far()];
    (radiance, [rays - before[0], packets - before[1]])
}

/// Returns the percentage of pixels in which any bit differs.
pub(super) fn differing(right: &[Vec3], radiance: &[Vec3]) -> Option<f64> {
    let bits = |radiance: &Vec3| radiance.to_array().map(f32::to_bits);
    let pairs = right.iter().zip(radiance);
    let wrong = pairs.filter(|(right, ours)| bits(right) != bits(ours));
    Some(100.0 * wrong.count() as f64 / right.len() as f64)
}

fn lanes(clock: &Clock) -> Vec<Measurement> {
    // Its rows are whole packets for any number of lanes.
    let size = UVec2::new(160, 120);
    let pixels = size.element_product() as usize;
    let [single, sampled] = [1, 4].map(still_life);
    let right = [&single[0], &sampled[0]].map(|picture| frame(picture, size, LANES));
    let methods = [
        ("one by one", &single[0], &right[0]),
        ("packets", &single[1], &right[0]),
        ("one by one, 4 × 4", &sampled[0], &right[1]),
        ("packets, 4 × 4", &sampled[1], &right[1]),
    ];
    let mut rows = Vec::new();
    for lanes in [1, 2, 4, 8, LANES] {
        // A pixel's samples fill a packet, however long the span is.
        let methods = if lanes < LANES {
            &methods[..2]
        } else {
            &methods
        };
        let jobs = methods
            .iter()
            .map(|(_, picture, _)| each(&[()], move |()| frame(picture, size, lanes)));
        let times = clock.min_of_rounds(pixels, jobs);
        for ((method, picture, right), ns) in methods.iter().zip(times) {
            let (radiance, [rays, packets]) = traced(picture, size, lanes);
            let work = if packets == 0 { rays } else { packets };
            rows.push(Measurement {
                work: Some(work as f64 / pixels as f64),
                wrong: differing(right, &radiance),
                ns,
                ..Measurement::of("lanes", *method, lanes as f64)
            });
        }
    }
    rows
}

/// Returns the active lanes of the packets that each further bounce adds to a picture. In a
/// scene without lights none of them is of shadow rays; those are the difference to the
/// scene with its lights.
fn divergence(name: &str, scene: &str) -> Vec<Measurement> {
    let (lit, camera) = plain_scene(scene);
    let mut dark = lit.clone();
    dark.lights.clear();
    let up_to = |scene: &Scene<Material>, depth| {
        let picture = packet_picture(scene.clone(), camera, PathBudget::new(depth), 1);
        traced(&picture, LARGE, LANES).1.map(|count| count as f64)
    };
    let row = |scene, method, bounces: u32, [rays, packets]: [f64; 2]| Measurement {
        work: (packets > 0.0).then_some(rays / packets),
        ..Measurement::of(scene, method, bounces.into())
    };
    let less = |[a, b]: [f64; 2], [c, d]: [f64; 2]| [a - c, b - d];
    let (mut rows, mut paths, mut all) = (Vec::new(), [0.0; 2], [0.0; 2]);
    // Hardly a packet goes deeper.
    for depth in 0..=8 {
        let [deeper, deeper_all] = [up_to(&dark, depth), up_to(&lit, depth)];
        let (now, now_all) = (less(deeper, paths), less(deeper_all, all));
        rows.push(row("divergence", name.to_string(), depth, now));
        let to_lights = format!("{name}, to lights");
        rows.push(row("divergence", to_lights, depth, less(now_all, now)));
        (paths, all) = (deeper, deeper_all);
    }
    rows.push(row("all rays", name.to_string(), 0, up_to(&lit, MAX_DEPTH)));
    rows
}
