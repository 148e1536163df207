//! Errors and costs as colours, pixel by pixel.

use canvas::{Picture, decode, rays_so_far};
use glam::{DVec3, Vec3};

// ANCHOR: error-map
/// Returns the error of a radiance in levels, not rounded: that of its worst channel.
pub fn level_error(ours: Vec3, exact: DVec3) -> f64 {
    let levels = |radiance: DVec3| radiance.map(oracle::level);
    (levels(ours.as_dvec3()) - levels(exact))
        .abs()
        .max_element()
}

/// Returns the map of a picture's errors: black below 10⁻⁵ of a level, a brighter colour for
/// each ten times as much, and the brightest from ten levels on.
pub fn error_map(ours: Picture, exact: Picture) -> Picture {
    const LEVELS: [f64; 7] = [1e-5, 1e-4, 1e-3, 1e-2, 0.1, 1.0, 10.0];
    Picture::from_spans(move |first, span| {
        let mut right = vec![Vec3::ZERO; span.len()];
        exact.render_span(first, &mut right);
        ours.render_span(first, span);
        for (out, right) in span.iter_mut().zip(right) {
            let error = level_error(*out, right.as_dvec3());
            *out = heat(LEVELS.iter().filter(|&&levels| error >= levels).count());
        }
    })
}

/// Returns the map of a picture's rays: black for one, a brighter colour for each twice as
/// many, and the brightest from 128 on.
pub fn cost_map(picture: Picture) -> Picture {
    Picture::new(move |pixel| {
        let before = rays_so_far();
        let _ = picture.radiance(pixel);
        let rays = rays_so_far() - before;
        heat(rays.checked_ilog2().unwrap_or(0) as usize)
    })
}
// ANCHOR_END: error-map

/// Returns one of eight colours, black for 0, that are told apart by their brightness, too.
///
/// Source: matplotlib's "inferno", by Nathaniel Smith and Stéfan van der Walt.
fn heat(step: usize) -> Vec3 {
    const COLOURS: [[u8; 3]; 8] = [
        [0, 0, 4],
        [40, 11, 84],
        [101, 21, 110],
        [159, 42, 99],
        [212, 72, 66],
        [245, 125, 21],
        [250, 193, 39],
        [252, 255, 164],
    ];
    Vec3::from_array(COLOURS[step.min(7)].map(decode))
}
