//! Kinds of fault that others reported: one question decided at two points, one after the
//! other.

use ::plane_hit::{Object, Shape, Texture};
use ::ray_casting::Camera;
use ::shading::{Phong, trace};
use ::shadows::{PointLight, Scene};
use canvas::Pixel;
use glam::{UVec2, Vec3, vec3};
use harness::{cases, magnitude, speckles, unit_vector};
use proptest::prelude::*;

/// Returns the number of speckles in a picture of a glossy plane with a lamp in it.
fn speckles_of_plane(point: Vec3, normal: Vec3, lamp: Vec3, eye: Vec3) -> usize {
    let plane = Object {
        name: "plane",
        shape: Shape::plane(point, normal),
        material: Phong {
            colour: Texture::Solid(Vec3::ONE),
            ambient: 0.0,
            diffuse: 0.0,
            specular: 1.0,
            shininess: 5,
        },
    };
    let light = PointLight::new(lamp, 1.0).expect("in range");
    let scene = Scene::new(vec![plane], vec![light], Vec3::NEG_ONE).expect("a scene");
    let up = normal.any_orthogonal_vector();
    let camera = Camera::new(eye, point - eye, up, 1.0).expect("a camera");
    let pixels = Pixel::all(UVec2::new(64, 48));
    let radiance = pixels.map(|pixel| trace(&scene, &camera.ray(pixel.centre())).x);
    let radiance: Vec<f32> = radiance.collect();
    // The background is −1: beside it, nothing is a speckle.
    radiance.split(|&x| x < 0.0).map(speckles).sum()
}

/// Next to the lamp itself the highlight changes from pixel to pixel: so many may be speckles.
const NEXT_TO_THE_LAMP: usize = 4;

/// The plane through (0, 0.7, 0) with the normal (0.1, 1, −0.05): 30,996 of 76,800 pixels were
/// speckled, as rounding put N·L above 0 or below.
#[test]
fn a_lamp_in_the_plane_of_a_glossy_floor_makes_no_speckles() {
    let (point, normal) = (0.7 * Vec3::Y, vec3(0.1, 1.0, -0.05));
    for lamp in [
        vec3(1.0, 0.6, 0.0),
        vec3(-3.0, 1.1, 2.0),
        vec3(0.0, 0.85, 3.0),
    ] {
        assert!(normal.dot(lamp - point).abs() < 1e-6);
        let speckles = speckles_of_plane(point, normal, lamp, vec3(0.0, 1.6, -5.0));
        assert!(speckles <= NEXT_TO_THE_LAMP, "{speckles}");
    }
}

proptest! {
    #![proptest_config(cases(500))]

    /// Any plane, from either side, with a lamp anywhere in it.
    #[test]
    fn a_lamp_in_any_plane_makes_no_speckles(
        point in unit_vector(), normal in unit_vector(), along in unit_vector(),
        far in magnitude(-1.0..2.0), from_above in any::<bool>(),
    ) {
        let (point, normal) = (5.0 * point, normal);
        let lamp = point + far * along.cross(normal);
        let eye = point + if from_above { 4.0 } else { -4.0 } * normal;
        let [point, normal, lamp, eye] = [point, normal, lamp, eye].map(|v| v.as_vec3());
        let speckles = speckles_of_plane(point, normal, lamp, eye);
        prop_assert!(speckles <= NEXT_TO_THE_LAMP, "{speckles}");
    }
}
