//! The still life, written out independently of the chapters.
//!
//! Its numbers are the decimals themselves, as f64 holds them, and not the f32 values that a chapter
//! rounds them to: 0.9 means nine tenths. The error by that rounding, some 10⁻⁸, is part of a
//! chapter's error.

use crate::{Camera, Glass, Object, Optics, PointLight, Scene, Shape, Surface, Texture};
use glam::{DVec3, dvec3};

/// Returns five spheres on a checkered floor under two lights, before there are mirrors: the mirror and the
/// glass are of plastic.
#[must_use]
pub fn still_life() -> Scene {
    let surface = |texture, specular, shininess| Surface {
        texture,
        ambient: 0.1,
        diffuse: 0.8,
        specular,
        shininess,
    };
    let ball = |centre, radius, colour, specular, shininess| Object {
        shape: Shape::Sphere { centre, radius },
        surface: surface(Texture::Solid(colour), specular, shininess),
        optics: Optics::Opaque(0.0),
    };
    let floor = Object {
        shape: Shape::Plane {
            point: DVec3::ZERO,
            normal: DVec3::Y,
        },
        surface: surface(
            Texture::Checker(DVec3::splat(0.1), DVec3::splat(0.9)),
            0.0,
            1,
        ),
        optics: Optics::Opaque(0.0),
    };
    let grey = DVec3::splat(0.6);
    Scene {
        objects: vec![
            floor,
            ball(dvec3(-2.2, 0.8, 1.0), 0.8, dvec3(0.9, 0.15, 0.1), 0.5, 50),
            ball(dvec3(0.2, 1.2, 2.0), 1.2, grey, 0.8, 200),
            ball(dvec3(2.3, 0.7, 0.6), 0.7, dvec3(0.1, 0.7, 0.2), 0.5, 50),
            ball(dvec3(-0.8, 0.4, -1.0), 0.4, dvec3(0.15, 0.2, 0.9), 0.8, 100),
            ball(dvec3(0.9, 0.6, -1.2), 0.6, dvec3(0.55, 0.75, 0.8), 0.8, 200),
        ],
        lights: vec![
            PointLight {
                position: dvec3(-5.0, 7.0, -6.0),
                intensity: 0.6,
            },
            PointLight {
                position: dvec3(4.0, 6.0, -4.0),
                intensity: 0.4,
            },
        ],
        background: dvec3(0.2, 0.5, 0.8),
    }
}

/// Returns the still life with the mirror, and a little reflectivity of the green ball.
#[must_use]
pub fn still_life_with_mirrors() -> Scene {
    let mut scene = still_life();
    let [_, _, mirror, green, ..] = &mut scene.objects[..] else {
        unreachable!("six objects");
    };
    mirror.surface = Surface {
        texture: Texture::Solid(DVec3::splat(0.9)),
        ambient: 0.02,
        diffuse: 0.1,
        specular: 0.8,
        shininess: 200,
    };
    mirror.optics = Optics::Opaque(0.8);
    green.optics = Optics::Opaque(0.2);
    scene
}

/// Returns the finished still life with its ball of glass, of index 1.5.
#[must_use]
pub fn still_life_with_glass(glass: Glass) -> Scene {
    let mut scene = still_life_with_mirrors();
    scene.objects[5].surface = Surface {
        texture: Texture::Solid(DVec3::ONE),
        ambient: 0.0,
        diffuse: 0.0,
        specular: 0.8,
        shininess: 200,
    };
    scene.objects[5].optics = Optics::Dielectric {
        eta_inside: 1.5,
        eta_outside: 1.0,
        glass,
    };
    scene
}

/// Returns the still life's camera: 45° from top to bottom, 1/tan(45°/2) = 1 + √2.
#[must_use]
pub fn still_life_camera() -> Camera {
    let forward = dvec3(0.0, -1.1, 7.0);
    Camera::upright(
        dvec3(0.0, 2.0, -7.0),
        forward,
        1.0 + std::f64::consts::SQRT_2,
    )
}
