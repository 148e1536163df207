//! The numbers that the chapter's page quotes. They guard the page, not the truth: the code
//! under test has written them.

use ::canvas::Pixel;
use ::plane_hit::scene::{STILL_LIFE_COLOURS, still_life};
use ::plane_hit::{Object, Plane, STAGE, Shape, Texture, nearest};
use ::ray_casting::scene::still_life_camera;
use ::ray_casting::{Ray, SKY};
use ::sphere_hit::{Sphere, T_MAX};
use glam::Vec3;
use harness::{HERO, Numbers, SMALL, percent, render, table, triple, with_separators};

#[test]
fn the_numbers_are_those_in_the_book() {
    let mut numbers = Numbers::default();
    let camera = still_life_camera();
    let objects = still_life(STILL_LIFE_COLOURS);
    numbers.note("still-life", table(objects.iter().map(described)));
    let hit = |pixel: Pixel| {
        let (index, t) = nearest(&objects, &camera.ray(pixel.centre()))?;
        Some((objects[index].name, t))
    };
    let pixels = [
        (400, 10),
        (150, 290),
        (400, 220),
        (270, 340),
        (470, 340),
        (400, 590),
    ];
    numbers.note(
        "pixels",
        table(pixels.map(|(x, y)| {
            let (name, t) = hit(Pixel { x, y, size: HERO })
                .map_or(("sky", "—".to_string()), |(name, t)| {
                    (name, format!("{t:.3}"))
                });
            [format!("({x}, {y})"), name.to_string(), t]
        })),
    );
    let names: Vec<_> = Pixel::all(HERO).filter_map(hit).collect();
    numbers.note(
        "objects",
        table(objects.iter().map(|object| {
            let pixels = names.iter().filter(|(name, _)| *name == object.name);
            [
                object.name.to_string(),
                with_separators(pixels.count() as u64),
            ]
        })),
    );
    let rays = render(&STAGE, "flat", HERO).rays;
    numbers.note("rays", with_separators(rays));

    let [in_space, in_plane] = ["checker-in-space", "checker-in-plane"]
        .map(|view| render(&STAGE, view, SMALL).radiance);
    let floor = in_plane.iter().filter(|&&radiance| radiance != SKY).count();
    let wrong = in_plane.iter().zip(&in_space).filter(|(a, b)| a != b);
    numbers.note("wrong-cells", percent(wrong.count(), floor));

    numbers.note("offset", offset());
    numbers.check(STAGE.name);
}

/// Returns an object's name, its shape, the shape's size or direction, and its colour.
fn described(object: &Object<Texture>) -> [String; 4] {
    let [shape, size] = match object.shape {
        Shape::Sphere(Sphere { centre, radius }) => [
            format!("sphere around {}", triple(centre)),
            format!("radius {radius}"),
        ],
        Shape::Plane(Plane { point, normal, .. }) => [
            format!("plane through {}", triple(point)),
            format!("normal {}", triple(normal)),
        ],
    };
    let colour = match object.material {
        Texture::Solid(colour) => triple(colour),
        Texture::Checker(even, odd) => {
            format!("{} and {}", triple(even), triple(odd))
        }
    };
    [object.name.to_string(), shape, size, colour]
}

/// Returns the distance to a plane that is given by a point far from the ray: by the
/// chapter's formula, and by a stored offset.
fn offset() -> String {
    let normal = Vec3::new(0.6, 0.8, 0.0);
    let ray = Ray {
        origin: Vec3::new(3.0, 4.0, 0.0),
        direction: -normal,
    };
    let point = Vec3::new(-8e5, 6e5, 0.0);
    let plane = Plane::new(point, normal).expect("a plane");
    let t = plane.distance(&ray, T_MAX);
    let h = point.dot(normal);
    let stored = (h - ray.origin.dot(normal)) / ray.direction.dot(normal);
    table(
        [
            ["the point, x₀", t.expect("a hit").to_string().as_str()],
            ["the offset, m", stored.to_string().as_str()],
        ]
        .map(|row| row.map(str::to_string)),
    )
}
