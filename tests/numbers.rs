//! The numbers in the book. The error columns are measured against exact arithmetic or f64; none depends on the machine.

mod numbers_file;

use ::canvas::{Canvas, Stage};
use glam::{UVec2, Vec3};
use numbers_file::{Numbers, percent, three_digits};

const HERO: UVec2 = UVec2::new(800, 600);
const SMALL: UVec2 = UVec2::new(320, 240);

/// A view as it comes, at some size.
fn paint(stage: &Stage, view: &str, size: UVec2) -> Canvas {
    let view = &stage.views[stage.find(view).expect("a view of the stage")];
    Canvas::paint(&(view.picture)(view.default_setting()), size)
}

/// Rows of a Markdown table.
fn table<const N: usize>(rows: impl IntoIterator<Item = [String; N]>) -> String {
    let rows = rows
        .into_iter()
        .map(|row| format!("| {} |", row.join(" | ")));
    rows.collect::<Vec<_>>().join("\n")
}

fn vector(v: &[f32]) -> String {
    let numbers: Vec<_> = v.iter().map(|x| format!("{x:.3}")).collect();
    format!("({})", numbers.join(", ").replace('-', "−"))
}

/// The view, its rays and its shadow rays, for views that cast one camera ray for each pixel of a hero.
fn ray_counts<'a>(stage: &Stage, views: impl IntoIterator<Item = &'a str>) -> String {
    table(views.into_iter().map(|view| {
        let rays = paint(stage, view, HERO).rays;
        let shadow_rays = rays - u64::from(HERO.x * HERO.y);
        [view.to_string(), rays.to_string(), shadow_rays.to_string()]
    }))
}

/// The i-th of a sequence that fills the unit cube evenly.
///
/// Source: Martin Roberts, "The Unreasonable Effectiveness of Quasirandom Sequences" (2018).
fn evenly(i: usize) -> [f64; 3] {
    const STEPS: [f64; 3] = [
        0.819_172_513_396_164,
        0.671_043_606_703_789,
        0.549_700_477_901_97,
    ];
    STEPS.map(|step| (0.5 + step * i as f64).fract())
}

/// Three unit vectors at right angles to each other, evenly spread.
#[expect(clippy::disallowed_methods, reason = "no pixel depends on it")]
fn frame(i: usize) -> [glam::DVec3; 3] {
    let [height, turn, _] = evenly(i);
    let z = 2.0 * height - 1.0;
    let angle = std::f64::consts::TAU * turn;
    let level = (1.0 - z * z).sqrt();
    let a = glam::DVec3::new(level * angle.cos(), level * angle.sin(), z);
    let b = a.any_orthonormal_vector();
    [a, b, a.cross(b)]
}

mod canvas {
    use super::*;
    use ::canvas::{Pixel, encode};

    #[test]
    fn the_numbers_are_those_in_the_book() {
        let mut numbers = Numbers::default();
        let level = |light| encode(Vec3::splat(light))[0];
        numbers.note("half", level(0.5));
        numbers.note("levels-below-a-tenth", level(0.1));
        let lights = [0.0, 0.003_130_8, 0.1, 0.25, 0.5, 0.75, 1.0];
        numbers.note(
            "levels",
            table(lights.map(|light: f32| [light.to_string(), level(light).to_string()])),
        );
        let corner = |x, y| vector(&Pixel { x, y, size: HERO }.centre().to_array());
        numbers.note(
            "corners",
            format!("{} and {}", corner(0, 0), corner(799, 599)),
        );
        let stage = &::canvas::STAGE;
        let right = paint(stage, "half-light", SMALL).light[SMALL.x as usize - 1];
        assert_eq!(encode(right), [128; 3]);
        numbers.note("light-of-128", percent((1e6 * right.x) as usize, 1_000_000));
        numbers.note(
            "truncated",
            (0..=255).filter(|&level| changes(level)).count(),
        );
        numbers.check("00-canvas");
    }

