//! The numbers that the chapter's page quotes. They guard the page, not the truth: the code
//! under test has written them.

use ::shadow_acne::{STAGE, SpawnRay, from_surface, with_fixed_offset};
use glam::Vec3;
use harness::{Numbers, table};
use plane_hit::Shape;
use shadows::Interaction;

#[test]
fn the_numbers_are_those_in_the_book() {
    let mut numbers = Numbers::default();
    let scales = [1e-3, 1e-2, 0.1, 1.0, 1e3];
    numbers.note(
        "radius",
        table(scales.map(|scale: f32| {
            let radius =
                |spawn| format!("{:.4}", shadow_radius(scale, spawn) / f64::from(scale));
            [
                scale.to_string(),
                radius(with_fixed_offset),
                radius(from_surface),
            ]
        })),
    );
    numbers.check(STAGE.name);
}

/// The radius of the shadow of a ball of radius `scale` on a floor, from a light 10 of its radii above.
fn shadow_radius(scale: f32, spawn: SpawnRay) -> f64 {
    let floor = Shape::plane(Vec3::ZERO, Vec3::Y);
    let ball = Shape::sphere(scale * Vec3::Y, scale);
    let light = 10.0 * scale * Vec3::Y;
    let (mut dark, mut lit) = (0.0, 2.0 * scale);
    for _ in 0..30 {
        let middle = (dark + lit) / 2.0;
        let at = Interaction {
            index: 0,
            shape: floor,
            t: 1.0,
            point: middle * Vec3::X,
            incident: Vec3::NEG_Y,
            outward: Vec3::Y,
            normal: Vec3::Y,
        };
        let to_light = light - at.point;
        let ray = spawn(&at, to_light.normalize());
        if ray.distance(1, &ball, to_light.length()).is_some() {
            dark = middle;
        } else {
            lit = middle;
        }
    }
    lit.into()
}
