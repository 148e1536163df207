//! The exercises' checks. Yours are judged by name:
//! `cargo test --test shading exercise_1 -- --ignored`.

use crate::solutions;
use ::canvas::{Picture, Pixel, encode};
use ::plane_hit::{Texture, nearest};
use ::ray_casting::Ray;
use ::ray_casting::scene::still_life_camera;
use ::shading::scene::still_life_surfaces;
use ::shading::views::still_life_of;
use ::shading::{Phong, STAGE, exercises, phong};
use ::shadows::scene::lit_still_life;
use ::shadows::{Interaction, Scene, is_visible};
use glam::{UVec2, Vec3};
use harness::{Numbers, SMALL, assert_close, check_solution, judge, with_separators};

/// The function that returns what a surface reflects of one light.
type Reflected = fn(&Phong, Vec3, &Interaction, Vec3) -> Vec3;

fn interaction(scene: &Scene<Phong>, ray: &Ray) -> Option<Interaction> {
    let hit = nearest(&scene.objects, ray)?;
    Some(Interaction::new(&scene.objects, ray, hit))
}

fn check_1(surfaces: fn() -> [Phong; 6]) {
    let powers = [1, 5, 20, 80, 320, 1280];
    let right = still_life_surfaces().into_iter().zip(powers);
    for (yours, (ours, shininess)) in surfaces().into_iter().zip(right) {
        assert_eq!(yours, Phong { shininess, ..ours });
    }
}

#[expect(clippy::disallowed_methods, reason = "the definition, in f64")]
fn check_2(reflected: Reflected) {
    let scene = lit_still_life(still_life_surfaces());
    let camera = still_life_camera();
    let mut highlights = 0;
    for pixel in Pixel::all(UVec2::new(80, 60)) {
        let Some(at) = interaction(&scene, &camera.ray(pixel.centre())) else {
            continue;
        };
        let surface = &scene.objects[at.index].material;
        let colour = Vec3::new(0.9, 0.5, 0.1);
        for light in scene.lights.iter().filter(|it| at.is_in_front(it.position)) {
            let to_light = (light.position - at.point).normalize();
            let [n, l, v] = [at.normal, to_light, -at.incident].map(|it| it.as_dvec3());
            let half = (l + v).normalize();
            let power = n.dot(half).max(0.0).powi(surface.shininess as i32);
            highlights += usize::from(power > 0.1);
            let diffuse = f64::from(surface.diffuse) * n.dot(l).max(0.0);
            let specular = f64::from(surface.specular) * power;
            let right = diffuse * colour.as_dvec3() + specular;
            let yours = reflected(surface, colour, &at, to_light);
            let error = (yours.as_dvec3() - right).length();
            assert!(error < 1e-3, "yours is {yours}, right is {right}: {at:?}");
        }
    }
    assert!(
        highlights > 10,
        "only {highlights} highlights were looked at"
    );
}

fn check_3(ambient: fn(Vec3, Vec3, Vec3) -> Vec3) {
    let (sky, ground) = (Vec3::new(0.2, 0.5, 0.8), Vec3::new(0.25, 0.2, 0.15));
    let light = |normal| ambient(sky, ground, normal);
    assert_close("facing upwards", light(Vec3::Y), sky);
    assert_close("facing downwards", light(Vec3::NEG_Y), ground);
    for normal in [Vec3::X, Vec3::NEG_Z, Vec3::new(0.6, 0.0, 0.8)] {
        assert_close("facing sideways", light(normal), (sky + ground) / 2.0);
    }
    let leaning = light(Vec3::new(0.8, 0.6, 0.0));
    assert_close(
        "leaning upwards, y = 0.6",
        leaning,
        0.8 * sky + 0.2 * ground,
    );
    assert_close("of the same light", ambient(sky, sky, Vec3::X), sky);
}

#[test]
#[ignore = "an exercise for you"]
fn exercise_1() {
    check_1(exercises::five_shininesses);
}

#[test]
#[ignore = "an exercise for you"]
fn exercise_2() {
    check_2(exercises::blinn_phong);
}

