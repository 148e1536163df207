//! Bodies of glass half in the water, written out independently of the chapters.

use crate::{Camera, Glass, Object, Optics, PointLight, Scene, Shape, Surface, Texture};
use glam::{DVec3, dvec3};

/// Returns a checkered pool of water with a red ball on its bottom, and in the water's surface a hollow ball of
/// tinted glass and a lens of two: of glass, and of ice, which displaces the glass.
#[must_use]
pub fn water() -> Scene {
    let surface = |texture, specular, shininess| Surface {
        texture,
        ambient: 0.1,
        diffuse: 0.8,
        specular,
        shininess,
    };
    let ball = |centre, radius| Shape::Sphere { centre, radius };
    let level = |height: f64| Shape::Plane {
        point: height * DVec3::Y,
        normal: DVec3::Y,
    };
    let clear = |shape, eta_inside, absorption| Object {
        shape,
        surface: Surface {
            ambient: 0.0,
            diffuse: 0.0,
            ..surface(Texture::Solid(DVec3::ONE), 0.8, 200)
        },
        optics: Optics::Dielectric {
            eta_inside,
            eta_outside: 1.0,
            glass: Glass::Absorbs(absorption),
        },
    };
    let opaque = |shape, surface, reflected| Object {
        shape,
        surface,
        optics: Optics::Opaque(reflected),
    };
    let checker = Texture::Checker(DVec3::splat(0.15), DVec3::splat(0.85));
    let red = Texture::Solid(dvec3(0.9, 0.15, 0.1));
    let light = |position, intensity| PointLight {
        position,
        intensity,
    };
    Scene {
        objects: vec![
            opaque(level(-1.6), surface(checker, 0.0, 1), 0.0),
            opaque(ball(dvec3(1.1, -0.9, 1.2), 0.7), surface(red, 0.5, 50), 0.3),
            clear(level(0.0), 1.33, dvec3(0.5, 0.15, 0.1)),
            clear(ball(dvec3(-0.9, 0.1, 0.3), 0.9), 1.5, dvec3(0.3, 0.1, 0.5)),
            clear(ball(dvec3(-0.8, 0.25, 0.2), 0.45), 1.0, DVec3::ZERO),
            clear(ball(dvec3(0.8, 0.15, -0.9), 0.5), 1.7, dvec3(0.1, 0.6, 0.6)),
            clear(ball(dvec3(1.3, 0.35, -0.8), 0.45), 1.31, DVec3::ZERO),
        ],
        lights: vec![
            light(dvec3(-3.0, 6.0, -4.0), 0.6),
            light(dvec3(4.0, 5.0, -2.0), 0.5),
        ],
        background: dvec3(0.2, 0.5, 0.8),
    }
}

/// Returns its camera: 45° from top to bottom.
#[must_use]
pub fn water_camera() -> Camera {
    Camera::upright(
        dvec3(0.0, 2.3, -6.0),
        dvec3(0.0, -2.3, 6.0),
        1.0 + std::f64::consts::SQRT_2,
    )
}
