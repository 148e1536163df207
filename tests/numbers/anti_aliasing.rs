use super::*;
use ::anti_aliasing::{STAGE, adaptive, jittered, mean_of_levels, regular};
use ::canvas::{Pixel, encode};
use glam::{DVec2, Vec2};
use std::cell::Cell;

type Sampler = fn(Pixel, u32, &dyn Fn(Vec2) -> Vec3) -> Vec3;

/// A square picture whose pixels have the side 1/32 on the image plane.
const SIZE: UVec2 = UVec2::splat(64);

#[test]
fn the_numbers_are_those_in_the_book() {
    let mut numbers = Numbers::default();
    let pixel = Pixel {
        x: 0,
        y: 0,
        size: SIZE,
    };
    let half =
        |point: Vec2| Vec3::splat(if point.x < pixel.centre().x { 1.0 } else { 0.0 });
    numbers.note("half-light", encode(regular(pixel, 8, &half))[0]);
    numbers.note("half-levels", encode(mean_of_levels(pixel, 8, &half))[0]);
    let samplers: [(&str, Sampler, u32); 5] = [
        ("1", regular, 1),
        ("grid, 2 × 2", regular, 2),
        ("grid, 4 × 4", regular, 4),
        ("jittered, 4 × 4", jittered, 4),
        ("adaptive, 2 × 2 or 8 × 8", adaptive, 8),
    ];
    numbers.note(
        "missed",
        table(samplers.map(|(name, sampler, n)| [name.to_string(), missed(sampler, n)])),
    );
    numbers.note("rays", rays());
    let samplers: [(&str, Sampler, u32); 9] = [
        ("grid, n = 1", regular, 1),
        ("grid, n = 2", regular, 2),
        ("grid, n = 4", regular, 4),
        ("grid, n = 8", regular, 8),
        ("jittered, n = 2", jittered, 2),
        ("jittered, n = 4", jittered, 4),
        ("jittered, n = 8", jittered, 8),
        ("adaptive, n = 4", adaptive, 4),
        ("adaptive, n = 8", adaptive, 8),
    ];
    numbers.note(
        "errors",
        table(samplers.map(|(name, sampler, n)| {
            let [edge_samples, edge] = error(sampler, n, &disc, &disc_coverage);
            let [smooth_samples, smooth] = error(sampler, n, &ramp, &ramp_mean);
            [name.to_string(), edge_samples, edge, smooth_samples, smooth]
        })),
    );
    numbers.check("09-anti-aliasing");
}

fn pixels() -> impl Iterator<Item = Pixel> {
    let row = |y| (0..SIZE.x).map(move |x| Pixel { x, y, size: SIZE });
    (0..SIZE.y).flat_map(row)
}

/// Among pixels that hold a dot of a tenth of their side in radius, the share that shows nothing.
fn missed(sampler: Sampler, n: u32) -> String {
    let pixels: Vec<Pixel> = pixels().collect();
    let missed = pixels.iter().enumerate().filter(|(i, pixel)| {
        // The dot lies anywhere, but wholly within the pixel.
        let [x, y, _] = evenly(*i).map(|x| x as f32 - 0.5);
        let dot = pixel.centre() + 0.8 * pixel.footprint() * Vec2::new(x, y);
        let radius = 0.1 * pixel.footprint();
        let light = |point: Vec2| {
            Vec3::splat(if point.distance(dot) < radius {
                1.0
            } else {
                0.0
            })
        };
        sampler(**pixel, n, &light) == Vec3::ZERO
    });
    percent(missed.count(), pixels.len())
}

/// The rays of the still life at some samplings, and how many times those of one sample a pixel.
fn rays() -> String {
    let view = |name: &str| &STAGE.views[STAGE.find(name).expect("a view")];
    let rays = |name: &str, n: f32| Canvas::paint(&(view(name).picture)(n), SMALL).rays;
    let once = rays("grid", 1.0);
    let settings = [
        ("grid", 1.0),
        ("grid", 4.0),
        ("jittered", 4.0),
        ("adaptive", 4.0),
        ("adaptive", 8.0),
    ];
    table(settings.map(|(name, n)| {
        let rays = rays(name, n);
        let times = rays as f64 / once as f64;
        [
            format!("{name}, n = {n}"),
            rays.to_string(),
            format!("{times:.2}"),
        ]
    }))
}

/// The samples that a pixel took in the mean, and the root mean square error in linear levels.
fn error(
    sampler: Sampler,
    n: u32,
    light: &dyn Fn(Vec2) -> f32,
    exact: &dyn Fn(Pixel) -> f64,
) -> [String; 2] {
    let samples = Cell::new(0_u32);
    let counted = |point| {
        samples.set(samples.get() + 1);
        Vec3::splat(light(point))
    };
    let squares = pixels().map(|pixel| {
        let error = f64::from(sampler(pixel, n, &counted).x) - exact(pixel);
        error * error
    });
    let mean = squares.sum::<f64>() / f64::from(SIZE.element_product());
    let samples = f64::from(samples.get()) / f64::from(SIZE.element_product());
    [format!("{samples:.1}"), three_digits(255.0 * mean.sqrt())]
}

/// A disc with an edge of a few hundred pixels.
const RADIUS: f64 = 0.74;

fn disc(point: Vec2) -> f32 {
    if point.as_dvec2().length() < RADIUS {
        1.0
    } else {
        0.0
    }
}

/// How much of a pixel the disc covers: the exact length in each of 2000 rows of it.
fn disc_coverage(pixel: Pixel) -> f64 {
    const ROWS: u32 = 2000;
    let side = f64::from(pixel.footprint());
    let corner = pixel.centre().as_dvec2() - DVec2::splat(side / 2.0);
    let rows = (0..ROWS).map(|row| {
        let y = corner.y + side * (f64::from(row) + 0.5) / f64::from(ROWS);
        let half = (RADIUS * RADIUS - y * y).max(0.0).sqrt();
        ((corner.x + side).min(half) - corner.x.max(-half)).max(0.0)
    });
    rows.sum::<f64>() / f64::from(ROWS) / side
}

fn ramp(point: Vec2) -> f32 {
    (point.x + 1.0) / 2.0 * (point.y + 1.0) / 2.0
}

/// The mean of the ramp, which is linear in x and in y, is its value in the middle.
fn ramp_mean(pixel: Pixel) -> f64 {
    let DVec2 { x, y } = pixel.centre().as_dvec2();
    (x + 1.0) / 2.0 * (y + 1.0) / 2.0
}
