use super::*;
use ::canvas::Pixel;
use ::plane_hit::nearest;
use ::ray_casting::Camera;
use ::ray_casting::views::{STILL_LIFE_FOCAL_LENGTH, still_life_camera};
use ::reflection::MAX_DEPTH;
use ::refraction::views::{AIR, GLASS, close_up, still_life_with_glass};
use ::refraction::{Body, Crossing, leave, redirect, refract};

const DIAMOND: f32 = 2.42;

#[test]
fn the_numbers_are_those_in_the_book() {
    let mut numbers = Numbers::default();
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
    let still_life = still_life_camera(STILL_LIFE_FOCAL_LENGTH);
    let ball = total_reflections(GLASS, AIR, &still_life)
        + total_reflections(GLASS, AIR, &close_up());
    numbers.note("total-ball", ball);
    numbers.note("total-bubble", total_reflections(AIR, GLASS, &close_up()));
    numbers.check("07-refraction");
}

/// How many of a picture's camera rays meet total internal reflection on their way.
fn total_reflections(inside: f32, outside: f32, camera: &Camera) -> usize {
    let objects = still_life_with_glass(inside, outside).objects;
    let pixels = (0..HERO.y).flat_map(|y| (0..HERO.x).map(move |x| (x, y)));
    let meets_it = |&(x, y): &(u32, u32)| {
        let mut ray = camera.ray(Pixel { x, y, size: HERO }.centre());
        for _ in 0..MAX_DEPTH {
            let Some((object, hit)) = nearest(&objects, &ray) else {
                return false;
            };
            let Body::Clear { inside, outside } = object.material.body else {
                return false;
            };
            let Crossing {
                normal,
                eta_i,
                eta_t,
            } = Crossing::new(ray.direction, hit.normal, inside, outside);
            if refract(ray.direction, normal, eta_i / eta_t).is_none() {
                return true;
            }
            let direction = redirect(ray.direction, hit.normal, inside, outside);
            ray = leave(ray.at(hit.t), hit.normal, direction.expect("a way on"));
        }
        false
    };
    pixels.filter(meets_it).count()
}
