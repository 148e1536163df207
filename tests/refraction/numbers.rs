//! The numbers that the chapter's page quotes. They guard the page, not the truth: the code
//! under test has written them.

use ::canvas::Pixel;
use ::plane_hit::{Texture, nearest};
use ::ray_casting::Camera;
use ::ray_casting::scene::still_life_camera;
use ::reflection::MAX_DEPTH;
use ::refraction::scene::{AIR, GLASS, close_up, still_life_with_glass};
use ::refraction::{
    Interface, Material, Optics, STAGE, refract, refract_or_reflect, spawn_ray,
};
use ::shadows::Interaction;
use glam::Vec3;
use harness::{HERO, Numbers, table, vector, with_separators};

const DIAMOND: f32 = 2.42;

#[test]
fn the_numbers_are_those_in_the_book() {
    let mut numbers = Numbers::default();
    let objects = still_life_with_glass(GLASS, AIR).objects;
    let dielectrics = objects.iter().filter_map(|object| {
        let Material { phong, optics } = object.material;
        let (
            Texture::Solid(Vec3 { x, y, z }),
            Optics::Dielectric {
                eta_inside,
                eta_outside,
            },
        ) = (phong.colour, optics)
        else {
            return None;
        };
        Some([
            object.name.to_string(),
            format!("({x}, {y}, {z})"),
            phong.ambient.to_string(),
            phong.diffuse.to_string(),
            phong.specular.to_string(),
            phong.shininess.to_string(),
            eta_inside.to_string(),
            eta_outside.to_string(),
        ])
    });
    numbers.note("dielectrics", table(dielectrics));
    let spots = [
        (Vec3::new(0.6, -0.8, 0.0), AIR, GLASS),
        (Vec3::new(0.6, -0.8, 0.0), GLASS, AIR),
        (Vec3::new(0.8, -0.6, 0.0), GLASS, AIR),
        (Vec3::new(0.0, -1.0, 0.0), AIR, DIAMOND),
    ];
    numbers.note(
        "spots",
        table(spots.map(|(incident, from, to)| {
            let refracted = refract(incident, Vec3::Y, from / to);
            [
                vector(&incident.to_array()),
                format!("{from} → {to}"),
                refracted.map_or("total internal reflection".to_string(), |t| {
                    vector(&t.to_array())
                }),
            ]
        })),
    );
    let still_life = still_life_camera();
    let ball = total_reflections(GLASS, AIR, &still_life)
        + total_reflections(GLASS, AIR, &close_up());
    numbers.note("total-ball", with_separators(ball));
    let bubble = total_reflections(AIR, GLASS, &close_up());
    numbers.note("total-bubble", with_separators(bubble));
    let camera_rays = u64::from(HERO.x * HERO.y);
    numbers.note("camera-rays", with_separators(camera_rays));
    numbers.check(STAGE.name);
}

/// Returns the number of a picture's camera rays that are totally reflected on their path
/// through glass.
fn total_reflections(eta_inside: f32, eta_outside: f32, camera: &Camera) -> u64 {
    let objects = still_life_with_glass(eta_inside, eta_outside).objects;
    let is_totally_reflected = |pixel: &Pixel| {
        let mut ray = camera.ray(pixel.centre());
        for _ in 0..MAX_DEPTH {
            let Some(hit) = nearest(&objects, &ray) else {
                return false;
            };
            let at = Interaction::new(&objects, &ray, hit);
            let Optics::Dielectric { .. } = objects[at.index].material.optics else {
                return false;
            };
            let Interface { eta_i, eta_t } = Interface::new(&at, eta_inside, eta_outside);
            if refract(at.incident, at.normal, eta_i / eta_t).is_none() {
                return true;
            }
            let (_, direction) = refract_or_reflect(&at, eta_inside, eta_outside);
            ray = spawn_ray(&at, direction);
        }
        false
    };
    Pixel::all(HERO).filter(is_totally_reflected).count() as u64
}
