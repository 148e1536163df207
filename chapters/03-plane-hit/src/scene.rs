// ANCHOR: still-life
//! The still life: the scene that most chapters render.

use crate::{Object, Shape, Texture};
use glam::Vec3;

/// Returns five spheres on a floor, made of `materials`: floor, red, mirror, green, blue,
/// glass.
pub fn still_life<M>(materials: [M; 6]) -> Vec<Object<M>> {
    let sphere = |x, y, z, radius| Shape::sphere(Vec3::new(x, y, z), radius);
    let shapes = [
        ("floor", Shape::plane(Vec3::ZERO, Vec3::Y)),
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
// ANCHOR_END: still-life

// ANCHOR: colours
/// The colour of the floor's even squares.
pub(crate) const DARK: Vec3 = Vec3::splat(0.1);
/// The colour of the floor's odd squares.
pub(crate) const LIGHT: Vec3 = Vec3::splat(0.9);

/// The still life's colours: floor, red, mirror, green, blue, glass. Until they have their
/// own chapters, the mirror is grey and the glass pale blue.
pub const STILL_LIFE_COLOURS: [Texture; 6] = [
    Texture::Checker(DARK, LIGHT),
    Texture::Solid(Vec3::new(0.9, 0.15, 0.1)),
    Texture::Solid(Vec3::splat(0.6)),
    Texture::Solid(Vec3::new(0.1, 0.7, 0.2)),
    Texture::Solid(Vec3::new(0.15, 0.2, 0.9)),
    Texture::Solid(Vec3::new(0.55, 0.75, 0.8)),
];
// ANCHOR_END: colours
