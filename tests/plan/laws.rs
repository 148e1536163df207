//! It traces no ray that cannot matter, and is within its tolerance of the oracle.

use crate::{PIXELS, SIZE, at_centres, half_a_level};
use ::plan::{DEFAULT_TOLERANCE, Plan, STAGE};
use canvas::{Canvas, Pixel, decode, rays_so_far};
use glam::{DVec2, DVec3, UVec2, Vec2, Vec3};
use harness::{Numbers, percent, table};
use measure::pictures::render;
use measure::random_scenes::ordinary;
use measure::scenes::{Model, SCENES, exact_camera, plain_scene, scene};
use oracle::Limit;
use ray_casting::Camera;
use rayon::prelude::*;
use reflection::PathBudget;
use reflection::scene::facing_mirrors;
use refraction::scene::opaque;
use refraction::{Material, Optics};
use shadows::Scene;
use std::f64::consts::TAU;

/// Returns the rays of a scene with one sample per pixel.
fn rays(scene: &Scene<Material>, camera: Camera) -> usize {
    let plan = Plan::with_black_shadows(scene.clone(), DEFAULT_TOLERANCE);
    Canvas::render(&at_centres(plan, camera), SIZE).rays as usize
}

fn without_lights(mut scene: Scene<Material>) -> Scene<Material> {
    scene.lights.clear();
    scene
}

#[test]
fn there_are_no_shadow_rays_without_lights() {
    for name in ["flat", "floor"] {
        let (scene, camera) = plain_scene(name);
        assert_eq!(rays(&scene, camera), PIXELS, "{name}");
    }
}

/// After their first hit on plastic, all rays are shadow rays.
#[test]
fn no_ray_goes_on_from_a_surface_that_reflects_and_transmits_nothing() {
    let (scene, camera) = plain_scene("plastic");
    let most = PIXELS * (1 + scene.lights.len());
    assert!((PIXELS + 1..=most).contains(&rays(&scene, camera)));
    assert_eq!(rays(&without_lights(scene), camera), PIXELS);
}

/// A single mirror, a ball, sees what reflects nothing.
#[test]
fn a_single_mirror_has_one_bounce() {
    let (scene, camera) = plain_scene("planet");
    let rays = rays(&without_lights(scene), camera);
    assert!((PIXELS + 1..2 * PIXELS).contains(&rays), "{rays}");
}

/// Between two mirrors the throughput is ρⁿ after n bounces. Another ray is traced while ρⁿ
/// times the bound is above the tolerance, which is least for level 1 and greatest for 255:
/// so n is between two logarithms to the base ρ.
#[test]
#[expect(clippy::disallowed_methods, reason = "no pixel depends on it")]
fn the_bounces_are_as_many_as_the_tolerance_asks_for() {
    for reflectivity in [0.5, 0.9, 0.98] {
        let (scene, camera) = facing_mirrors(reflectivity);
        let scene = without_lights(scene.map(opaque));
        let plan = Plan::with_black_shadows(scene, DEFAULT_TOLERANCE);
        let bounces = |level| {
            let tolerance = plan.tolerance * (decode(level) - decode(level - 1));
            let throughput = f64::from(tolerance / plan.max_radiance);
            (throughput.ln() / f64::from(reflectivity).ln()).ceil() as u64
        };
        let (most, least) = (bounces(1), bounces(255));
        let size = UVec2::new(40, 30);
        let counts = Pixel::all(size).map(|pixel| {
            let before = rays_so_far();
            let _ = plan.trace(camera.ray(pixel.centre()));
            rays_so_far() - before - 1
        });
        let deepest = counts.max().expect("pixels");
        assert!(
            (least..=most).contains(&deepest),
            "{least} {deepest} {most}"
        );
    }
}

