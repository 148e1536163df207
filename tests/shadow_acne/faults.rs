//! Kinds of fault that others reported: an eye or a lamp on a surface, a ground that is a huge
//! sphere, and a sign that rounding decides.

use ::plane_hit::{Object, Shape, Texture};
use ::ray_casting::{Camera, Ray};
use ::reflection::{MAX_DEPTH, PathBudget};
use ::refraction::{Material, Optics};
use ::shading::Phong;
use ::shadow_acne::{from_eye, from_surface, trace};
use ::shadows::{PointLight, Scene};
use canvas::Pixel;
use glam::{DVec3, UVec2, Vec3, vec3};
use harness::{cases, magnitude, unit_vector};
use proptest::prelude::*;
use trial::exactly;

fn object(
    shape: Shape,
    reflectivity: f32,
    diffuse: f32,
    specular: f32,
) -> Object<Material> {
    let phong = Phong {
        colour: Texture::Solid(Vec3::ONE),
        ambient: 0.0,
        diffuse,
        specular,
        shininess: 5,
    };
    Object {
        name: "",
        shape,
        material: Material {
            phong,
            optics: Optics::Opaque { reflectivity },
        },
    }
}

fn matte(shape: Shape) -> Object<Material> {
    object(shape, 0.0, 0.8, 0.0)
}

fn scene(objects: Vec<Object<Material>>, lamp: Vec3) -> Scene<Material> {
    let light = PointLight::new(lamp, 1.0).expect("in range");
    Scene::new(objects, vec![light], Vec3::NEG_ONE).expect("distinct surfaces")
}

fn radiance(scene: &Scene<Material>, ray: Ray) -> f32 {
    let ray = from_eye(&scene.objects, ray.origin)(ray);
    trace(scene, &ray, PathBudget::new(MAX_DEPTH), from_surface).x
}

proptest! {
    #![proptest_config(cases(50_000))]

    /// Of 1,000 rays that looked into the unit ball from (0, 0, −1), 117 met it at t = 6·10⁻⁸.
    /// From any point of a ball, of any size and anywhere, a ray outwards hits nothing, and one
    /// inwards the far side of the chord.
    #[test]
    fn an_eye_on_a_ball_does_not_see_the_ball_at_the_eye(
        centre in unit_vector(), away in prop_oneof![Just(0.0), magnitude(-2.0..2.0)],
        radius in magnitude(-6.0..6.0), out in unit_vector(), along in unit_vector(),
    ) {
        let centre = (away * radius * centre).as_vec3();
        let objects = [matte(Shape::sphere(centre, radius as f32))];
        let eye = (centre.as_dvec3() + radius * out).as_vec3();
        let ray = from_eye(&objects, eye)(Ray { origin: eye, direction: along.as_vec3() });
        let cosine = out.dot(along);
        // Rounding moves the eye: a chord as short as that cannot be told from none.
        prop_assume!(cosine.abs() > 1e-3 * (1.0 + away));
        match ray.intersect(&objects) {
            Some(at) => {
                let chord = -2.0 * cosine * radius;
                let error = (f64::from(at.t) - chord).abs();
                prop_assert!(error <= 1e-4 * radius * (1.0 + away), "{error}");
            }
            None => prop_assert!(cosine > 0.0),
        }
    }

    /// From a floor, a wall or any tilted plane nothing of the plane is seen.
    #[test]
    fn an_eye_on_a_plane_does_not_see_the_plane(
        normal in unit_vector(), point in unit_vector(), distance in magnitude(-3.0..6.0),
        aside in unit_vector(), far in magnitude(-3.0..6.0), along in unit_vector(),
    ) {
        let point = (distance * point).as_vec3();
        let objects = [matte(Shape::plane(point, normal.as_vec3()))];
        let eye = (point.as_dvec3() + far * aside.cross(normal)).as_vec3();
        let ray = from_eye(&objects, eye)(Ray { origin: eye, direction: along.as_vec3() });
        prop_assert_eq!(ray.intersect(&objects), None);
    }

    /// A lamp on a plane, at any scale, seen from any point of a ball: it lights the side of
    /// the ball that faces it.
    #[test]
    fn a_lamp_on_a_plane_is_hidden_by_nothing_but_the_ball_it_lights(
        normal in unit_vector(), aside in unit_vector(), far in magnitude(-1.0..2.0),
        scale in magnitude(-6.0..6.0), from in unit_vector(),
    ) {
        // A unit ball at the origin, 2 in front of the plane.
        let lamp = -2.0 * normal + far * aside.cross(normal);
        let plane = Shape::plane((scale * -2.0 * normal).as_vec3(), normal.as_vec3());
        let ball = Shape::sphere(Vec3::ZERO, scale as f32);
        let scene = scene(vec![matte(plane), matte(ball)], (scale * lamp).as_vec3());
        // Seen from this side, and never through the plane.
        let eye = 1.9 * from;
        let ray = Ray { origin: (scale * eye).as_vec3(), direction: (-from).as_vec3() };
        let cosine = from.dot((lamp - from).normalize());
        prop_assume!(cosine.abs() > 1e-3 && eye.dot(normal) > -1.95);
        let expected = if cosine > 0.0 { 0.8 * cosine } else { 0.0 };
        let error = f64::from(radiance(&scene, ray)) - expected;
        prop_assert!(error.abs() <= 1e-4, "{error}");
    }

    /// At any distance and any scale: of rays that touched a mirror ball, one in six was
    /// reflected into it, and one in twelve never came out again.
    #[test]
    fn a_ray_that_grazes_a_mirror_ball_sees_the_sky_in_it(
        out in unit_vector(), distance in magnitude(0.0..6.0), scale in magnitude(-9.0..6.0),
        height in prop_oneof![Just(0.0), magnitude(-9.0..-1.0).prop_map(|h| -h)],
    ) {
        let mut scene = scene(
            vec![object(Shape::sphere(Vec3::ZERO, scale as f32), 1.0, 0.0, 0.0)], Vec3::ZERO,
        );
        scene.background = Vec3::ONE;
        let along = out.any_orthonormal_vector();
        let origin = (scale * ((1.0 + height) * out - distance * along)).as_vec3();
        prop_assert_eq!(radiance(&scene, Ray { origin, direction: along.as_vec3() }), 1.0);
    }
}