#[test]
#[ignore = "an exercise for you"]
fn exercise_3() {
    check_3(exercises::ambient_from_around);
}

#[test]
fn the_exercises_are_judged_rightly() {
    let source = include_str!("../../chapters/05-shading/src/exercises.rs");
    judge(source, "five_shininesses", exercise_1, || {
        check_1(solutions::five_shininesses);
    });
    judge(source, "blinn_phong", exercise_2, || {
        check_2(solutions::blinn_phong);
    });
    judge(source, "ambient_from_around", exercise_3, || {
        check_3(solutions::ambient_from_around);
    });
}

/// Returns the picture of the still life with what `reflected` returns for each light that is
/// visible, and the ambient light that `ambient` returns for a normal.
fn still_life_by(
    surfaces: [Phong; 6],
    reflected: Reflected,
    ambient: fn(Vec3) -> Vec3,
) -> Picture {
    let camera = still_life_camera();
    let scene = lit_still_life(surfaces);
    Picture::new(move |pixel| {
        let Some(at) = interaction(&scene, &camera.ray(pixel.centre())) else {
            return scene.background;
        };
        let surface = &scene.objects[at.index].material;
        let colour = surface.colour.value(at.uv());
        let lights = scene.lights.iter();
        let lights = lights.filter(|light| is_visible(&scene, &at, light));
        let radiance = lights.map(|light| {
            let to_light = (light.position - at.point).normalize();
            light.intensity * reflected(surface, colour, &at, to_light)
        });
        ambient(at.normal) * colour + radiance.sum::<Vec3>()
    })
}

#[test]
fn the_solutions_are_those_in_the_book() {
    let specular = solutions::five_shininesses().map(|surface| Phong {
        ambient: 0.0,
        diffuse: 0.0,
        colour: Texture::Solid(Vec3::ZERO),
        ..surface
    });
    let black = |_| Vec3::ZERO;
    let shininesses = still_life_by(specular, phong, black);
    check_solution(&STAGE, "exercise-1", &shininesses);
    let tenth = |_| Vec3::splat(0.1);
    let surfaces = still_life_surfaces();
    let blinn = still_life_by(surfaces, solutions::blinn_phong, tenth);
    check_solution(&STAGE, "exercise-2", &blinn);
    let around = still_life_by(surfaces, phong, |normal| {
        let (sky, ground) = (Vec3::new(0.2, 0.5, 0.8), Vec3::new(0.25, 0.2, 0.15));
        0.5 * solutions::ambient_from_around(sky, ground, normal)
    });
    check_solution(&STAGE, "exercise-3", &around);

    // The pixels with a highlight above 0.3, every ball with the same power and a k_s of 1.
    let mut numbers = Numbers::default();
    let highlight = |power: u32, reflected: Reflected| {
        let surfaces = specular.map(|surface| Phong {
            specular: if surface.specular > 0.0 { 1.0 } else { 0.0 },
            shininess: power,
            ..surface
        });
        let picture = still_life_by(surfaces, reflected, black);
        // The sky has less red.
        let is_bright = |pixel: &Pixel| picture.radiance(*pixel).x > 0.3;
        Pixel::all(SMALL).filter(is_bright).count().to_string()
    };
    numbers.note("phong-50", highlight(50, phong));
    numbers.note("blinn-50", highlight(50, solutions::blinn_phong));
    numbers.note("blinn-200", highlight(200, solutions::blinn_phong));
    let without_ambient = still_life_of(still_life_camera(), |surface| Phong {
        ambient: 0.0,
        specular: 0.0,
        ..surface
    });
    let lights = Pixel::all(SMALL).map(|pixel| without_ambient.radiance(pixel));
    let black: Vec<Vec3> = lights.filter(|&light| encode(light) == [0; 3]).collect();
    let unlit = black.iter().filter(|&&light| light == Vec3::ZERO).count();
    numbers.note("unlit", with_separators(unlit as u64));
    numbers.note("black", with_separators(black.len() as u64));
    numbers.check("05-shading-exercises");
}
