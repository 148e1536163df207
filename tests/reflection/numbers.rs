//! The numbers that the chapter's page quotes. They guard the page, not the truth: the code
//! under test has written them.

use crate::laws::ambient_mirror;
use ::plane_hit::{Object, Plane, Shape, Texture};
use ::ray_casting::{Ray, SKY};
use ::reflection::scene::{facing_mirrors, still_life_mirrors};
use ::reflection::{
    Mirror, PathBudget, STAGE, bounce_inside, reflect, reflect_unnormalized, trace,
};
use ::shadows::Scene;
use ::shadows::scene::lit_still_life;
use ::sphere_hit::Sphere;
use glam::Vec3;
use harness::{
    HERO, Numbers, chapter, render, table, three_digits, triple, with_separators,
};

#[test]
fn the_numbers_are_those_in_the_book() {
    let mut numbers = Numbers::default();
    let still_life = lit_still_life(still_life_mirrors());
    let reflecting = |object: &&Object<Mirror>| object.material.reflectivity > 0.0;
    let mirrors = still_life.objects.iter().filter(reflecting);
    numbers.note("mirrors", table(mirrors.map(surface)));
    let (facing, _) = facing_mirrors(0.9);
    let objects = facing.objects.iter();
    let lights = facing.lights.iter().map(|light| {
        let place = format!(
            "at {}, of intensity {}",
            triple(light.position),
            light.intensity
        );
        ["light".to_string(), place]
    });
    let places = objects.clone().map(place).chain(lights);
    numbers.note("facing-places", table(places));
    numbers.note("facing-surfaces", table(objects.map(surface)));
    let (start, theta) = head_on();
    numbers.note("growth", growth(start));
    numbers.note("growth-angle", format!("{:.1}°", theta.to_degrees()));
    let cos_theta = start
        .direction
        .as_dvec3()
        .normalize()
        .dot(-start.origin.as_dvec3());
    let cos2 = cos_theta * cos_theta;
    numbers.note("growth-factor", format!("{:.1}", 1.0 + 16.0 * cos2 * cos2));
    numbers.note("corridor", table([0, 1, 5, 10, 50].map(corridor)));
    let rays = render(&STAGE, "bouncing", HERO).rays;
    numbers.note("rays", with_separators(rays));
    let before = &::shading::STAGE;
    let anchor = format!("rays-of-{}", chapter(before).replace(' ', "-"));
    let rays = render(before, "combined", HERO).rays;
    numbers.note(&anchor, with_separators(rays));
    numbers.check(STAGE.name);
}

/// Returns an object's name and the numbers of its surface.
fn surface(object: &Object<Mirror>) -> [String; 7] {
    let Mirror {
        phong,
        reflectivity,
    } = object.material;
    let colour = match phong.colour {
        Texture::Solid(colour) => triple(colour),
        Texture::Checker(even, odd) => format!("{} and {}", triple(even), triple(odd)),
    };
    [
        object.name.to_string(),
        colour,
        phong.ambient.to_string(),
        phong.diffuse.to_string(),
        phong.specular.to_string(),
        phong.shininess.to_string(),
        reflectivity.to_string(),
    ]
}

/// Returns an object's name and where it is.
fn place(object: &Object<Mirror>) -> [String; 2] {
    let place = match object.shape {
        Shape::Sphere(Sphere { centre, radius }) => {
            format!("sphere, centre {}, radius {radius}", triple(centre))
        }
        Shape::Plane(Plane { point, normal, .. }) => {
            format!("plane through {}, normal {}", triple(point), triple(normal))
        }
    };
    [object.name.to_string(), place]
}

/// Returns a ray that hits a mirror sphere of radius 1 from within, nearly head-on, and its angle
/// to the normal, in radians.
fn head_on() -> (Ray, f64) {
    let start = Vec3::new(0.3, 0.5, 0.8).normalize();
    let aside = 0.1 * start.any_orthonormal_vector();
    let start = Ray {
        origin: start,
        direction: (aside - start).normalize(),
    };
    let inwards = -start.origin.as_dvec3();
    (start, inwards.angle_between(start.direction.as_dvec3()))
}

/// Returns the error in a direction's length, bounce by bounce, inside a mirror sphere of
/// radius 1.
fn growth(start: Ray) -> String {
    let sphere = Sphere {
        centre: Vec3::ZERO,
        radius: 1.0,
    };
    let error = |ray: &Ray| (ray.direction.as_dvec3().length() - 1.0).abs();
    let (mut textbook, mut stable) = (start, start);
    table((1..=6).map(|bounces| {
        let before = error(&textbook);
        textbook = bounce_inside(&sphere, &textbook, reflect_unnormalized);
        stable = bounce_inside(&sphere, &stable, reflect);
        let grown = format!("{:.1}", error(&textbook) / before);
        // The first error is that of rounding the start.
        let grown = if bounces == 1 {
            "–".to_string()
        } else {
            grown
        };
        [
            bounces.to_string(),
            three_digits(error(&textbook)),
            grown,
            three_digits(error(&stable)),
        ]
    }))
}

/// Returns the radiance between two facing mirrors with ambient light, by the closed form and
/// by `trace`.
fn corridor(depth: u32) -> [String; 3] {
    let wall = |z: f32| Object {
        name: "wall",
        shape: Shape::plane(z * Vec3::Z, -z * Vec3::Z),
        material: ambient_mirror(0.9),
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
    let budget = PathBudget {
        min_throughput: 0.0,
        ..PathBudget::new(depth)
    };
    let traced = trace(&scene, &ray, budget).x;
    let power = (0..=depth).fold(1.0, |power: f64, _| 0.9 * power);
    let closed = 0.1 * (1.0 - power) / (1.0 - 0.9);
    [
        depth.to_string(),
        format!("{closed:.6}"),
        format!("{traced:.6}"),
    ]
}
