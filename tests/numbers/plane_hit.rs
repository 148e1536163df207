use super::*;
use ::canvas::Pixel;
use ::plane_hit::views::STILL_LIFE_COLOURS;
use ::plane_hit::{Plane, STAGE, nearest, still_life};
use ::ray_casting::views::{STILL_LIFE_FOCAL_LENGTH, still_life_camera};
use ::ray_casting::{Ray, SKY};
use ::sphere_hit::FARTHEST;

#[test]
fn the_numbers_are_those_in_the_book() {
    let mut numbers = Numbers::default();
    let camera = still_life_camera(STILL_LIFE_FOCAL_LENGTH);
    let objects = still_life(STILL_LIFE_COLOURS);
    let met = |x, y| {
        let ray = camera.ray(Pixel { x, y, size: HERO }.centre());
        nearest(&objects, &ray).map(|(object, hit)| (object.name, hit.t))
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
            let (name, t) = met(x, y).map_or(("sky", "—".to_string()), |(name, t)| {
                (name, format!("{t:.3}"))
            });
            [format!("({x}, {y})"), name.to_string(), t]
        })),
    );
    let everywhere = (0..HERO.y).flat_map(|y| (0..HERO.x).map(move |x| (x, y)));
    let names: Vec<_> = everywhere.filter_map(|(x, y)| met(x, y)).collect();
    numbers.note(
        "objects",
        table(objects.iter().map(|object| {
            let pixels = names.iter().filter(|(name, _)| *name == object.name);
            [object.name.to_string(), pixels.count().to_string()]
        })),
    );
    numbers.note("rays", paint(&STAGE, "flat", HERO).rays);

    let [in_space, in_plane] = ["checker-in-space", "checker-in-plane"]
        .map(|view| paint(&STAGE, view, SMALL).light);
    let floor = in_plane.iter().filter(|&&light| light != SKY).count();
    let wrong = in_plane.iter().zip(&in_space).filter(|(a, b)| a != b);
    numbers.note("wrong-cells", percent(wrong.count(), floor));

    numbers.note("offset", offset());
    numbers.check("03-plane-hit");
}

/// The same plane by a point far from the ray: as the chapter has it, and by a stored offset.
fn offset() -> String {
    let normal = Vec3::new(0.6, 0.8, 0.0);
    let ray = Ray {
        origin: Vec3::new(3.0, 4.0, 0.0),
        direction: -normal,
    };
    let point = Vec3::new(-8e5, 6e5, 0.0);
    let hit = Plane { point, normal }.hit(&ray, FARTHEST);
    let h = point.dot(normal);
    let stored = (h - ray.origin.dot(normal)) / ray.direction.dot(normal);
    table(
        [
            ["the point, x₀", hit.expect("a hit").t.to_string().as_str()],
            ["the offset, h", stored.to_string().as_str()],
        ]
        .map(|row| row.map(str::to_string)),
    )
}
