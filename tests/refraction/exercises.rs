//! The exercises' checks. Yours are judged by name:
//! `cargo test --test refraction exercise_1 -- --ignored`.

use crate::solutions;
use ::canvas::{Picture, Pixel};
use ::plane_hit::{Object, Shape};
use ::ray_casting::scene::still_life_camera;
use ::ray_casting::{Camera, Ray};
use ::reflection::scene::still_life_mirrors;
use ::reflection::{MAX_DEPTH, PathBudget, reflect};
use ::refraction::scene::{AIR, GLASS, close_up, opaque, still_life_with_glass};
use ::refraction::{
    Interface, Material, Optics, STAGE, Transmission, exercises, refract_or_reflect,
    trace,
};
use ::shadows::scene::lit_still_life;
use ::shadows::{Interaction, PointLight, Scene};
use ::sphere_hit::T_MAX;
use glam::{UVec2, Vec3};
use harness::{
    Numbers, SMALL, assert_close, check_solution, judge, three_digits, with_separators,
};

/// Returns the indices that a ray finds on its own side of a surface, and on the far one.
fn indices(object: &Object<Material>, origin: Vec3, direction: Vec3) -> Interface {
    let ray = Ray { origin, direction };
    let t = object.shape.distance(&ray, T_MAX);
    let t = t.unwrap_or_else(|| panic!("{ray:?} misses the {}", object.name));
    let at = Interaction::new(std::slice::from_ref(object), &ray, (0, t));
    let Optics::Dielectric {
        eta_inside,
        eta_outside,
    } = object.material.optics
    else {
        panic!("the {} is opaque", object.name);
    };
    Interface::new(&at, eta_inside, eta_outside)
}

fn check_1(sea: fn() -> Object<Material>) {
    let sea = sea();
    for slant in [Vec3::ZERO, 0.5 * Vec3::X, 2.0 * Vec3::NEG_Z] {
        let origin = Vec3::new(3.0, 0.2, -1.0);
        let up = (Vec3::Y + slant).normalize();
        let ray = Ray {
            origin,
            direction: up,
        };
        let t = sea.shape.distance(&ray, T_MAX).unwrap_or(f32::NAN);
        assert_close(
            "where a ray from below arrives",
            ray.at(t).with_x(0.0).with_z(0.0),
            Vec3::Y,
        );
        let from_below = indices(&sea, origin, up);
        assert_eq!(
            (from_below.eta_i, from_below.eta_t),
            (1.33, AIR),
            "from below"
        );
        let from_above = indices(&sea, ray.at(2.0 * t), -up);
        assert_eq!(
            (from_above.eta_i, from_above.eta_t),
            (AIR, 1.33),
            "from above"
        );
    }
}

fn check_2(bubble: fn(f32) -> Object<Material>) {
    let centre = Vec3::new(0.9, 0.6, -1.2);
    for radius in [0.3, 0.59] {
        let bubble = bubble(radius);
        assert_eq!(bubble.shape, Shape::sphere(centre, radius));
        let outside = centre - Vec3::Z;
        let entering = indices(&bubble, outside, Vec3::Z);
        assert_eq!(
            (entering.eta_i, entering.eta_t),
            (GLASS, AIR),
            "entering it"
        );
        let leaving = indices(&bubble, centre, Vec3::Z);
        assert_eq!((leaving.eta_i, leaving.eta_t), (AIR, GLASS), "leaving it");
    }
}

fn check_4(dispersed: fn(&[Scene<Material>; 3], &Ray, PathBudget) -> Vec3) {
    let scenes = [1.3, 1.5, 2.0].map(|index| still_life_with_glass(index, AIR));
    let budget = PathBudget::new(8);
    for pixel in Pixel::all(UVec2::new(24, 18)) {
        let ray = close_up().ray(pixel.centre());
        let yours = dispersed(&scenes, &ray, budget);
        for (channel, scene) in scenes.iter().enumerate() {
            let right = trace(scene, &ray, budget, refract_or_reflect)[channel];
            assert_eq!(yours[channel], right, "channel {channel} of {pixel:?}");
        }
    }
}

#[test]
#[ignore = "an exercise for you"]
fn exercise_1() {
    check_1(exercises::sea);
}

