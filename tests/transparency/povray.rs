//! Bodies of glass half in the water against POV-Ray's.

use ::plane_hit::{Object, Shape, Texture};
use ::ray_casting::{Camera, SKY};
use ::reflection::{MAX_DEPTH, PathBudget};
use ::refraction::{Material, Optics};
use ::shading::Phong;
use ::shadow_acne::from_eye;
use ::shadows::{PointLight, Scene};
use ::transparency::{Absorbing, STAGE, between_media, trace};
use canvas::{Canvas, Picture};
use glam::{Vec3, vec3};
use harness::SMALL;
use harness::povray::assert_water;

/// Returns the scene of `tests/povray/water.pov`, and its camera.
fn water() -> (Scene<Absorbing>, Camera) {
    let object = |shape, phong, optics, absorption| Object {
        name: "",
        shape,
        material: Absorbing {
            material: Material { phong, optics },
            absorption,
        },
    };
    let opaque = |shape, colour, specular, reflectivity| {
        let phong = Phong {
            colour,
            ambient: 0.1,
            diffuse: 0.8,
            specular,
            shininess: 50,
        };
        object(shape, phong, Optics::Opaque { reflectivity }, Vec3::ZERO)
    };
    let clear = |shape, eta_inside, absorption| {
        let phong = Phong {
            colour: Texture::Solid(Vec3::ONE),
            ambient: 0.0,
            diffuse: 0.0,
            specular: 0.8,
            shininess: 200,
        };
        let optics = Optics::Dielectric {
            eta_inside,
            eta_outside: 1.0,
        };
        object(shape, phong, optics, absorption)
    };
    let level = |height| Shape::plane(height * Vec3::Y, Vec3::Y);
    let ball = |x, y, z, radius| Shape::sphere(vec3(x, y, z), radius);
    let checker = Texture::Checker(Vec3::splat(0.15), Vec3::splat(0.85));
    let red = Texture::Solid(vec3(0.9, 0.15, 0.1));
    let objects = vec![
        opaque(level(-1.6), checker, 0.0, 0.0),
        opaque(ball(1.1, -0.9, 1.2, 0.7), red, 0.5, 0.3),
        clear(level(0.0), 1.33, vec3(0.5, 0.15, 0.1)),
        clear(ball(-0.9, 0.1, 0.3, 0.9), 1.5, vec3(0.3, 0.1, 0.5)),
        clear(ball(-0.8, 0.25, 0.2, 0.45), 1.0, Vec3::ZERO),
        clear(ball(0.8, 0.15, -0.9, 0.5), 1.7, vec3(0.1, 0.6, 0.6)),
        clear(ball(1.3, 0.35, -0.8, 0.45), 1.31, Vec3::ZERO),
    ];
    let light = |x, y, z, intensity| {
        PointLight::new(vec3(x, y, z), intensity).expect("a valid light")
    };
    let lights = vec![light(-3.0, 6.0, -4.0, 0.6), light(4.0, 5.0, -2.0, 0.5)];
    let scene = Scene::new(objects, lights, SKY).expect("seven surfaces");
    let eye = vec3(0.0, 2.3, -6.0);
    let camera = Camera::new(eye, -eye, Vec3::Y, 1.0 + 2.0_f32.sqrt());
    (scene, camera.expect("a camera"))
}

/// The pixels that differ are at edges. If every surface bent light as if its body were alone, the mean would be 2
/// levels, and 9.6 % of the pixels would differ.
#[test]
fn glass_in_the_water_is_as_povray_renders_it() {
    let (scene, camera) = water();
    let picture = Picture::new(move |pixel| {
        let ray = from_eye(&scene.objects, camera.eye)(camera.ray(pixel.centre()));
        trace(&scene, &ray, PathBudget::new(MAX_DEPTH), between_media)
    });
    let radiance = Canvas::render(&picture, SMALL).radiance;
    let ours: Vec<_> = radiance.iter().map(|v| v.as_dvec3()).collect();
    assert_water(STAGE.name, [0.0015, 1.5e-4], &ours);
}
