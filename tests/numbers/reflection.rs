use super::*;
use ::plane_hit::{Object, Pattern, Plane, Shape};
use ::ray_casting::{Ray, SKY};
use ::reflection::{
    Mirror, Reach, STAGE, bounce_inside, reflect, reflect_by_slide, trace,
};
use ::shading::Phong;
use ::shadows::Scene;
use ::sphere_hit::Sphere;

#[test]
fn the_numbers_are_those_in_the_book() {
    let mut numbers = Numbers::default();
    numbers.note("growth", growth());
    numbers.note("corridor", table([0, 1, 5, 10, 50].map(corridor)));
    numbers.note("rays", paint(&STAGE, "bouncing", HERO).rays);
    let before = paint(&::shading::STAGE, "combined", HERO).rays;
    numbers.note("rays-of-chapter-5", before);
    numbers.check("06-reflection");
}

/// How the length of a direction departs from 1, bounce by bounce, inside a mirror sphere that the
/// ray meets nearly head-on.
fn growth() -> String {
    let sphere = Sphere {
        centre: Vec3::ZERO,
        radius: 1.0,
    };
    let start = Vec3::new(0.3, 0.5, 0.8).normalize();
    let aside = 0.1 * start.any_orthonormal_vector();
    let start = Ray {
        origin: start,
        direction: (aside - start).normalize(),
    };
    let error = |ray: &Ray| (ray.direction.as_dvec3().length() - 1.0).abs();
    let (mut by_slide, mut stable) = (start, start);
    table((1..=6).map(|bounces| {
        let before = error(&by_slide);
        by_slide = bounce_inside(&sphere, &by_slide, reflect_by_slide);
        stable = bounce_inside(&sphere, &stable, reflect);
        let grown = error(&by_slide) / before;
        [
            bounces.to_string(),
            three_digits(error(&by_slide)),
            format!("{grown:.1}"),
            three_digits(error(&stable)),
        ]
    }))
}

/// Two facing mirrors with a light of their own, by the closed form and by `trace`.
fn corridor(depth: u32) -> [String; 3] {
    let material = Mirror {
        phong: Phong {
            colour: Pattern::Plain(Vec3::ONE),
            ambient: 0.1,
            diffuse: 0.0,
            specular: 0.0,
            shininess: 1,
        },
        reflectivity: 0.9,
    };
    let wall = |z: f32| Object {
        name: "wall",
        shape: Shape::Plane(Plane::new(z * Vec3::Z, -z * Vec3::Z).expect("a plane")),
        material,
    };
    let scene = Scene {
        objects: vec![wall(-1.0), wall(1.0)],
        lights: vec![],
        background: SKY,
    };
    let ray = Ray {
        origin: Vec3::ZERO,
        direction: Vec3::Z,
    };
    let reach = Reach {
        least_weight: 0.0,
        ..Reach::new(depth)
    };
    let traced = trace(&scene, &ray, reach).x;
    let mirrored = (0..=depth).fold(1.0, |power: f64, _| 0.9 * power);
    let closed = 0.1 * (1.0 - mirrored) / (1.0 - 0.9);
    [
        depth.to_string(),
        format!("{closed:.6}"),
        format!("{traced:.6}"),
    ]
}