#[test]
#[ignore = "an exercise for you"]
fn exercise_2() {
    check_2(exercises::bubble_in_glass);
}

#[test]
#[ignore = "an exercise for you"]
fn exercise_4() {
    check_4(exercises::trace_dispersed);
}

#[test]
fn the_exercises_are_judged_rightly() {
    let source = include_str!("../../chapters/07-refraction/src/exercises.rs");
    judge(source, "sea", exercise_1, || check_1(solutions::sea));
    judge(source, "bubble_in_glass", exercise_2, || {
        check_2(solutions::bubble_in_glass);
    });
    judge(source, "trace_dispersed", exercise_4, || {
        check_4(solutions::trace_dispersed);
    });
    // The other way round, with the normal downwards, is right as well.
    check_1(|| Object {
        shape: Shape::plane(Vec3::Y, Vec3::NEG_Y),
        material: Material {
            optics: Optics::Dielectric {
                eta_inside: AIR,
                eta_outside: 1.33,
            },
            ..solutions::sea().material
        },
        ..solutions::sea()
    });
}

fn picture_of(
    scene: Scene<Material>,
    camera: Camera,
    transmission: Transmission,
) -> Picture {
    let budget = PathBudget::new(MAX_DEPTH);
    Picture::new(move |pixel| {
        trace(&scene, &camera.ray(pixel.centre()), budget, transmission)
    })
}

/// `refract_or_reflect` without the last step of `refract`, which makes the result a unit
/// vector.
fn without_the_last_step(at: &Interaction, inside: f32, outside: f32) -> (f32, Vec3) {
    let Interface { eta_i, eta_t } = Interface::new(at, inside, outside);
    let (eta, cos_theta_i) = (eta_i / eta_t, -at.normal.dot(at.incident));
    let tangential = at.incident + cos_theta_i * at.normal;
    let cos2_theta_t = 1.0 - eta * eta * tangential.dot(tangential);
    if cos2_theta_t > 0.0 {
        (1.0, eta * tangential - cos2_theta_t.sqrt() * at.normal)
    } else {
        (1.0, reflect(at.incident, at.normal))
    }
}

#[test]
fn the_solutions_are_those_in_the_book() {
    let mut under_water = lit_still_life(still_life_mirrors().map(opaque));
    under_water.objects.push(solutions::sea());
    let eye = Vec3::new(0.0, 0.4, -5.0);
    under_water.lights = vec![PointLight::new(eye, 0.8).expect("a light")];
    let upwards = Vec3::new(0.0, 0.7, 1.0);
    let camera = Camera::new(eye, upwards, Vec3::Y, 0.8).expect("a camera");
    let picture = picture_of(under_water, camera, refract_or_reflect);
    check_solution(&STAGE, "exercise-1", &picture);
    for (name, radius) in [("exercise-2-thick", 0.4), ("exercise-2", 0.585)] {
        let mut nested = still_life_with_glass(GLASS, AIR);
        nested.objects.push(solutions::bubble_in_glass(radius));
        let picture = picture_of(nested, close_up(), refract_or_reflect);
        check_solution(&STAGE, name, &picture);
    }
    let scenes = [1.4, 1.5, 1.6].map(|index| still_life_with_glass(index, AIR));
    let dispersed = Picture::new(move |pixel| {
        let ray = close_up().ray(pixel.centre());
        solutions::trace_dispersed(&scenes, &ray, PathBudget::new(MAX_DEPTH))
    });
    check_solution(&STAGE, "exercise-4", &dispersed);

    let mut numbers = Numbers::default();
    let critical = (1.0 / 1.33_f64).asin().to_degrees();
    numbers.note("critical-of-water", format!("{}°", three_digits(critical)));
    let levels = |transmission| {
        let scene = still_life_with_glass(GLASS, AIR);
        let picture = picture_of(scene, still_life_camera(), transmission);
        let light = Pixel::all(SMALL).map(move |pixel| picture.radiance(pixel));
        light.map(::canvas::encode)
    };
    let pairs = levels(refract_or_reflect).zip(levels(without_the_last_step));
    let differing = pairs.filter(|(with, without)| with != without).count();
    numbers.note("without-last-step", with_separators(differing as u64));
    numbers.check("07-refraction-exercises");
}
