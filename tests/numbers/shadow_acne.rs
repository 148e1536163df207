use super::*;
use ::plane_hit::{Object, Plane, Shape};
use ::shadow_acne::{Leave, by_a_fixed_offset, from_the_surface};
use ::sphere_hit::Sphere;

#[test]
fn the_numbers_are_those_in_the_book() {
    let mut numbers = Numbers::default();
    let scales = [1e-3, 1e-2, 0.1, 1.0, 1e3];
    numbers.note(
        "radius",
        table(scales.map(|scale: f32| {
            let radius =
                |leave| format!("{:.4}", shadow_radius(scale, leave) / f64::from(scale));
            [
                scale.to_string(),
                radius(by_a_fixed_offset),
                radius(from_the_surface),
            ]
        })),
    );
    numbers.check("10-shadow-acne");
}

/// The radius of the shadow of a ball of radius `scale` on a floor, by a lamp 10 of its radii above.
fn shadow_radius(scale: f32, leave: Leave<()>) -> f64 {
    let object = |shape| Object {
        name: "",
        shape,
        material: (),
    };
    let ball = object(Shape::Sphere(
        Sphere::new(scale * Vec3::Y, scale).expect("a sphere"),
    ));
    let floor = object(Shape::Plane(
        Plane::new(Vec3::ZERO, Vec3::Y).expect("a plane"),
    ));
    let lamp = 10.0 * scale * Vec3::Y;
    let (mut dark, mut lit) = (0.0, 2.0 * scale);
    for _ in 0..30 {
        let middle = (dark + lit) / 2.0;
        let point = middle * Vec3::X;
        let to_lamp = lamp - point;
        let ray = leave(&floor, point, Vec3::Y, to_lamp.normalize());
        if ray.hit(&ball, to_lamp.length()).is_some() {
            dark = middle;
        } else {
            lit = middle;
        }
    }
    lit.into()
}
