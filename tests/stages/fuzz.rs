//! In any scene every pixel is finite, nothing panics, and the recursion ends.
//!
//! Ten thousand scenes of spheres that overlap, touch and contain each other, of planes, mirrors and glass,
//! small and large, near and far, with the camera and the lights outside, inside and on the surfaces.

use canvas::{Canvas, Picture, View};
use fresnel::fresnel;
use glam::{UVec2, Vec3};
use measure::random_scenes::extreme;
use plane_hit::{Object, Shape, Texture};
use ray_casting::Camera;
use rayon::prelude::*;
use reflection::{MAX_DEPTH, MIN_THROUGHPUT, Mirror, PathBudget};
use refraction::{Material, Optics, refract_or_reflect};
use shading::Phong;
use shadow_acne::{
    SpawnRay, from_eye, from_surface, with_fixed_offset, with_scaled_offset,
    without_offset,
};
use shadows::{PointLight, Scene};
use stages::STAGES;
use transparency::Absorbing;

const SIZE: UVec2 = UVec2::new(8, 6);

/// A chapter's picture of a scene.
type Chapter = fn(&Scene<Absorbing>, Camera, PathBudget) -> Picture;

fn reflection(scene: &Scene<Absorbing>, camera: Camera, budget: PathBudget) -> Picture {
    let scene = scene.clone().map(|Absorbing { material, .. }| Mirror {
        phong: material.phong,
        reflectivity: match material.optics {
            Optics::Opaque { reflectivity } => reflectivity,
            Optics::Dielectric { .. } => 1.0,
        },
    });
    Picture::new(move |pixel| {
        ::reflection::trace(&scene, &camera.ray(pixel.centre()), budget)
    })
}

fn refraction(scene: &Scene<Absorbing>, camera: Camera, budget: PathBudget) -> Picture {
    let scene = scene.clone().map(|absorbing| absorbing.material);
    Picture::new(move |pixel| {
        let ray = camera.ray(pixel.centre());
        ::refraction::trace(&scene, &ray, budget, refract_or_reflect)
    })
}

fn with_fresnel(scene: &Scene<Absorbing>, camera: Camera, budget: PathBudget) -> Picture {
    let scene = scene.clone().map(|absorbing| absorbing.material);
    Picture::new(move |pixel| {
        ::fresnel::trace(&scene, &camera.ray(pixel.centre()), budget, fresnel)
    })
}

fn spawned_by(
    spawn: SpawnRay,
    scene: &Scene<Absorbing>,
    camera: Camera,
    budget: PathBudget,
) -> Picture {
    let scene = scene.clone().map(|absorbing| absorbing.material);
    Picture::new(move |pixel| {
        let ray = from_eye(&scene.objects, camera.ray(pixel.centre()));
        ::shadow_acne::trace(&scene, &ray, budget, spawn)
    })
}

fn transparency(scene: &Scene<Absorbing>, camera: Camera, budget: PathBudget) -> Picture {
    let scene = scene.clone();
    Picture::new(move |pixel| {
        ::transparency::trace(
            &scene,
            &from_eye(&scene.objects, camera.ray(pixel.centre())),
            budget,
            ::transparency::between_media,
        )
    })
}

/// The chapters whose rays never branch.
const UNBRANCHED: [(&str, Chapter); 2] =
    [("reflection", reflection), ("refraction", refraction)];

/// The chapters whose rays branch at an interface: the two that are right at any size, and others, which take
/// turns.
const BRANCHED: [(&str, Chapter); 6] = [
    ("from surface", |scene, camera, budget| {
        spawned_by(from_surface, scene, camera, budget)
    }),
    ("transparency", transparency),
    ("fresnel", with_fresnel),
    ("without offset", |scene, camera, budget| {
        spawned_by(without_offset, scene, camera, budget)
    }),
    ("fixed offset", |scene, camera, budget| {
        spawned_by(with_fixed_offset, scene, camera, budget)
    }),
    ("scaled offset", |scene, camera, budget| {
        spawned_by(with_scaled_offset, scene, camera, budget)
    }),
];

/// At most a camera ray and `MAX_DEPTH` more where rays never branch. Where they do, the throughputs of one pixel's
/// rays at any depth add up to 1 at most, and each is more than `MIN_THROUGHPUT`: fewer than 2048 of them. From
/// every hit there is one more ray to each light.
#[test]
fn every_pixel_of_any_scene_is_finite_and_done_with_in_time() {
    let depth = u64::from(MAX_DEPTH);
    let widest = (1.0 / MIN_THROUGHPUT) as u64;
    (0..10_000_u32).into_par_iter().for_each(|seed| {
        let (scene, camera) = extreme(seed);
        let check = |(name, chapter): (&str, Chapter), most: u64| {
            let picture = chapter(&scene, camera, PathBudget::new(MAX_DEPTH));
            let canvas = Canvas::render(&picture, SIZE);
            let is_finite = canvas.radiance.iter().all(|radiance| radiance.is_finite());
            assert!(is_finite, "{name}, scene {seed}");
            let pixels = u64::from(SIZE.x * SIZE.y);
            let most = most * pixels * (1 + scene.lights.len() as u64);
            assert!(canvas.rays <= most, "{name}, scene {seed}: {}", canvas.rays);
        };
        for chapter in UNBRANCHED {
            check(chapter, 1 + depth);
        }
        let other = BRANCHED[2 + seed as usize % 4];
        for chapter in [BRANCHED[0], BRANCHED[1], other] {
            check(chapter, 1 + depth * widest);
        }
    });
}

/// All chapters that follow rays.
fn chapters() -> impl Iterator<Item = (&'static str, Chapter)> {
    UNBRANCHED.into_iter().chain(BRANCHED)
}

/// Returns the number of rays of a single pixel between two mirrors that face each other,
/// without a light.
fn rays_between_mirrors(chapter: Chapter, reflectivity: f32, depth: u32) -> u64 {
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
    let picture = chapter(&scene, camera, PathBudget::new(depth));
    Canvas::render(&picture, UVec2::ONE).rays
}

/// Nothing is lost between perfect mirrors, and only the depth ends it: one camera ray, and one for each bounce.
#[test]
fn between_perfect_mirrors_the_depth_ends_the_recursion() {
    for (name, chapter) in chapters() {
        for depth in 0..=MAX_DEPTH {
            let rays = rays_between_mirrors(chapter, 1.0, depth);
            assert_eq!(rays, u64::from(depth) + 1, "{name}");
        }
    }
}

/// Of half the light at each bounce 2⁻¹⁰ are left after ten: more than `MIN_THROUGHPUT`, which 2⁻¹¹ is not.
#[test]
fn between_half_mirrors_the_throughput_ends_the_recursion() {
    for (name, chapter) in chapters() {
        assert_eq!(rays_between_mirrors(chapter, 0.5, MAX_DEPTH), 11, "{name}");
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
        for (name, chapter) in chapters() {
            let picture = chapter(&scene, camera, PathBudget::new(MAX_DEPTH));
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
