//! Objects for the tests, without light of their own unless it is said.

use glam::DVec3;
use oracle::{Glass, Object, Optics, Ray, Scene, Shape, Surface, Texture};

/// Returns an object whose surface is white, and glows by `ambient`.
pub fn object(shape: Shape, ambient: f64, optics: Optics) -> Object {
    let surface = Surface {
        texture: Texture::Solid(DVec3::ONE),
        ambient,
        diffuse: 0.0,
        specular: 0.0,
        shininess: 1,
    };
    Object {
        shape,
        surface,
        optics,
    }
}

pub fn ball(centre: DVec3, radius: f64) -> Shape {
    Shape::Sphere { centre, radius }
}

/// Returns all that is below a height.
pub fn below(height: f64) -> Shape {
    Shape::Plane {
        point: height * DVec3::Y,
        normal: DVec3::Y,
    }
}

/// Returns an absorbing dielectric in air.
pub fn clear(shape: Shape, eta_inside: f64, absorption: DVec3) -> Object {
    let optics = Optics::Dielectric {
        eta_inside,
        eta_outside: 1.0,
        glass: Glass::Absorbs(absorption),
    };
    object(shape, 0.0, optics)
}

/// Returns a scene without lights.
pub fn scene(objects: Vec<Object>, background: DVec3) -> Scene {
    Scene {
        objects,
        lights: vec![],
        background,
    }
}

/// Returns a ray that starts on no surface.
pub fn ray(origin: DVec3, direction: DVec3) -> Ray {
    Ray {
        origin,
        direction,
        from: None,
    }
}
