//! The numbers that the chapter's page quotes. They guard the page, not the truth: the code
//! under test has written them.

use ::shadow_acne::STAGE as LAST_STAGE;
use ::transparency::scene::{AMBER, pool};
use ::transparency::{Absorbing, STAGE, transmittance};
use canvas::Stage;
use glam::Vec3;
use harness::{
    HERO, Numbers, chapter, render, render_at, table, three_digits, triple, vector,
    with_separators,
};
use plane_hit::{Object, Shape, Texture};
use refraction::{Material, Optics};
use sphere_hit::Sphere;

#[test]
fn the_numbers_are_those_in_the_book() {
    let mut numbers = Numbers::default();
    let lengths = [0.1, 0.5, 1.2, 2.4];
    numbers.note(
        "transmittance",
        table(lengths.map(|length: f32| {
            let [red, green, blue] = transmittance(AMBER, length).to_array();
            [length, red, green, blue].map(|x| three_digits(f64::from(x)))
        })),
    );
    // On the floor, in the ball's shadow.
    let (x, y) = (610, 405);
    numbers.note("shadow-pixel", format!("({x}, {y})"));
    let levels = |stage: &Stage| {
        let canvas = render(stage, "still-life", HERO);
        let [red, green, blue] = canvas.levels[(y * HERO.x + x) as usize];
        format!("{red}, {green}, {blue}")
    };
    numbers.note("shadow-levels", levels(&STAGE));
    numbers.note("shadow-levels-before", levels(&LAST_STAGE));
    let row = |name: String, rays: u64| [name, with_separators(rays)];
    let before = render(&LAST_STAGE, "still-life", HERO).rays;
    let mut rows = vec![row(chapter(&LAST_STAGE), before)];
    for absorption in [0.0, 1.0, 4.0] {
        let rays = render_at(&STAGE, "still-life", absorption, HERO).rays;
        rows.push(row(format!("absorption {absorption}"), rays));
    }
    numbers.note("rays", table(rows));
    numbers.note("exp-error", exp_error());
    numbers.note("amber", triple(AMBER));
    note_pool(&mut numbers);
    numbers.check(STAGE.name);
}

/// Notes what is in the pool.
fn note_pool(numbers: &mut Numbers) {
    let (scene, camera) = pool();
    let row = |object: &Object<Absorbing>| {
        let place = match object.shape {
            Shape::Sphere(Sphere { centre, radius }) => {
                format!("sphere around {}, radius {radius}", triple(centre))
            }
            Shape::Plane(plane) => format!(
                "plane through {}, normal {}",
                triple(plane.point),
                triple(plane.normal)
            ),
        };
        let Absorbing {
            material,
            absorption,
        } = object.material;
        let substance = match (material.optics, material.phong.colour) {
            (Optics::Dielectric { eta_inside, .. }, _) => format!(
                "clear, index {eta_inside}, absorption {}",
                triple(absorption)
            ),
            (Optics::Opaque { .. }, Texture::Solid(colour)) => {
                format!("opaque, {}", triple(colour))
            }
            (Optics::Opaque { .. }, Texture::Checker(even, odd)) => {
                format!("opaque, {} and {}", triple(even), triple(odd))
            }
        };
        [object.name.to_string(), place, substance]
    };
    numbers.note("pool", table(scene.objects.iter().map(row)));
    let surface = |object: &Object<Absorbing>| {
        let Material { phong, optics } = object.material.material;
        let kind = match optics {
            Optics::Dielectric { .. } => "of what is clear",
            Optics::Opaque { .. } => "of what is opaque",
        };
        [
            kind.to_string(),
            three_digits(phong.ambient.into()),
            three_digits(phong.diffuse.into()),
            three_digits(phong.specular.into()),
            phong.shininess.to_string(),
        ]
    };
    let mut surfaces: Vec<_> = scene.objects.iter().map(surface).collect();
    surfaces.dedup();
    numbers.note("pool-surfaces", table(surfaces));
    let lights = scene.lights.iter();
    let lights =
        lights.map(|light| [triple(light.position), light.intensity.to_string()]);
    numbers.note("pool-lights", table(lights));
    numbers.note("pool-eye", triple(camera.eye));
    numbers.note("pool-forward", vector(&camera.forward.to_array()));
    numbers.note("pool-focal-length", camera.focal_length);
}

/// Returns the greatest relative error of the exponential, for transmittances that are not quite
/// black.
#[expect(clippy::disallowed_methods, reason = "f64 is the reference")]
fn exp_error() -> String {
    let errors = (0..100_000).map(|i| {
        let length = i as f32 / 10_000.0;
        let exact = (-f64::from(length)).exp();
        (f64::from(transmittance(Vec3::ONE, length).x) / exact - 1.0).abs()
    });
    three_digits(errors.fold(0.0, f64::max))
}
