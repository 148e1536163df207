//! Our pictures against POV-Ray's of the same model, by an independent renderer in f64: the still life with
//! its ball of glass, and bodies of glass half in the water.
//!
//! `tests/povray` holds its scenes, its pictures and the script that made them.

use crate::{HERO, Numbers, percent, three_digits};
use canvas::{Canvas, Picture};
use glam::DVec3;
use std::path::Path;

/// Returns POV-Ray's picture of a name in linear levels, 1/255 of full light.
fn theirs(name: &str) -> Vec<DVec3> {
    let path = format!("../povray/{name}.png");
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join(path);
    let picture = image::open(path).expect("POV-Ray's picture").into_rgb16();
    let levels =
        |pixel: &image::Rgb<u16>| pixel.0.map(|sample| f64::from(sample) / 257.0);
    picture.pixels().map(|pixel| levels(pixel).into()).collect()
}

/// Returns the mean difference of our radiance from POV-Ray's picture of a name, and the part of the
/// pixels that are more than one level apart, both as the book prints them.
///
/// # Panics
/// If the mean difference is more than `max_mean` linear levels, or if more than `max_fraction` of the pixels are
/// apart.
fn difference(
    name: &str,
    ours: &[DVec3],
    [max_mean, max_fraction]: [f64; 2],
) -> [String; 2] {
    let theirs = theirs(name);
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
    let fraction = percent(apart, differences.len());
    assert!(
        mean <= max_mean && apart as f64 <= max_fraction * pixels,
        "{name}: a mean difference of {mean} level, and {fraction} of the pixels apart"
    );
    [format!("{} level", three_digits(mean)), fraction]
}

/// Compares pictures, which `ours` returns for a number of bounces, with POV-Ray's.
///
/// The rays must be followed at any throughput, and rays beyond the last bounce must be
/// black. The differences are at edges and next to the horizon: 0.05 linear level in the
/// mean, and more than one level in 0.25 % of the pixels at most. With a constant in place
/// of Fresnel's reflectance the mean is 0.26, with the half vector in place of Phong's
/// mirror direction 0.39.
///
/// # Panics
/// If the pictures differ by more.
pub fn assert_picture(name: &str, ours: impl Fn(u32) -> Picture) {
    assert_radiance(name, [0.05, 0.0025], |bounces| {
        let radiance = Canvas::render(&ours(bounces), HERO).radiance;
        radiance
            .iter()
            .map(|radiance| radiance.as_dvec3())
            .collect()
    });
}

/// Compares the radiance of an 800 × 600 picture's pixels, which `ours` returns for a number
/// of bounces, with POV-Ray's.
///
/// # Panics
/// If the mean difference is more than the first of `max`, in linear levels, or if more than the second, a
/// fraction of the pixels, are more than one level apart.
pub fn assert_radiance(name: &str, max: [f64; 2], ours: impl Fn(u32) -> Vec<DVec3>) {
    // Its depths include the camera ray.
    let rows = [6, 12].map(|depth| {
        let ours = ours(depth - 1);
        let [mean, fraction] = difference(&format!("depth-{depth}"), &ours, max);
        format!("| {depth} | {mean} | {fraction} |")
    });
    let mut numbers = Numbers::default();
    numbers.note("povray", rows.join("\n"));
    numbers.check(&format!("{name}-povray"));
}

/// Compares the radiance of a 320 × 240 picture of bodies in the water, whose rays are followed as far as they can be
/// seen, with POV-Ray's.
///
/// # Panics
/// As [`assert_radiance`] does.
pub fn assert_water(name: &str, max: [f64; 2], ours: &[DVec3]) {
    let [mean, fraction] = difference("water", ours, max);
    let mut numbers = Numbers::default();
    numbers.note("water", format!("| {mean} | {fraction} |"));
    numbers.check(&format!("{name}-povray-water"));
}
