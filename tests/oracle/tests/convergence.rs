//! More bounces and more samples change a picture by less and less.

use glam::{DVec3, dvec3};
use oracle::{
    Camera, Glass, Limit, Object, Optics, PointLight, Scene, Shape, Surface, Texture,
    pixel_centres, trace,
};
use rayon::prelude::*;

const SIZE: [u32; 2] = [48, 36];

/// Returns the radiance of a small picture's pixels, each the mean of n × n samples.
fn picture(scene: &Scene, camera: &Camera, limit: Limit, n: u32) -> Vec<DVec3> {
    let centres: Vec<_> = pixel_centres(SIZE).collect();
    let pixel = |centre| {
        let samples = pixel_centres([n, n]).map(|cell| {
            let point = centre - 0.5 + cell / f64::from(n);
            trace(scene, &camera.ray(point, SIZE), limit)
        });
        samples.sum::<DVec3>() / f64::from(n * n)
    };
    centres.into_par_iter().map(pixel).collect()
}

fn largest_difference(a: &[DVec3], b: &[DVec3]) -> f64 {
    let differences = a.iter().zip(b).map(|(a, b)| (*a - *b).abs().max_element());
    differences.fold(0.0, f64::max)
}

/// Returns a ball between two mirror walls, as the chapter about reflection has them: the
/// walls reflect nine tenths of the light.
fn facing_mirrors() -> (Scene, Camera) {
    let plain = |texture| Surface {
        texture,
        ambient: 0.1,
        diffuse: 0.8,
        specular: 0.3,
        shininess: 50,
    };
    let mirror = Surface {
        texture: Texture::Solid(DVec3::splat(0.9)),
        ambient: 0.02,
        diffuse: 0.03,
        specular: 0.0,
        shininess: 1,
    };
    let object = |shape, surface, reflectivity| Object {
        shape,
        surface,
        optics: Optics::Opaque(reflectivity),
    };
    let plane = |point, normal| Shape::Plane { point, normal };
    let ball = Shape::Sphere {
        centre: dvec3(0.0, 0.8, 0.3),
        radius: 0.8,
    };
    let checker = Texture::Checker(DVec3::splat(0.1), DVec3::splat(0.9));
    let red = Texture::Solid(dvec3(0.9, 0.15, 0.1));
    let scene = Scene {
        objects: vec![
            object(plane(DVec3::ZERO, DVec3::Y), plain(checker), 0.0),
            object(plane(3.0 * DVec3::NEG_X, DVec3::X), mirror, 0.9),
            object(plane(3.0 * DVec3::X, DVec3::NEG_X), mirror, 0.9),
            object(ball, plain(red), 0.0),
        ],
        lights: vec![PointLight {
            position: dvec3(0.5, 5.0, -2.0),
            intensity: 0.9,
        }],
        background: dvec3(0.2, 0.5, 0.8),
    };
    let eye = dvec3(2.7, 1.9, -1.6);
    let camera = Camera::upright(eye, dvec3(-3.0, 0.9, 0.7) - eye, 1.5);
    (scene, camera)
}

/// Between mirrors of 0.9 all that is beyond depth D is 0.9ᴰ of the rest.
#[test]
#[expect(clippy::disallowed_methods, reason = "the bound")]
fn facing_mirrors_converge_to_depth_100_and_beyond() {
    let (scene, camera) = facing_mirrors();
    let at_depth = |bounces| {
        let limit = Limit {
            bounces,
            min_throughput: 0.0,
        };
        picture(&scene, &camera, limit, 1)
    };
    let deepest = at_depth(800);
    for bounces in [25, 50, 100, 200, 400] {
        let difference = largest_difference(&at_depth(bounces), &deepest);
        let bound = 0.9_f64.powi(bounces as i32);
        assert!(difference <= bound + 1e-15, "{bounces}: {difference}");
        assert!(
            difference >= 1e-3 * bound || difference < 1e-15,
            "{bounces}: {difference}"
        );
    }
}

/// Four times the samples of an edge leave about a third of the error: N^(−3/4) is 0.35.
#[test]
fn the_still_life_converges_with_the_samples() {
    let scene = oracle::still_life_with_glass(Glass::Reflects);
    let camera = oracle::still_life_camera();
    let limit = Limit {
        bounces: 200,
        min_throughput: 1e-6,
    };
    let [two, four, eight, sixteen] =
        [2, 4, 8, 16].map(|n| picture(&scene, &camera, limit, n));
    let rms = |a: &[DVec3], b: &[DVec3]| {
        let squares = a.iter().zip(b).map(|(a, b)| a.distance_squared(*b));
        (squares.sum::<f64>() / a.len() as f64).sqrt()
    };
    let steps = [rms(&two, &four), rms(&four, &eight), rms(&eight, &sixteen)];
    for pair in steps.windows(2) {
        let ratio = pair[1] / pair[0];
        assert!((0.2..0.6).contains(&ratio), "{steps:?}");
    }
}
