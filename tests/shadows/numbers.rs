//! The numbers that the chapter's page quotes. They guard the page, not the truth: the code
//! under test has written them.

use ::canvas::Pixel;
use ::plane_hit::scene::STILL_LIFE_COLOURS;
use ::plane_hit::{Object, Plane, Shape, nearest};
use ::ray_casting::SKY;
use ::ray_casting::scene::still_life_camera;
use ::shadows::scene::{light_between_balls, lit_still_life};
use ::shadows::{
    Interaction, PointLight, STAGE, Scene, is_visible, is_visible_buggy, trace,
};
use ::sphere_hit::Sphere;
use glam::Vec3;
use harness::{
    HERO, Numbers, SMALL, edge_of_shadow, percent, ray_counts, render, table,
    three_digits, triple, with_separators,
};
use oracle::exact;

#[test]
fn the_numbers_are_those_in_the_book() {
    let mut numbers = Numbers::default();
    let lights = ["first", "second"]
        .into_iter()
        .zip(lit_still_life([(); 6]).lights);
    numbers.note(
        "lights",
        table(lights.map(|(name, light)| {
            [
                name.to_string(),
                triple(light.position),
                light.intensity.to_string(),
            ]
        })),
    );
    let (between, _) = light_between_balls();
    let objects = between.objects.iter();
    numbers.note(
        "between-objects",
        table(objects.map(|object| [object.name.to_string(), place(&object.shape)])),
    );
    let [light] = between.lights[..] else {
        panic!("one light");
    };
    numbers.note("between-light", triple(light.position));
    numbers.note("differing-still-life", differing_still_life());
    let [buggy, cured] =
        ["beyond-buggy", "beyond"].map(|view| render(&STAGE, view, SMALL).radiance);
    let differing = buggy.iter().zip(&cured).filter(|(a, b)| a != b).count();
    numbers.note(
        "differing-beyond",
        format!(
            "{} of {}",
            with_separators(differing as u64),
            with_separators(cured.len() as u64)
        ),
    );
    numbers.note("exact-radius", format!("{:.4}", 1.25_f64.sqrt()));
    let scales = [1e-3, 1e-2, 0.1, 1.0, 1e3];
    numbers.note(
        "scales",
        table(scales.map(|scale: f32| {
            let radius = f64::from(shadow_radius(scale)) / f64::from(scale);
            [scale.to_string(), format!("{radius:.4}")]
        })),
    );
    numbers.note("rays", ray_counts(&STAGE, ["none", "hard"]));
    let hard = render(&STAGE, "hard", HERO).radiance;
    let dark = hard
        .iter()
        .filter(|&&radiance| radiance == Vec3::ZERO)
        .count();
    numbers.note("dark", percent(dark, hard.len()));
    let [off_surface, along_floor, farthest] = rounding_of_hits();
    numbers.note("off-surface", three_digits(off_surface));
    numbers.note("along-floor", three_digits(along_floor));
    numbers.note("farthest", with_separators(farthest as u64));
    numbers.check(STAGE.name);
}

/// Returns what a shape is, and where.
fn place(shape: &Shape) -> String {
    match *shape {
        Shape::Sphere(Sphere { centre, radius }) => {
            format!("sphere, centre {}, radius {radius}", triple(centre))
        }
        Shape::Plane(Plane { point, normal, .. }) => {
            format!("plane through {}, normal {}", triple(point), triple(normal))
        }
    }
}

/// Returns how far rounding moves a camera ray's hit of the still life, from the exact hit of the
/// same ray, at right angles to the surface at most, and along the floor; and the distance of the
/// farthest.
fn rounding_of_hits() -> [f64; 3] {
    let objects = lit_still_life([(); 6]).objects;
    let camera = still_life_camera();
    let mut most = [0.0_f64; 3];
    for ray in Pixel::all(HERO).map(|pixel| camera.ray(pixel.centre())) {
        let Some((index, t)) = nearest(&objects, &ray) else {
            continue;
        };
        let point = ray.at(t).as_dvec3();
        let (off, along) = match objects[index].shape {
            Shape::Sphere(Sphere { centre, radius }) => {
                let distance = point.distance(centre.as_dvec3());
                (distance - f64::from(radius), 0.0)
            }
            Shape::Plane(Plane {
                point: on_it,
                normal,
                ..
            }) => {
                let t = exact::plane(ray.origin, ray.direction, on_it, normal);
                let direction = ray.direction.as_dvec3();
                let exact = ray.origin.as_dvec3() + t.expect("a hit") * direction;
                let off = point - exact;
                (off.y, off.x.hypot(off.z))
            }
        };
        for (most, here) in most.iter_mut().zip([off, along, f64::from(t)]) {
            *most = most.max(here.abs());
        }
    }
    most
}

/// Returns the number of pixels of the still life that the buggy shadow changes.
fn differing_still_life() -> String {
    let camera = still_life_camera();
    let scene = lit_still_life(STILL_LIFE_COLOURS);
    let differing = Pixel::all(HERO).filter(|pixel| {
        let ray = camera.ray(pixel.centre());
        trace(&scene, &ray, is_visible) != trace(&scene, &ray, is_visible_buggy)
    });
    let [differing, all] = [differing.count() as u64, u64::from(HERO.x * HERO.y)];
    format!("{} of {}", with_separators(differing), with_separators(all))
}

/// Returns the radius of the shadow of a ball of radius `scale` on a floor, by a light 10
/// of its radii above.
fn shadow_radius(scale: f32) -> f32 {
    let object = |shape| Object {
        name: "",
        shape,
        material: (),
    };
    let ball = Shape::sphere(scale * Vec3::Y, scale);
    let floor = Shape::plane(Vec3::ZERO, Vec3::Y);
    let scene = Scene {
        objects: vec![object(ball), object(floor)],
        lights: vec![],
        background: SKY,
    };
    let light = PointLight {
        position: 10.0 * scale * Vec3::Y,
        intensity: 1.0,
    };
    edge_of_shadow(2.0 * scale, |x| {
        let at = Interaction {
            index: 1,
            shape: floor,
            t: 1.0,
            point: x * Vec3::X,
            incident: Vec3::NEG_Y,
            outward: Vec3::Y,
            normal: Vec3::Y,
        };
        is_visible(&scene, &at, &light)
    })
}
