//! Kinds of fault that others reported: a threshold on a linear scale for what is seen in
//! levels, and edges that are brighter than white.

use ::anti_aliasing::{Sampler, adaptive, clamped, jittered, regular};
use canvas::{Pixel, decode, encode};
use glam::{UVec2, Vec2, Vec3};
use harness::cases;
use proptest::prelude::*;
use std::cell::Cell;

const PIXEL: Pixel = Pixel {
    x: 5,
    y: 3,
    size: UVec2::new(16, 12),
};

/// Returns the pixel's level, and the number of its samples, at an edge of two lights that
/// passes through it.
fn at_edge(sampler: Sampler, n: u32, edge: f32, lights: [f32; 2]) -> (i32, u32) {
    let samples = Cell::new(0);
    let radiance = |point: Vec2| {
        samples.set(samples.get() + 1);
        let across = (point - PIXEL.centre()) / PIXEL.footprint();
        let is_beyond = across.x + 0.3 * across.y > edge;
        Vec3::splat(lights[usize::from(is_beyond)])
    };
    let radiance = sampler(PIXEL, n, &radiance);
    (i32::from(encode(radiance)[0]), samples.get())
}

/// Returns whether the first four samples lie on both sides of an edge.
fn is_found(edge: f32) -> bool {
    let (level, _) = at_edge(jittered, 2, edge, [0.0, 1.0]);
    level > 0 && level < 255
}

/// Black against a twentieth of white, which is 62 levels: by a linear threshold of 0.05, four
/// samples were enough, and a pixel was up to 38 levels off.
#[test]
fn a_dark_edge_is_seen_and_sampled() {
    let edges = (-40..=40).map(|i| i as f32 / 100.0);
    let found: Vec<f32> = edges.filter(|&edge| is_found(edge)).collect();
    assert!(found.len() > 30);
    for edge in found {
        let (ours, samples) = at_edge(adaptive, 8, edge, [0.0, 0.049]);
        let (finely, _) = at_edge(jittered, 32, edge, [0.0, 0.049]);
        assert_eq!(samples, 4 + 64);
        assert!((ours - finely).abs() <= 4, "{ours} {finely}");
    }
}

proptest! {
    #![proptest_config(cases(20_000))]

    /// In the dark as in the light: many samples follow if and only if the first four lie on
    /// both sides of an edge of more than 8 levels.
    #[test]
    fn an_edge_of_more_than_eight_levels_is_sampled_wherever_it_is_found(
        dark in any::<u8>(), step in prop_oneof![1..=16_u8, any::<u8>()], edge in -0.5..0.5_f32
    ) {
        let light = dark.saturating_add(step);
        let (_, samples) = at_edge(adaptive, 8, edge, [dark, light].map(decode));
        let is_edge = is_found(edge) && light - dark > 8;
        prop_assert_eq!(samples, if is_edge { 4 + 64 } else { 4 });
    }
}

/// A light of 100 against black: every pixel that it touches is white, however little of it,
/// and the edge is as jagged as with one sample. Clamped, each pixel shows how much of it is
/// covered.
#[test]
fn an_edge_brighter_than_white_is_smooth_if_its_samples_are_clamped() {
    let edges = (-4..=4).map(|i| i as f32 / 10.0);
    let levels = |sampler| -> Vec<i32> {
        let at = |edge| at_edge(sampler, 8, edge, [0.0, 100.0]).0;
        edges.clone().map(at).collect()
    };
    assert!(levels(regular).iter().all(|&level| level == 255));
    let smooth = levels(clamped);
    assert!(smooth.windows(2).all(|pair| pair[0] > pair[1]));
    assert!(smooth[0] > 230 && smooth[8] < 130);
}