    /// Whether a level, decoded to linear f32 light and encoded again, changes if it is not rounded.
    #[expect(clippy::disallowed_methods, reason = "f64 is the judge here")]
    fn changes(level: u8) -> bool {
        let encoded = f64::from(level) / 255.0;
        let light = if level <= 10 {
            encoded / 12.92
        } else {
            ((encoded + 0.055) / 1.055).powf(2.4)
        };
        let light = f64::from(light as f32);
        let again = if level <= 10 {
            12.92 * light
        } else {
            1.055 * light.powf(1.0 / 2.4) - 0.055
        };
        (255.0 * again) as u8 != level
    }
}

mod ray_casting {
    use super::*;
    use ::canvas::Pixel;
    use ::ray_casting::views::{STILL_LIFE_FOCAL_LENGTH, still_life_camera};
    use ::ray_casting::{SKY, STAGE};

    #[test]
    fn the_numbers_are_those_in_the_book() {
        let mut numbers = Numbers::default();
        let camera = still_life_camera(STILL_LIFE_FOCAL_LENGTH);
        let direction = |x, y| camera.ray(Pixel { x, y, size: HERO }.centre()).direction;
        let pixels = [(0, 0), (799, 0), (400, 300), (0, 599), (799, 599)];
        numbers.note(
            "directions",
            table(pixels.map(|(x, y)| {
                [format!("({x}, {y})"), vector(&direction(x, y).to_array())]
            })),
        );
        let canvas = paint(&STAGE, "sky-and-ground", HERO);
        numbers.note("rays", canvas.rays);
        let last_sky = canvas.light.iter().rposition(|&light| light == SKY);
        numbers.note("horizon", last_sky.expect("some sky") / HERO.x as usize);
        let errors = (0..HERO.y).flat_map(|y| (0..HERO.x).map(move |x| (x, y)));
        let errors =
            errors.map(|(x, y)| (direction(x, y).as_dvec3().length() - 1.0).abs());
        numbers.note("length-error", three_digits(errors.fold(0.0, f64::max)));
        numbers.note("epsilon", three_digits(f64::from(f32::EPSILON)));
        numbers.check("01-ray-casting");
    }
}

mod sphere_hit {
    use super::*;
    use ::ray_casting::Ray;
    use ::sphere_hit::{FARTHEST, Hit, Sphere};
    use oracle::exact;

    type Method = fn(&Sphere, &Ray, f32) -> Option<Hit>;

    const METHODS: [Method; 3] = [Sphere::hit_by_slide, Sphere::hit, Sphere::hit_in_f64];

    const SPHERE: Sphere = Sphere {
        centre: Vec3::ZERO,
        radius: 1.0,
    };

    fn exactly(ray: &Ray) -> Option<f64> {
        let [near, _] =
            exact::sphere(ray.origin, ray.direction, SPHERE.centre, SPHERE.radius)?;
        Some(near.t)
    }

    #[test]
    fn the_numbers_are_those_in_the_book() {
        let mut numbers = Numbers::default();
        let origins = [
            (0.0, 5.0),
            (1.0, 5.0),
            (1.0_f32.next_up(), 5.0),
            (0.5, 1e4),
            (1.5, 1e4),
            (0.5, 1e6),
        ];
        let or_miss = |t: Option<String>| t.unwrap_or("miss".to_string());
        numbers.note(
            "spots",
            table(origins.map(|(x, z)| {
                let ray = Ray {
                    origin: Vec3::new(x, 0.0, z),
                    direction: Vec3::NEG_Z,
                };
                let answer = exactly(&ray).map(|t| format!("{t:.6}"));
                let [slide, stable, in_f64] = METHODS.map(|hit| {
                    or_miss(hit(&SPHERE, &ray, FARTHEST).map(|hit| hit.t.to_string()))
                });
                [
                    format!("({x}, 0, {z})"),
                    or_miss(answer),
                    slide,
                    stable,
                    in_f64,
                ]
            })),
        );
        let distances = [1.5, 10.0, 100.0, 1e3, 1e4, 1e5, 1e6];
        numbers.note("distances", table(distances.map(row)));
        numbers.check("02-sphere-hit");
    }

