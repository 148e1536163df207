//! In any scene every pixel is finite, nothing panics, and the recursion ends.
//!
//! Ten thousand scenes of spheres that overlap, touch and contain each other, of planes, mirrors and glass,
//! small and large, near and far, with the camera and the lights outside, inside and on the surfaces.

use canvas::{Canvas, View};
use glam::{UVec2, Vec3};
use plane_hit::{Object, Shape, Texture};
use ray_casting::Camera;
use rayon::prelude::*;
use reflection::{MAX_DEPTH, MIN_THROUGHPUT, PathBudget};
use refraction::{Material, Optics};
use shading::Phong;
use shadows::{PointLight, Scene};
use stages::STAGES;
use stages::fuzz::check;
use stages::tracers::{Tracer, budgeted};
use transparency::Absorbing;

/// A million of them, half an hour of one core, are `cargo bench --bench fuzz`.
#[test]
fn every_pixel_of_any_scene_is_finite_and_done_with_in_time() {
    (0..10_000_u32).into_par_iter().for_each(check);
}

/// Returns the number of rays of a single pixel between two mirrors that face each other,
/// without a light.
fn rays_between_mirrors(tracer: Tracer, reflectivity: f32, depth: u32) -> u64 {
    let phong = Phong {
        colour: Texture::Solid(Vec3::ONE),
        ambient: 0.1,
        diffuse: 0.0,
        specular: 0.0,
        shininess: 1,
    };
    let optics = Optics::Opaque { reflectivity };
    let material = Material { phong, optics };
    let wall = |normal: Vec3| Object {
        name: "",
        shape: Shape::plane(-normal, normal),
        material: Absorbing {
            material,
            absorption: Vec3::ZERO,
        },
    };
    let scene = Scene {
        objects: vec![wall(Vec3::Z), wall(Vec3::NEG_Z)],
        lights: vec![],
        background: Vec3::ZERO,
    };
    let camera = Camera::new(Vec3::ZERO, Vec3::Z, Vec3::Y, 1.0).expect("a camera");
    let picture = tracer(&scene, camera, PathBudget::new(depth));
    Canvas::render(&picture, UVec2::ONE).rays
}

/// Nothing is lost between perfect mirrors, and only the depth ends it: one camera ray, and one for each bounce.
#[test]
fn between_perfect_mirrors_the_depth_ends_the_recursion() {
    for (name, tracer) in budgeted() {
        for depth in 0..=MAX_DEPTH {
            let rays = rays_between_mirrors(tracer, 1.0, depth);
            assert_eq!(rays, u64::from(depth) + 1, "{name}");
        }
    }
}

/// Half of the light is left after each bounce: it is followed until no more than
/// `MIN_THROUGHPUT` is left.
#[test]
fn between_half_mirrors_the_throughput_ends_the_recursion() {
    let throughputs =
        std::iter::successors(Some(1.0), |throughput| Some(throughput / 2.0));
    let traced = throughputs.take_while(|&throughput: &f32| throughput > MIN_THROUGHPUT);
    let rays = traced.count() as u64;
    assert!((1..u64::from(MAX_DEPTH)).contains(&rays));
    for (name, tracer) in budgeted() {
        assert_eq!(rays_between_mirrors(tracer, 0.5, MAX_DEPTH), rays, "{name}");
    }
}

/// A floor that slopes, so that no component of anything is zero, hit exactly at the origin of the world,
/// and a light there, or so near that the square of its distance is zero in f32.
#[test]
fn a_light_in_the_very_point_that_is_seen_gives_no_light() {
    let slope = Vec3::new(0.5, 0.7, -0.6);
    let phong = Phong {
        colour: Texture::Solid(Vec3::ONE),
        ambient: 0.1,
        diffuse: 0.8,
        specular: 0.5,
        shininess: 50,
    };
    let optics = Optics::Opaque { reflectivity: 0.0 };
    let floor = Object {
        name: "",
        shape: Shape::plane(Vec3::ZERO, slope),
        material: Absorbing {
            material: Material { phong, optics },
            absorption: Vec3::ZERO,
        },
    };
    for distance in [0.0, 1e-45, 1e-40, 1e-30, 1e-24] {
        let scene = Scene {
            objects: vec![floor.clone()],
            lights: vec![PointLight {
                position: distance * Vec3::new(1.0, 1.0, -1.0),
                intensity: 1.0,
            }],
            background: Vec3::ZERO,
        };
        let eye = 4.0 * Vec3::NEG_Z;
        let camera = Camera::new(eye, Vec3::Z, Vec3::Y, 1.0).expect("a camera");
        for (name, tracer) in budgeted() {
            let picture = tracer(&scene, camera, PathBudget::new(MAX_DEPTH));
            let radiance = Canvas::render(&picture, UVec2::ONE).radiance[0];
            assert_eq!(radiance, Vec3::splat(0.1), "{name}: a light at {distance}");
        }
    }
}

/// Returns settings from one end of a view's knob to the other, about `count` of those to which the
/// knob can be stepped.
fn settings(view: &View, count: usize) -> Vec<f32> {
    let Some(knob) = &view.knob else {
        return vec![view.default_setting()];
    };
    let mut settings = vec![knob.min];
    while let Some(&last) = settings.last() {
        if last == knob.max {
            break;
        }
        settings.push(knob.stepped(last, true));
    }
    let step = settings.len().div_ceil(count);
    settings.into_iter().step_by(step).collect()
}

/// Between the settings that have a picture, too.
#[test]
fn no_view_has_a_pixel_that_is_not_finite_however_its_knob_is_set() {
    for stage in STAGES {
        for view in stage.views {
            for setting in settings(view, 8) {
                let picture = (view.picture)(setting);
                let radiance = Canvas::render(&picture, UVec2::new(40, 30)).radiance;
                let name = stage.picture_name(view, setting);
                assert!(
                    radiance.iter().all(|radiance| radiance.is_finite()),
                    "{name}"
                );
            }
        }
    }
}
