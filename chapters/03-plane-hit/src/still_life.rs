//! The still life: the one scene that every chapter draws as well as it can.

use crate::{Object, Plane, Shape};
use glam::Vec3;
use sphere_hit::Sphere;

/// Five spheres on a floor, made of `materials`: floor, red, mirror, green, blue, glass.
#[must_use]
pub fn still_life<M>(materials: [M; 6]) -> Vec<Object<M>> {
    let sphere = |x, y, z, radius| {
        Shape::Sphere(Sphere {
            centre: Vec3::new(x, y, z),
            radius,
        })
    };
    let floor = Shape::Plane(Plane {
        point: Vec3::ZERO,
        normal: Vec3::Y,
    });
    let shapes = [
        ("floor", floor),
        ("red", sphere(-2.2, 0.8, 1.0, 0.8)),
        ("mirror", sphere(0.2, 1.2, 2.0, 1.2)),
        ("green", sphere(2.3, 0.7, 0.6, 0.7)),
        ("blue", sphere(-0.8, 0.4, -1.0, 0.4)),
        ("glass", sphere(0.9, 0.6, -1.2, 0.6)),
    ];
    let object = |((name, shape), material)| Object {
        name,
        shape,
        material,
    };
    shapes.into_iter().zip(materials).map(object).collect()
}