/// A tilted glossy floor with a lamp in its plane had 30,996 of 76,800 pixels speckled, up to
/// 0.99; now they are all lit, or none is.
#[test]
fn a_lamp_in_the_plane_of_a_glossy_floor_makes_no_speckles() {
    let (point, normal) = (0.7 * Vec3::Y, vec3(0.1, 1.0, -0.05));
    for lamp in [
        vec3(1.0, 0.6, 0.0),
        vec3(-3.0, 1.1, 2.0),
        vec3(0.0, 0.85, 30.0),
    ] {
        let floor = object(Shape::plane(point, normal), 0.0, 0.0, 1.0);
        let scene = scene(vec![floor], lamp);
        let eye = vec3(0.0, 1.6, -5.0);
        let camera =
            Camera::new(eye, vec3(0.0, -0.3, 1.0), Vec3::Y, 1.5).expect("a camera");
        let mut rows = Vec::new();
        for pixel in Pixel::all(UVec2::new(160, 120)) {
            rows.push(radiance(&scene, camera.ray(pixel.centre())));
        }
        let speckles = harness::speckles(&rows);
        assert!(speckles <= 8, "{speckles}");
    }
}

/// Returns how many pixels differ by more than a tenth of white from the oracle's, in a picture
/// of balls on a sphere of this radius.
pub fn wrong_pixels(ground: f32) -> usize {
    let ball = |x: f32, z: f32, radius: f32| Shape::sphere(vec3(x, radius, z), radius);
    let shapes = [
        Shape::sphere(-ground * Vec3::Y, ground),
        ball(0.0, 1.0, 1.0),
        ball(-1.4, 0.0, 0.5),
        ball(0.5, -1.4, 0.05),
    ];
    let lamp = vec3(-3.0, 4.0, -4.0);
    let exact = oracle::Scene {
        objects: shapes
            .map(exactly)
            .map(|shape| oracle::Object {
                shape,
                surface: oracle::Surface {
                    texture: oracle::Texture::Solid(DVec3::ONE),
                    ambient: 0.0,
                    diffuse: 0.8,
                    specular: 0.0,
                    shininess: 1,
                },
                optics: oracle::Optics::Opaque(0.0),
            })
            .to_vec(),
        lights: vec![oracle::PointLight {
            position: lamp.as_dvec3(),
            intensity: 1.0,
        }],
        background: DVec3::NEG_ONE,
    };
    let scene = scene(shapes.map(matte).to_vec(), lamp);
    let eye = vec3(0.4, 0.9, -3.6);
    let camera = Camera::new(eye, vec3(-0.1, 0.35, 0.0) - eye, Vec3::Y, 2.0);
    let camera = camera.expect("a camera");
    let is_wrong = |pixel: &Pixel| {
        let ray = camera.ray(pixel.centre());
        let exact_ray = oracle::Ray {
            origin: ray.origin.as_dvec3(),
            direction: ray.direction.as_dvec3(),
            from: None,
        };
        let exact = oracle::trace_shaded(&exact, &exact_ray).x;
        (f64::from(radiance(&scene, ray)) - exact).abs() > 0.1
    };
    Pixel::all(UVec2::new(320, 240)).filter(is_wrong).count()
}

/// Up to a radius of 10⁴, ten thousand times that of the largest ball on it: a few pixels at the
/// edges of shadows. Measured: 0, 0, 1 and 9 of 76,800.
#[test]
fn a_ground_that_is_a_large_sphere_has_no_ragged_shadows() {
    for ground in [1e1, 1e2, 1e3, 1e4] {
        let wrong = wrong_pixels(ground);
        assert!(wrong <= 12, "{ground}: {wrong}");
    }
}

/// Must fail: there f32 cannot tell two heights of less than 1/16 apart. Measured: 488 pixels.
#[test]
fn a_ground_that_is_a_huge_sphere_has_ragged_shadows() {
    assert!(wrong_pixels(1e6) > 200);
}
