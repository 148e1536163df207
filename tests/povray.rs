//! The finished still life against POV-Ray's: the same model by a renderer that others wrote, in f64.
//!
//! `tests/povray` holds its scene, its pictures and the script that made them.

use canvas::{Canvas, Picture};
use glam::{DVec3, UVec2};
use ray_casting::views::{STILL_LIFE_FOCAL_LENGTH, still_life_camera};
use reflection::Reach;
use refraction::views::{AIR, GLASS, still_life_with_glass};
use std::path::Path;

/// POV-Ray's picture in linear levels, 1/255 of full light.
fn theirs(depth: u32) -> Vec<DVec3> {
    let path = format!("tests/povray/depth-{depth}.png");
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join(path);
    let picture = image::open(path).expect("POV-Ray's picture").into_rgb16();
    let levels =
        |pixel: &image::Rgb<u16>| pixel.0.map(|sample| f64::from(sample) / 257.0);
    picture.pixels().map(|pixel| levels(pixel).into()).collect()
}

/// Every ray that brings anything, and black past the depth, of which POV-Ray counts the camera ray.
fn reach(depth: u32) -> Reach {
    Reach {
        depth: depth - 1,
        weight: 1.0,
        least_weight: 0.0,
    }
}

/// The mean difference is at most 0.05 linear level, and at most 0.25 % of the pixels are more than
/// one level apart: edges, and the horizon. A glass without Fresnel is .26 apart, a half vector .39.
fn assert_agreement(ours: &Picture, depth: u32) {
    let canvas = Canvas::paint(ours, UVec2::new(800, 600));
    let theirs = theirs(depth);
    assert_eq!(canvas.light.len(), theirs.len());
    let differences = canvas.light.iter().zip(&theirs).map(|(ours, theirs)| {
        // A file holds nothing brighter than white.
        let ours = 255.0 * ours.as_dvec3().clamp(DVec3::ZERO, DVec3::ONE);
        (ours - theirs).abs()
    });
    let differences: Vec<DVec3> = differences.collect();
    let pixels = differences.len() as f64;
    let mean = differences
        .iter()
        .map(|levels| levels.element_sum() / 3.0)
        .sum::<f64>()
        / pixels;
    let apart = differences
        .iter()
        .filter(|levels| levels.max_element() > 1.0);
    let apart = apart.count() as f64 / pixels;
    println!(
        "depth {depth}: mean {mean:.4} level, {:.4} % more than one apart",
        100.0 * apart
    );
    assert!(
        mean <= 0.05,
        "mean difference at depth {depth}: {mean} level"
    );
    assert!(
        apart <= 0.0025,
        "{} % of the pixels at depth {depth}",
        100.0 * apart
    );
}

mod fresnel {
    use super::*;
    use ::fresnel::{fresnel, trace};

    #[test]
    fn the_still_life_is_the_one_that_povray_sees() {
        for depth in [6, 12] {
            let camera = still_life_camera(STILL_LIFE_FOCAL_LENGTH);
            let scene = still_life_with_glass(GLASS, AIR);
            let ours = Picture::new(move |pixel| {
                trace(&scene, &camera.ray(pixel.centre()), reach(depth), fresnel)
            });
            assert_agreement(&ours, depth);
        }
    }
}
