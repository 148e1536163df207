//! Every way in which the chapters trace a scene, for tests and benches of them all.

use canvas::Picture;
use fresnel::fresnel;
use plan::{DEFAULT_TOLERANCE, Plan};
use ray_casting::Camera;
use reflection::{Mirror, PathBudget};
use refraction::{Material, Optics, refract_or_reflect};
use shading::Phong;
use shadow_acne::{
    SpawnRay, from_eye, from_surface, with_fixed_offset, with_scaled_offset,
    without_offset,
};
use shadows::{Scene, is_visible};
use transparency::{Absorbing, between_media};

/// Returns the picture of a scene, of one ray per pixel, as a chapter traces it: of each
/// material it takes what it knows.
pub type Tracer = fn(&Scene<Absorbing>, Camera, PathBudget) -> Picture;

/// The chapters that follow no ray beyond its first hit, but for shadow rays; they ignore the
/// budget.
pub const FIRST_HIT: [(&str, Tracer); 3] = [
    ("plane hit", |scene, camera, _| {
        let objects = scene.clone().map(|material| phong(material).colour).objects;
        Picture::new(move |pixel| plane_hit::trace(&objects, &camera.ray(pixel.centre())))
    }),
    ("shadows", |scene, camera, _| {
        let scene = scene.clone().map(|material| phong(material).colour);
        Picture::new(move |pixel| {
            shadows::trace(&scene, &camera.ray(pixel.centre()), is_visible)
        })
    }),
    ("shading", |scene, camera, _| {
        let scene = scene.clone().map(phong);
        Picture::new(move |pixel| shading::trace(&scene, &camera.ray(pixel.centre())))
    }),
];

/// The chapters whose rays never branch.
pub const UNBRANCHED: [(&str, Tracer); 2] = [
    ("reflection", |scene, camera, budget| {
        let scene = scene.clone().map(|Absorbing { material, .. }| Mirror {
            phong: material.phong,
            reflectivity: match material.optics {
                Optics::Opaque { reflectivity } => reflectivity,
                Optics::Dielectric { .. } => 1.0,
            },
        });
        Picture::new(move |pixel| {
            reflection::trace(&scene, &camera.ray(pixel.centre()), budget)
        })
    }),
    ("refraction", |scene, camera, budget| {
        let scene = scene.clone().map(unabsorbing);
        Picture::new(move |pixel| {
            let ray = camera.ray(pixel.centre());
            refraction::trace(&scene, &ray, budget, refract_or_reflect)
        })
    }),
];

/// The chapters whose rays branch at an interface and start where they should, at any size:
/// one by one, explained, sixteen at once, and with absorption.
pub const BRANCHED: [(&str, Tracer); 4] = [
    ("from surface", |scene, camera, budget| {
        spawned_by(from_surface, scene, camera, budget)
    }),
    ("explanation", |scene, camera, budget| {
        let scene = scene.clone().map(unabsorbing);
        Picture::new(move |pixel| {
            interactive::explain::explain(&scene, &camera, pixel.centre(), budget)
                .radiance
        })
    }),
    ("packets", |scene, camera, budget| {
        let scene = scene.clone().map(unabsorbing);
        Picture::from_spans(move |first, span| {
            packets::render(&scene, &camera, budget, 1, first, span);
        })
    }),
    ("transparency", |scene, camera, budget| {
        let scene = scene.clone();
        Picture::new(move |pixel| {
            let ray = from_eye(&scene.objects, camera.eye)(camera.ray(pixel.centre()));
            transparency::trace(&scene, &ray, budget, between_media)
        })
    }),
];

/// The chapters whose rays branch, and start where an offset puts them.
pub const OFFSET: [(&str, Tracer); 4] = [
    ("fresnel", |scene, camera, budget| {
        let scene = scene.clone().map(unabsorbing);
        Picture::new(move |pixel| {
            fresnel::trace(&scene, &camera.ray(pixel.centre()), budget, fresnel)
        })
    }),
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

/// The chapter that takes its budget from a plan.
pub const PLANNED: (&str, Tracer) = ("plan", |scene, camera, _| {
    let plan = Plan::new(scene.clone(), DEFAULT_TOLERANCE);
    Picture::new(move |pixel| plan.trace(camera.ray(pixel.centre())).radiance)
});

/// Returns all ways that keep to a budget.
pub fn budgeted() -> impl Iterator<Item = (&'static str, Tracer)> {
    UNBRANCHED.into_iter().chain(BRANCHED).chain(OFFSET)
}

fn phong(material: Absorbing) -> Phong {
    material.material.phong
}

fn unabsorbing(material: Absorbing) -> Material {
    material.material
}

fn spawned_by(
    spawn: SpawnRay,
    scene: &Scene<Absorbing>,
    camera: Camera,
    budget: PathBudget,
) -> Picture {
    let scene = scene.clone().map(unabsorbing);
    Picture::new(move |pixel| {
        let ray = from_eye(&scene.objects, camera.eye)(camera.ray(pixel.centre()));
        shadow_acne::trace(&scene, &ray, budget, spawn)
    })
}