    /// A distance, and each method's share of wrong answers and largest error there.
    fn row(distance: f64) -> [String; 7] {
        let rays: Vec<Ray> = (0..4000).map(|i| towards_the_sphere(distance, i)).collect();
        let answers: Vec<Option<f64>> = rays.iter().map(exactly).collect();
        let columns = METHODS.map(|hit| {
            let mut wrong = 0;
            let mut error: Option<f64> = None;
            for (ray, answer) in rays.iter().zip(&answers) {
                match (hit(&SPHERE, ray, FARTHEST), answer) {
                    (Some(hit), Some(t)) if approach(ray) <= 0.95 => {
                        let this = (f64::from(hit.t) - t).abs();
                        error = Some(error.map_or(this, |error| error.max(this)));
                    }
                    (hit, answer) => {
                        wrong += usize::from(hit.is_some() != answer.is_some())
                    }
                }
            }
            let error = error.map_or("—".to_string(), three_digits);
            [percent(wrong, rays.len()), error]
        });
        let [slide, stable, in_f64] = columns;
        let [a, b] = slide;
        let [c, d] = stable;
        let [e, f] = in_f64;
        [distance.to_string(), a, b, c, d, e, f]
    }

    fn approach(ray: &Ray) -> f64 {
        exact::approach(ray.origin, ray.direction, SPHERE.centre, SPHERE.radius)
    }

    /// A ray from a distance, aimed evenly at a disc of one and a half radii.
    fn towards_the_sphere(distance: f64, i: usize) -> Ray {
        let [out, across, _] = frame(i);
        let [.., spread] = evenly(i);
        let origin = (distance * out).as_vec3();
        let aim = 1.5 * spread.sqrt() * across;
        Ray {
            origin,
            direction: (aim.as_vec3() - origin).normalize(),
        }
    }
}

