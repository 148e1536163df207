//! The finished still life against POV-Ray's: the same model by a renderer that others wrote, in f64.
//!
//! `tests/povray` holds its scene, its pictures and the script that made them.

mod numbers_file;

use canvas::{Canvas, Picture};
use glam::{DVec3, UVec2};
use numbers_file::{Numbers, percent, three_digits};
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

/// A chapter's picture, `ours` by rays of some reach.
fn assert_agreement(chapter: &str, ours: fn(Reach) -> Picture) {
    assert_light(chapter, [0.05, 0.0025], |depth| {
        let canvas = Canvas::paint(&ours(reach(depth)), UVec2::new(800, 600));
        canvas.light.iter().map(|light| light.as_dvec3()).collect()
    });
}

/// At depth 6 and 12, the mean difference is at most some linear level, and at most a share of the pixels
/// is more than one level apart.
///
/// For a chapter, 0.05 and 0.25 %: edges, and the horizon. A constant in place of Fresnel's share is .26
/// apart in the mean, a half vector .39.
fn assert_light(name: &str, [least, few]: [f64; 2], ours: impl Fn(u32) -> Vec<DVec3>) {
    let rows = [6, 12].map(|depth| {
        let (ours, theirs) = (ours(depth), theirs(depth));
        assert_eq!(ours.len(), theirs.len());
        let differences = ours.iter().zip(&theirs).map(|(ours, theirs)| {
            // A file holds nothing brighter than white.
            let ours = 255.0 * ours.clamp(DVec3::ZERO, DVec3::ONE);
            (ours - theirs).abs()
        });
        let differences: Vec<DVec3> = differences.collect();
        let pixels = differences.len() as f64;
        let mean = differences.iter().sum::<DVec3>().element_sum() / (3.0 * pixels);
        let apart = differences
            .iter()
            .filter(|levels| levels.max_element() > 1.0);
        let apart = apart.count();
        assert!(
            mean <= least,
            "a mean difference of {mean} level at depth {depth}"
        );
        let share = percent(apart, differences.len());
        assert!(
            apart as f64 <= few * pixels,
            "{share} of the pixels at depth {depth}"
        );
        format!("| {depth} | {} level | {share} |", three_digits(mean))
    });
    let mut numbers = Numbers::default();
    numbers.note("povray", rows.join("\n"));
    numbers.check(&format!("{name}-povray"));
}

mod fresnel {
    use super::*;
    use ::fresnel::{STAGE, fresnel, trace};

    #[test]
    fn the_still_life_is_the_one_that_povray_sees() {
        super::assert_agreement(STAGE.name, |reach| {
            let camera = still_life_camera(STILL_LIFE_FOCAL_LENGTH);
            let scene = still_life_with_glass(GLASS, AIR);
            Picture::new(move |pixel| {
                trace(&scene, &camera.ray(pixel.centre()), reach, fresnel)
            })
        });
    }
}

mod shadow_acne {
    use super::*;
    use ::shadow_acne::{STAGE, from_the_eye, from_the_surface, trace};

    #[test]
    fn the_still_life_without_an_offset_is_the_one_that_povray_sees() {
        super::assert_agreement(STAGE.name, |reach| {
            let camera = still_life_camera(STILL_LIFE_FOCAL_LENGTH);
            let scene = still_life_with_glass(GLASS, AIR);
            Picture::new(move |pixel| {
                let leaving = from_the_eye(camera.ray(pixel.centre()));
                trace(&scene, leaving, reach, from_the_surface)
            })
        });
    }
}

mod oracle {
    use super::*;
    use ::oracle::{
        Glass, Limit, pixel_centres, still_life_camera, still_life_with_glass, trace,
    };
    use rayon::prelude::*;

    /// Two renderers in f64 differ by the last bit of a 16-bit file, but at the horizon, where POV-Ray takes
    /// the floor to end.
    #[test]
    fn the_still_life_of_the_oracle_is_the_one_that_povray_sees() {
        let camera = still_life_camera();
        let scene = still_life_with_glass(Glass::Mirrors);
        assert_light("oracle", [0.002, 5e-5], |depth| {
            let limit = Limit {
                bounces: depth - 1,
                share: 0.0,
            };
            let size = [800, 600];
            let centres: Vec<_> = pixel_centres(size).collect();
            let see = |&at| trace(&scene, &camera.ray(at, size), limit);
            centres.par_iter().map(see).collect()
        });
    }
}