/// For scenes without glass, in which it is a bound.
#[test]
fn no_ray_is_brighter_than_the_largest_radiance() {
    let deep = PathBudget {
        depth: 1000,
        throughput: 1.0,
        min_throughput: 1e-5,
    };
    for seed in 0..200 {
        let (scene, camera) = ordinary(seed, true);
        let scene = scene.map(|absorbing| Material {
            optics: match absorbing.material.optics {
                Optics::Dielectric { .. } => Optics::Opaque { reflectivity: 0.9 },
                opaque => opaque,
            },
            ..absorbing.material
        });
        let bound = Plan::with_black_shadows(scene.clone(), DEFAULT_TOLERANCE);
        let canvas = render(&Model::Plain(scene), camera, UVec2::new(40, 30), deep);
        let brightest = canvas
            .radiance
            .iter()
            .map(|radiance| radiance.max_element());
        let brightest = brightest.max_by(f32::total_cmp).expect("pixels");
        assert!(brightest <= bound.max_radiance, "seed {seed}: {brightest}");
    }
}

/// Two mirrors of reflectivity ½ and radiance 1 and ½: (1 + ½ · ½) / (1 − ½ · ½) = 5/3.
#[test]
fn the_largest_radiance_is_that_between_the_two_brightest() {
    let (scene, _) = facing_mirrors(0.5);
    let mut scene = without_lights(scene.map(opaque));
    scene.background = Vec3::ZERO;
    for (object, ambient) in scene.objects.iter_mut().zip([0.0, 1.0, 0.5, 0.0]) {
        object.material.phong.ambient = ambient;
        object.material.phong.colour = plane_hit::Texture::Solid(Vec3::ONE);
    }
    let plan = Plan::with_black_shadows(scene, DEFAULT_TOLERANCE);
    assert!((plan.max_radiance - 5.0 / 3.0).abs() < 1e-6);
}

/// Rays at the end of their plan are dark, however many there are: the radiance is never
/// more than the tolerance below that of rays that are followed to the end, nor above it.
#[test]
fn mirrors_are_within_the_tolerance() {
    let deep = PathBudget {
        depth: 2000,
        throughput: 1.0,
        min_throughput: 1e-7,
    };
    for tolerance in [0.5, 2.0, 8.0] {
        let (scene, camera) = facing_mirrors(0.9);
        let scene = scene.map(opaque);
        let exact = render(&Model::Plain(scene.clone()), camera, SIZE, deep);
        let plan = Plan::with_black_shadows(scene, tolerance);
        let ours = Canvas::render(&at_centres(plan, camera), SIZE);
        for (ours, exact) in ours.radiance.iter().zip(&exact.radiance) {
            let levels = |radiance: &Vec3| radiance.as_dvec3().map(oracle::level);
            let missing = levels(exact) - levels(ours);
            let within = missing.min_element() > -1e-3
                && missing.max_element() <= f64::from(tolerance) * 1.001;
            assert!(within, "{missing} at a tolerance of {tolerance}");
        }
    }
}

/// A pixel whose probe samples agree takes these eight; otherwise at least 32 inside it, and
/// no more than 1,024.
#[test]
fn a_pixel_takes_eight_samples_or_32_to_1024() {
    let (model, _) = scene("flat");
    let plan = half_a_level(&model);
    let pixel = Pixel {
        x: 3,
        y: 4,
        size: UVec2::new(10, 8),
    };
    let samples_of = |sample: &dyn Fn(Vec2) -> ::plan::Sample| {
        let count = std::cell::Cell::new(0);
        let radiance = plan.sample_pixel(pixel, &|point| {
            count.set(count.get() + 1);
            canvas::count_ray();
            sample(point)
        });
        (radiance, count.get())
    };
    let of = |radiance: f32, signature| ::plan::Sample {
        radiance: Vec3::splat(radiance),
        signature,
    };
    assert_eq!(samples_of(&|_| of(0.5, 1)), (Vec3::splat(0.5), 8));
    // Of one colour, but of two objects: 32 samples replace the corners.
    let centre = pixel.centre();
    let halves = |point: Vec2| of(0.5, u32::from(point.x > centre.x));
    assert_eq!(samples_of(&halves), (Vec3::splat(0.5), 4 + 32));
    // Black and white: half of each, and as many samples as it takes.
    let edge = |point: Vec2| of(f32::from(point.x > centre.x), 1);
    let (radiance, samples) = samples_of(&edge);
    assert_eq!((radiance.x * 100.0).round(), 50.0);
    assert!((4 + 64..=4 + 1024).contains(&samples), "{samples}");
}

