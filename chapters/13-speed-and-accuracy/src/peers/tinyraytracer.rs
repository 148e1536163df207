//! The picture of another small tracer, by ours.

use glam::{UVec2, Vec3};
use plane_hit::{Object, Pattern, Plane, Shape};
use ray_casting::Camera;
use reflection::Reach;
use refraction::{Body, Material};
use shading::Phong;
use shadows::{PointLight, Scene};
use sphere_hit::Sphere;

/// The size of its picture.
pub const SIZE: UVec2 = UVec2::new(1024, 768);

/// How far it follows a ray: four bounces. What brings next to nothing we leave out, as
/// always.
pub const REACH: Reach = Reach {
    depth: 4,
    weight: 1.0,
    least_weight: reflection::LEAST_WEIGHT,
};

/// Its four balls over a chequered board, before its camera.
///
/// All lengths are half of its own, for its squares have sides of 2 and ours of 1: the
/// picture is the same. Side by side, balls, squares, shadows and highlights coincide.
/// What differs: its board ends in the sky, and our floor at the horizon, with far more
/// pixels to light, in the mirror and the glass as well; our glass mirrors and lets
/// through what Fresnel says, in place of .1 and .8; and where a ray is followed no
/// farther there is black, not sky.
///
/// Source: Dmitry Sokolov, tinyraytracer (2019), whose numbers these are.
///
/// # Panics
/// Never: the balls' radii are positive.
#[must_use]
pub fn scene() -> (Scene<Material>, Camera) {
    let phong = |colour, diffuse, specular, shininess| Phong {
        colour,
        ambient: 0.0,
        diffuse,
        specular,
        shininess,
    };
    let plain = |r, g, b| Pattern::Plain(Vec3::new(r, g, b));
    let opaque = |reflectivity| Body::Opaque { reflectivity };
    let glass = Body::Clear {
        inside: 1.5,
        outside: 1.0,
    };
    let squares = Pattern::Checker(Vec3::splat(0.3), Vec3::new(0.3, 0.2, 0.1));
    let half = |x, y, z| Vec3::new(x, y, z) / 2.0;
    let ball = |centre, radius: f32| {
        let sphere = Sphere::new(centre, radius / 2.0);
        Shape::Sphere(sphere.expect("a radius above 0"))
    };
    let board = Plane::new(half(0.0, -4.0, 0.0), Vec3::Y).expect("a normal");
    let board = Shape::Plane(board);
    let ivory = phong(plain(0.4, 0.4, 0.3), 0.6, 0.3, 50);
    let rubber = phong(plain(0.3, 0.1, 0.1), 0.9, 0.1, 10);
    let colourless = plain(1.0, 1.0, 1.0);
    let thing = |name, shape, phong, body| Object {
        name,
        shape,
        material: Material { phong, body },
    };
    let objects = vec![
        thing("board", board, phong(squares, 1.0, 0.0, 1), opaque(0.0)),
        thing(
            "ivory",
            ball(half(-3.0, 0.0, -16.0), 2.0),
            ivory,
            opaque(0.1),
        ),
        thing(
            "glass",
            ball(half(-1.0, -1.5, -12.0), 2.0),
            phong(colourless, 0.0, 0.5, 125),
            glass,
        ),
        thing(
            "rubber",
            ball(half(1.5, -0.5, -18.0), 3.0),
            rubber,
            opaque(0.0),
        ),
        thing(
            "mirror",
            ball(half(7.0, 5.0, -18.0), 4.0),
            phong(colourless, 0.0, 10.0, 1425),
            opaque(0.8),
        ),
    ];
    let lamp = |position, intensity| PointLight {
        position,
        intensity,
    };
    let scene = Scene {
        objects,
        lights: vec![
            lamp(half(-20.0, 20.0, 20.0), 1.5),
            lamp(half(30.0, 50.0, -25.0), 1.8),
            lamp(half(30.0, 20.0, 30.0), 1.7),
        ],
        background: Vec3::new(0.2, 0.7, 0.8),
    };
    // Its z grows towards the eye. 60° from the top to the bottom of the picture:
    // 1/tan 30° is √3.
    let camera = Camera {
        eye: Vec3::ZERO,
        right: Vec3::X,
        up: Vec3::Y,
        forward: Vec3::NEG_Z,
        focal_length: 3.0_f32.sqrt(),
    };
    (scene, camera)
}

/// Its kind of file, three bytes a pixel: linear light, dimmed where its brightest colour
/// is more than 1.
#[must_use]
pub fn ppm(size: UVec2, light: &[Vec3]) -> Vec<u8> {
    let mut file = format!("P6\n{} {}\n255\n", size.x, size.y).into_bytes();
    for &light in light {
        let brightest = light.max_element();
        let light = if brightest > 1.0 {
            light / brightest
        } else {
            light
        };
        file.extend((255.0 * light).to_array().map(|level| level as u8));
    }
    file
}
