//! The numbers that the chapter's page quotes. They guard the page, not the truth: the code
//! under test has written them.

use crate::faults::wrong_pixels;
use ::shadow_acne::scene::balls_on_a_planet;
use ::shadow_acne::{STAGE, SpawnRay, from_eye, from_surface, without_offset};
use canvas::Pixel;
use glam::Vec3;
use harness::{
    Numbers, SMALL, edge_of_shadow, render_at, table, triple, vector, with_separators,
};
use plane_hit::{Object, Shape, Texture};
use refraction::{Material, Optics};
use shadows::{Interaction, PointLight, Scene, is_visible};
use sphere_hit::Sphere;

#[test]
fn the_numbers_are_those_in_the_book() {
    let mut numbers = Numbers::default();
    let scales = [1e-3, 1e-2, 0.1, 1.0, 1e3];
    numbers.note(
        "radius",
        table(scales.map(|scale: f32| {
            let [fixed, cured] = shadow_radii(scale)
                .map(|radius| format!("{:.4}", f64::from(radius) / f64::from(scale)));
            [scale.to_string(), fixed, cured]
        })),
    );
    for ground in [1e4, 1e6] {
        numbers.note(&format!("ground-{ground}"), wrong_pixels(ground));
    }
    note_planet(&mut numbers);
    for name in ["planet", "large"] {
        let fraction = self_shadowing(name);
        numbers.note(&format!("self-shadowing-{name}"), fraction);
    }
    let levels = |view| render_at(&STAGE, view, 1000.0, SMALL).levels;
    let right = levels("from-surface");
    for view in ["fixed", "acne"] {
        let pairs = levels(view).into_iter().zip(&right);
        let wrong = pairs.filter(|(wrong, right)| wrong != *right).count();
        numbers.note(&format!("wrong-{view}"), with_separators(wrong as u64));
    }
    numbers.check(STAGE.name);
}

/// Notes what is on the planet, at a scale of 1.
fn note_planet(numbers: &mut Numbers) {
    let (scene, camera) = balls_on_a_planet(1.0);
    let sphere = |object: &Object<Material>| {
        let Shape::Sphere(sphere) = object.shape else {
            panic!("{} is a ball", object.name);
        };
        sphere
    };
    let planet = sphere(&scene.objects[0]);
    let row = |object: &Object<Material>| {
        let Sphere { centre, radius } = sphere(object);
        let apart = centre.as_dvec3().distance(planet.centre.as_dvec3());
        let height = apart - f64::from(planet.radius) - f64::from(radius);
        let Optics::Opaque { reflectivity } = object.material.optics else {
            panic!("{} is opaque", object.name);
        };
        let Texture::Solid(colour) = object.material.phong.colour else {
            panic!("{} has one colour", object.name);
        };
        [
            object.name.to_string(),
            triple(centre),
            radius.to_string(),
            triple(colour),
            reflectivity.to_string(),
            if object.name == "planet" {
                "–".to_string()
            } else {
                format!("{height:.4}")
            },
        ]
    };
    numbers.note("planet", table(scene.objects.iter().map(row)));
    let material = |object: &Object<Material>| {
        let phong = &object.material.phong;
        [
            "of every object".to_string(),
            phong.ambient.to_string(),
            phong.diffuse.to_string(),
            phong.specular.to_string(),
            phong.shininess.to_string(),
        ]
    };
    let mut materials: Vec<_> = scene.objects.iter().map(material).collect();
    materials.dedup();
    numbers.note("planet-material", table(materials));
    let [light] = scene.lights[..] else {
        panic!("there is one light");
    };
    numbers.note("planet-light", triple(light.position));
    numbers.note("planet-intensity", light.intensity);
    numbers.note("planet-eye", triple(camera.eye));
    numbers.note("planet-forward", vector(&camera.forward.to_array()));
    numbers.note("planet-focal-length", camera.focal_length);
}

/// Returns the fraction of an object's lit points that are in the shadow of their own surface if
/// shadow rays have no offset.
fn self_shadowing(name: &str) -> String {
    let (scene, camera) = balls_on_a_planet(1.0);
    let objects = &scene.objects;
    let light = scene.lights[0].position;
    let (mut lit, mut dark) = (0, 0);
    for pixel in Pixel::all(SMALL) {
        let ray = from_eye(objects, camera.eye)(camera.ray(pixel.centre()));
        let at = ray.intersect(objects);
        let Some(at) = at.filter(|at| objects[at.index].name == name) else {
            continue;
        };
        let (direction, distance) = (light - at.point).normalize_and_length();
        let is_occluded =
            |spawn: SpawnRay| spawn(&at, direction).is_occluded(objects, light, distance);
        if at.outward.dot(direction) > 0.0 && !is_occluded(from_surface) {
            lit += 1;
            dark += usize::from(is_occluded(without_offset));
        }
    }
    format!("{:.0} %", 100.0 * dark as f64 / lit as f64)
}

/// Returns the radius of the shadow of a ball of radius `scale` on a floor, from a light 10 of
/// its radii above, by chapter 4's fixed offset and by the cure.
fn shadow_radii(scale: f32) -> [f32; 2] {
    let shapes = [
        Shape::plane(Vec3::ZERO, Vec3::Y),
        Shape::sphere(scale * Vec3::Y, scale),
    ];
    let objects = shapes.map(|shape| Object {
        name: "",
        shape,
        material: (),
    });
    let light = PointLight::new(10.0 * scale * Vec3::Y, 1.0).expect("a valid light");
    let scene = Scene::new(objects.to_vec(), vec![light], Vec3::ZERO);
    let scene = scene.expect("two surfaces");
    let at = |x: f32| Interaction {
        index: 0,
        shape: shapes[0],
        t: 1.0,
        point: x * Vec3::X,
        incident: Vec3::NEG_Y,
        outward: Vec3::Y,
        normal: Vec3::Y,
    };
    let by_offset = |x: f32| is_visible(&scene, &at(x), &light);
    let by_surface = |x: f32| {
        let (direction, distance) = (light.position - at(x).point).normalize_and_length();
        let shadow_ray = from_surface(&at(x), direction);
        !shadow_ray.is_occluded(&scene.objects, light.position, distance)
    };
    [
        edge_of_shadow(2.0 * scale, by_offset),
        edge_of_shadow(2.0 * scale, by_surface),
    ]
}