mod plane_hit {
    use super::*;
    use ::canvas::Pixel;
    use ::plane_hit::views::STILL_LIFE_COLOURS;
    use ::plane_hit::{Plane, STAGE, nearest, still_life};
    use ::ray_casting::views::{STILL_LIFE_FOCAL_LENGTH, still_life_camera};
    use ::ray_casting::{Ray, SKY};
    use ::sphere_hit::FARTHEST;
    use oracle::exact;

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
                let (name, t) = met(x, y)
                    .map_or(("sky", "—".to_string()), |(name, t)| {
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
        numbers.note("grazing", table([1e-1, 1e-2, 1e-3, 1e-4].map(grazing)));
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

    /// For planes of all inclinations, one below the eye: the largest relative error at some |d·n|.
    fn grazing(d_dot_n: f64) -> [String; 3] {
        let mut largest = 0.0_f64;
        for i in 0..4000 {
            let [up, along, _] = frame(i);
            let plane = Plane::new((-up).as_vec3(), up.as_vec3()).expect("a plane");
            let direction = along * (1.0 - d_dot_n * d_dot_n).sqrt() - d_dot_n * up;
            let ray = Ray {
                origin: Vec3::ZERO,
                direction: direction.as_vec3(),
            };
            let exact =
                exact::plane(ray.origin, ray.direction, plane.point, plane.normal);
            let exact = exact.expect("not parallel");
            let hit = plane.hit(&ray, FARTHEST).expect("a hit");
            largest = largest.max((f64::from(hit.t) / exact - 1.0).abs());
        }
        let bound = f64::from(f32::EPSILON) / d_dot_n;
        [
            d_dot_n.to_string(),
            three_digits(largest),
            three_digits(bound),
        ]
    }
}

mod shadows {
    use super::*;
    use ::canvas::Pixel;
    use ::plane_hit::views::STILL_LIFE_COLOURS;
    use ::plane_hit::{Object, Plane, Shape};
    use ::ray_casting::SKY;
    use ::ray_casting::views::{STILL_LIFE_FOCAL_LENGTH, still_life_camera};
    use ::shadows::views::lit_still_life;
    use ::shadows::{
        PointLight, STAGE, Scene, light_reaches, light_reaches_buggy, trace,
    };
    use ::sphere_hit::Sphere;

    #[test]
    fn the_numbers_are_those_in_the_book() {
        let mut numbers = Numbers::default();
        numbers.note("differing-still-life", differing_still_life());
        let [buggy, cured] =
            ["lamp-buggy", "lamp"].map(|view| paint(&STAGE, view, SMALL).light);
        let differing = buggy.iter().zip(&cured).filter(|(a, b)| a != b).count();
        numbers.note("differing-lamp", format!("{differing} of {}", cured.len()));
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
        let hard = paint(&STAGE, "hard", HERO).light;
        let dark = hard.iter().filter(|&&light| light == Vec3::ZERO).count();
        numbers.note("dark", percent(dark, hard.len()));
        numbers.check("04-shadows");
    }

    /// How many pixels of the still life the buggy shadow changes.
    fn differing_still_life() -> String {
        let camera = still_life_camera(STILL_LIFE_FOCAL_LENGTH);
        let scene = lit_still_life(STILL_LIFE_COLOURS);
        let pixels = (0..HERO.y).flat_map(|y| (0..HERO.x).map(move |x| (x, y)));
        let differing = pixels.filter(|&(x, y)| {
            let ray = camera.ray(Pixel { x, y, size: HERO }.centre());
            trace(&scene, &ray, light_reaches) != trace(&scene, &ray, light_reaches_buggy)
        });
        format!("{} of {}", differing.count(), HERO.x * HERO.y)
    }

    /// The radius of the shadow of a ball of radius `scale` on a floor, by a lamp 10 of its radii above.
    fn shadow_radius(scale: f32) -> f32 {
        let object = |shape| Object {
            name: "",
            shape,
            material: (),
        };
        let ball = Sphere::new(scale * Vec3::Y, scale).expect("a sphere");
        let floor = Plane::new(Vec3::ZERO, Vec3::Y).expect("a plane");
        let scene = Scene {
            objects: vec![object(Shape::Sphere(ball)), object(Shape::Plane(floor))],
            lights: vec![],
            background: SKY,
        };
        let light = PointLight {
            position: 10.0 * scale * Vec3::Y,
            intensity: 1.0,
        };
        let (mut dark, mut lit) = (0.0, 2.0 * scale);
        for _ in 0..30 {
            let middle = (dark + lit) / 2.0;
            if light_reaches(&scene, middle * Vec3::X, Vec3::Y, &light) {
                lit = middle;
            } else {
                dark = middle;
            }
        }
        lit
    }
}

mod shading {
    use super::*;
    use ::shading::{STAGE, power};

    #[test]
    fn the_numbers_are_those_in_the_book() {
        let mut numbers = Numbers::default();
        let powers = [(0.9, 10), (0.99, 50), (0.99, 200), (0.5, 200), (-0.9, 10)];
        numbers.note(
            "powers",
            table(powers.map(|(x, n): (f32, u32)| {
                let shown = three_digits(f64::from(power(x, n)));
                [x.to_string(), n.to_string(), shown]
            })),
        );
        let hero = paint(&STAGE, "combined", HERO);
        let pixels = [
            (400, 10, "sky"),
            (358, 154, "the mirror's highlight"),
            (130, 290, "the red ball"),
            (470, 420, "the glass ball's dark side"),
            (400, 590, "the floor"),
        ];
        numbers.note(
            "pixels",
            table(pixels.map(|(x, y, what)| {
                let [red, green, blue] = hero.levels[(y * HERO.x + x) as usize];
                [
                    format!("({x}, {y})"),
                    what.to_string(),
                    format!("{red}, {green}, {blue}"),
                ]
            })),
        );
        numbers.note("power-errors", table([10, 50, 100, 200].map(power_errors)));
        let views = STAGE.views.iter().map(|view| view.name);
        numbers.note("rays", ray_counts(&STAGE, views));
        numbers.check("05-shading");
    }

    /// An exponent, its multiplications, and the largest error for bases from 0 to 1.
    #[expect(clippy::disallowed_methods, reason = "f64 is the judge here")]
    fn power_errors(n: u32) -> [String; 4] {
        let multiplications = n.ilog2() + 1 + n.count_ones();
        let errors = (0..=10_000).map(|i| {
            let x = i as f32 / 10_000.0;
            (f64::from(power(x, n)) - f64::from(x).powi(n as i32)).abs()
        });
        let largest = errors.fold(0.0, f64::max);
        [
            n.to_string(),
            multiplications.to_string(),
            three_digits(largest),
            three_digits(255.0 * largest),
        ]
    }
}
