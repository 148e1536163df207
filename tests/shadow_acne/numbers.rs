//! The numbers that the chapter's page quotes. They guard the page, not the truth: the code
//! under test has written them.

use crate::faults::wrong_pixels;
use ::shadow_acne::scene::balls_on_a_planet;
use ::shadow_acne::{STAGE, from_surface};
use glam::Vec3;
use harness::{Numbers, edge_of_shadow, table, triple, vector};
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
    numbers.check(STAGE.name);
}

/// Notes what is on the planet, at a scale of 1.
fn note_planet(numbers: &mut Numbers) {
    let (scene, camera) = balls_on_a_planet(1.0);
    let row = |object: &Object<Material>| {
        let Shape::Sphere(Sphere { centre, radius }) = object.shape else {
            panic!("{} is a ball", object.name);
        };
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
