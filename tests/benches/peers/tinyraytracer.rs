//! The picture of another small tracer, by ours.

use glam::{UVec2, Vec3};
use plane_hit::{Object, Shape, Texture};
use ray_casting::Camera;
use reflection::{MIN_THROUGHPUT, PathBudget};
use refraction::{Material, Optics};
use shading::Phong;
use shadows::{PointLight, Scene};

/// The size of its picture.
pub const SIZE: UVec2 = UVec2::new(1024, 768);

/// The budget of its rays: four bounces. Rays of negligible throughput are not traced, as
/// in all chapters.
pub const BUDGET: PathBudget = PathBudget {
    depth: 4,
    throughput: 1.0,
    min_throughput: MIN_THROUGHPUT,
};

/// Returns its four balls over a checkered board, and its camera.
///
/// All lengths are half of its own, as its squares have sides of 2 and ours of 1: the
/// picture is the same. Side by side, balls, squares, shadows and highlights coincide. What
/// differs: its board ends in the sky, and our floor at the horizon, with far more pixels
/// to light, in the mirror and the glass as well; our glass reflects and transmits by
/// Fresnel's equations, not .1 and .8; and a ray that is not traced is black, not sky.
///
/// Source: Dmitry Sokolov, tinyraytracer (2019), whose numbers these are.
pub fn scene() -> (Scene<Material>, Camera) {
    let phong = |colour, diffuse, specular, shininess| Phong {
        colour,
        ambient: 0.0,
        diffuse,
        specular,
        shininess,
    };
    let solid = |r, g, b| Texture::Solid(Vec3::new(r, g, b));
    let opaque = |reflectivity| Optics::Opaque { reflectivity };
    let glass = Optics::Dielectric {
        eta_inside: 1.5,
        eta_outside: 1.0,
    };
    let squares = Texture::Checker(Vec3::splat(0.3), Vec3::new(0.3, 0.2, 0.1));
    let half = |x, y, z| Vec3::new(x, y, z) / 2.0;
    let ball = |centre, radius: f32| Shape::sphere(centre, radius / 2.0);
    let board = Shape::plane(half(0.0, -4.0, 0.0), Vec3::Y);
    let object = |name, shape, phong, optics| Object {
        name,
        shape,
        material: Material { phong, optics },
    };
    let colourless = solid(1.0, 1.0, 1.0);
    let objects = vec![
        object("board", board, phong(squares, 1.0, 0.0, 1), opaque(0.0)),
        object(
            "ivory",
            ball(half(-3.0, 0.0, -16.0), 2.0),
            phong(solid(0.4, 0.4, 0.3), 0.6, 0.3, 50),
            opaque(0.1),
        ),
        object(
            "glass",
            ball(half(-1.0, -1.5, -12.0), 2.0),
            phong(colourless, 0.0, 0.5, 125),
            glass,
        ),
        object(
            "rubber",
            ball(half(1.5, -0.5, -18.0), 3.0),
            phong(solid(0.3, 0.1, 0.1), 0.9, 0.1, 10),
            opaque(0.0),
        ),
        object(
            "mirror",
            ball(half(7.0, 5.0, -18.0), 4.0),
            phong(colourless, 0.0, 10.0, 1425),
            opaque(0.8),
        ),
    ];
    let light = |position, intensity| PointLight {
        position,
        intensity,
    };
    let scene = Scene {
        objects,
        lights: vec![
            light(half(-20.0, 20.0, 20.0), 1.5),
            light(half(30.0, 50.0, -25.0), 1.8),
            light(half(30.0, 20.0, 30.0), 1.7),
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

/// Returns a file of its kind, three bytes a pixel: linear light, dimmed where its brightest
/// colour is more than 1.
pub fn ppm(size: UVec2, radiance: &[Vec3]) -> Vec<u8> {
    let mut file = format!("P6\n{} {}\n255\n", size.x, size.y).into_bytes();
    for &radiance in radiance {
        let brightest = radiance.max_element();
        let radiance = if brightest > 1.0 {
            radiance / brightest
        } else {
            radiance
        };
        file.extend((255.0 * radiance).to_array().map(|level| level as u8));
    }
    file
}
