//! The numbers that the chapter's page quotes. They guard the page, not the truth: the code
//! under test has written them.

use ::anti_aliasing::scene::horizon_camera;
use ::anti_aliasing::{
    STAGE, Sampler, adaptive, clamped, jittered, mean_of_levels, regular,
};
use canvas::{Pixel, encode};
use fresnel::{fresnel, trace};
use glam::{UVec2, Vec2, Vec3};
use harness::{
    Numbers, SMALL, evenly, percent, render_at, table, three_digits, triple, vector,
    with_separators,
};
use ray_casting::Camera;
use ray_casting::scene::still_life_camera;
use reflection::{MAX_DEPTH, PathBudget};
use refraction::scene::{AIR, GLASS, still_life_with_glass};

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
        ("regular, 1 × 1", regular, 1),
        ("regular, 2 × 2", regular, 2),
        ("regular, 4 × 4", regular, 4),
        ("jittered, 4 × 4", jittered, 4),
        ("adaptive, 2 × 2 or 8 × 8", adaptive, 8),
    ];
    numbers.note(
        "missed",
        table(samplers.map(|(name, sampler, n)| [name.to_string(), missed(sampler, n)])),
    );
    numbers.note("rays", rays());
    numbers.note(
        "cameras",
        table([
            row("the still life's", still_life_camera()),
            row("the horizon's", horizon_camera()),
        ]),
    );
    for (name, light) in [("black", 0.0), ("half", 0.5)] {
        let [from, to] = [light, light + 0.05].map(|light| encode(Vec3::splat(light))[0]);
        numbers.note(&format!("twentieth-of-{name}"), to - from);
    }
    let [differing, worst, lost] = cost_of_clamping();
    numbers.note("clamped-differing", differing);
    numbers.note("clamped-worst", worst);
    numbers.note("clamped-lost", lost);
    numbers.check(STAGE.name);
}

/// Returns a camera's name, eye, direction and focal length.
fn row(name: &str, camera: Camera) -> [String; 4] {
    [
        name.to_string(),
        triple(camera.eye),
        vector(&camera.forward.to_array()),
        three_digits(camera.focal_length.into()),
    ]
}

/// Returns the fraction of pixels that are black although they hold a white dot with a radius
/// of a tenth of their side.
fn missed(sampler: Sampler, n: u32) -> String {
    let missed = Pixel::all(SIZE).enumerate().filter(|&(i, pixel)| {
        // The dot lies anywhere, but wholly within the pixel.
        let [x, y, _] = evenly(i).map(|x| x as f32 - 0.5);
        let dot = pixel.centre() + 0.8 * pixel.footprint() * Vec2::new(x, y);
        let radius = 0.1 * pixel.footprint();
        let radiance = |point: Vec2| {
            Vec3::splat(if point.distance(dot) < radius {
                1.0
            } else {
                0.0
            })
        };
        sampler(pixel, n, &radiance) == Vec3::ZERO
    });
    percent(missed.count(), (SIZE.x * SIZE.y) as usize)
}

/// Returns the cost of clamping on the still life by 4 × 4 samples: the fraction of the pixels
/// whose levels differ, the largest difference in levels, and the fraction of a pixel's light
/// that is lost where most is.
fn cost_of_clamping() -> [String; 3] {
    let scene = still_life_with_glass(GLASS, AIR);
    let camera = still_life_camera();
    let budget = PathBudget::new(MAX_DEPTH);
    let radiance = |point| trace(&scene, &camera.ray(point), budget, fresnel);
    let pairs = Pixel::all(SMALL).map(|pixel| {
        [regular, clamped].map(|sampler: Sampler| sampler(pixel, 4, &radiance))
    });
    let (mut differing, mut worst, mut lost) = (0, 0, 0.0_f64);
    for [mean, clamped] in pairs {
        let [a, b] = [mean, clamped].map(encode);
        let difference = (0..3).map(|i| a[i].abs_diff(b[i])).max().unwrap_or(0);
        differing += usize::from(difference > 0);
        worst = worst.max(difference);
        lost = lost.max(1.0 - f64::from(clamped.element_sum() / mean.element_sum()));
    }
    let pixels = (SMALL.x * SMALL.y) as usize;
    [
        percent(differing, pixels),
        worst.to_string(),
        format!("{:.0} %", 100.0 * lost),
    ]
}

/// Returns the rays of the still life by some samplers, and how many times those of one sample
/// per pixel they are.
fn rays() -> String {
    let rays = |view, n| render_at(&STAGE, view, n, SMALL).rays;
    let once = rays("grid", 1.0);
    let settings = [
        ("regular", "grid", 1.0),
        ("regular", "grid", 4.0),
        ("jittered", "jittered", 4.0),
        ("adaptive", "adaptive", 4.0),
        ("adaptive", "adaptive", 8.0),
    ];
    table(settings.map(|(sampler, view, n)| {
        let rays = rays(view, n);
        let times = rays as f64 / once as f64;
        [
            format!("{sampler}, n = {n}"),
            with_separators(rays),
            format!("{times:.2}"),
        ]
    }))
}