/// The limit of the oracle's rays: its error is far below half a level.
const DEEP: Limit = Limit {
    bounces: 1000,
    min_throughput: 1e-5,
};

/// The pixels of a picture with one sample each that are off by more than half a level.
#[derive(Clone, Copy, Default)]
struct Off {
    /// Those that the oracle itself sees differently a ten-thousandth of a pixel aside.
    at_an_edge: usize,
    /// All others.
    elsewhere: usize,
}

fn off(model: &Model, camera: Camera) -> Off {
    let ours = Canvas::render(&at_centres(half_a_level(model), camera), SIZE);
    let (scene, camera) = (model.exactly(), exact_camera(&camera));
    let levels = |at: DVec2| {
        let ray = camera.ray(at, SIZE.to_array());
        oracle::trace(&scene, &ray, DEEP).map(oracle::level)
    };
    let differ = |a: DVec3, b: DVec3| (a - b).abs().max_element() > 0.5;
    let centres: Vec<DVec2> = oracle::pixel_centres(SIZE.to_array()).collect();
    let pixels = ours.radiance.par_iter().zip(centres);
    let is_at_an_edge = pixels.filter_map(|(radiance, at)| {
        let exact = levels(at);
        let is_off = differ(radiance.as_dvec3().map(oracle::level), exact);
        is_off.then(|| {
            let mut angles = (0..32).map(|i| TAU * f64::from(i) / 32.0);
            angles
                .any(|angle| differ(levels(at + 1e-4 * DVec2::from_angle(angle)), exact))
        })
    });
    let is_at_an_edge: Vec<bool> = is_at_an_edge.collect();
    let at_an_edge = is_at_an_edge.iter().filter(|&&is| is).count();
    Off {
        at_an_edge,
        elsewhere: is_at_an_edge.len() - at_an_edge,
    }
}

/// A thousandth of the pixels.
const BOUND: usize = PIXELS / 1000;

#[test]
fn every_scene_of_the_book_is_within_half_a_level_of_the_oracle() {
    let rows = SCENES.map(|scene| {
        let (model, camera) = (scene.make)();
        let off = off(&model, camera);
        assert!(off.elsewhere <= BOUND, "{}: {}", scene.name, off.elsewhere);
        let [edge, elsewhere] =
            [off.at_an_edge, off.elsewhere].map(|off| percent(off, PIXELS));
        [scene.name.to_string(), edge, elsewhere]
    });
    let mut numbers = Numbers::default();
    numbers.note("scenes", table(rows));
    numbers.check(&format!("{}-tracing", STAGE.name));
}

#[test]
fn two_hundred_random_scenes_are_within_half_a_level_of_the_oracle() {
    let offs = (0..200).map(|seed| {
        let (scene, camera) = ordinary(seed, true);
        let model = if seed % 2 == 0 {
            Model::Absorbing(scene)
        } else {
            Model::Plain(scene.map(|absorbing| absorbing.material))
        };
        let off = off(&model, camera);
        assert!(off.elsewhere <= BOUND, "seed {seed}: {}", off.elsewhere);
        off
    });
    let offs: Vec<Off> = offs.collect();
    let all = offs.len() * PIXELS;
    let edge = offs.iter().map(|off| off.at_an_edge).sum();
    let elsewhere = offs.iter().map(|off| off.elsewhere).sum();
    let worst = offs.iter().map(|off| off.elsewhere).max();
    let mut numbers = Numbers::default();
    numbers.note("edge", percent(edge, all));
    numbers.note("elsewhere", percent(elsewhere, all));
    numbers.note("worst", percent(worst.expect("scenes"), PIXELS));
    numbers.check(&format!("{}-random", STAGE.name));
}
