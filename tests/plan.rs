//! Chapter 13's planner: it casts no ray that its plan excludes, and keeps its promises.
//!
//! What its pictures cost beside a fixed depth and n × n samples is measured by the study `plan`, whose
//! table `tests/studies.rs` compares with what is measured today; here the table is held to its bounds.

mod numbers_file;

use canvas::Canvas;
use glam::{DVec2, UVec2, Vec3};
use numbers_file::{Numbers, percent, three_digits};
use oracle::Limit;
use plane_hit::{Object, Pattern, Plane, Shape};
use ray_casting::Camera;
use rayon::prelude::*;
use refraction::{Body, Material};
use shading::Phong;
use shadows::{PointLight, Scene};
use speed_and_accuracy::plan::{Formula, WISH};
use speed_and_accuracy::scenes::{Model, SCENES, exact_camera, find};
use speed_and_accuracy::studies::plan::{METHODS, STUDY};
use speed_and_accuracy::study::{Measurement, Table};
use sphere_hit::Sphere;
use std::f64::consts::TAU;
use transparency::Tinted;

const SIZE: UVec2 = UVec2::new(160, 120);

fn scene(name: &str) -> (Model, Camera) {
    (find(name).expect("a scene of the book").make)()
}

/// The rays of a scene's planned picture, one sample for each pixel.
fn rays(name: &str) -> u64 {
    let (model, camera) = scene(name);
    let plan = model.plan(&camera, WISH);
    Canvas::paint(&model.at_centres(plan, camera), SIZE).rays
}

const PIXELS: u64 = 160 * 120;

mod speed_and_accuracy_excludes {
    use super::*;

    #[test]
    fn shadow_rays_where_there_is_no_lamp() {
        for name in ["flat", "floor"] {
            assert_eq!(rays(name), PIXELS, "{name}");
        }
    }

    /// The same scene, with and without its mirrors and its glass: what is left are shadow rays.
    #[test]
    fn rays_beyond_the_first_hit_where_nothing_mirrors_and_nothing_is_clear() {
        let (Model::Plain(scene), camera) = scene("plastic") else {
            unreachable!("no colours")
        };
        let lamps = scene.lights.len() as u64;
        let rays = rays("plastic");
        assert!((PIXELS..=PIXELS * (1 + lamps)).contains(&rays), "{rays}");
        let mut dark = scene.clone();
        dark.lights.clear();
        let model = Model::Plain(dark);
        let plan = model.plan(&camera, WISH);
        let rays = Canvas::paint(&model.at_centres(plan, camera), SIZE).rays;
        assert_eq!(rays, PIXELS);
    }

    /// Without lamps, each further ray is a bounce: with a single mirror never more than one.
    #[test]
    fn bounces_beyond_the_plans_depth() {
        let (Model::Plain(mut scene), camera) = scene("planet") else {
            unreachable!("no colours")
        };
        scene.lights.clear();
        let model = Model::Plain(scene);
        let plan = model.plan(&camera, WISH);
        assert_eq!(plan.depth, Some(1));
        let canvas = Canvas::paint(&model.at_centres(plan, camera), SIZE);
        assert!((PIXELS + 1..2 * PIXELS).contains(&canvas.rays));
    }
}

mod speed_and_accuracy_plans {
    use super::*;

    fn depth_of(mirrors: f32) -> Option<u32> {
        let (scene, camera) = reflection::views::facing_mirrors(mirrors);
        let objects = scene.objects.into_iter().map(|object| Object {
            name: object.name,
            shape: object.shape,
            material: Material {
                phong: object.material.phong,
                body: Body::Opaque {
                    reflectivity: object.material.reflectivity,
                },
            },
        });
        let scene = Scene {
            objects: objects.collect(),
            lights: scene.lights,
            background: scene.background,
        };
        Model::Plain(scene).plan(&camera, WISH).depth
    }

    /// Each bounce passes on ρ: for a tenth of the light, it takes log 0.1 / log ρ of them.
    #[test]
    fn a_depth_that_grows_as_the_logarithm_of_the_reflectivity() {
        assert_eq!(depth_of(0.0), Some(0));
        let [half, nine_tenths] =
            [0.5, 0.9].map(|mirrors| f64::from(depth_of(mirrors).unwrap()));
        // log 0.5 / log 0.9 = 6.58; what is brightest hardly differs.
        assert!(
            (nine_tenths / half - 6.58).abs() < 0.7,
            "{nine_tenths} / {half}"
        );
    }

    /// The slide's formula from near, the stable one from afar, f64 from very far away.
    #[test]
    fn the_cheapest_formula_that_holds() {
        let formula = |distance: f32| {
            let (Model::Plain(mut scene), mut camera) = scene("plastic") else {
                unreachable!("no colours")
            };
            scene.objects.truncate(2);
            camera.eye = Vec3::new(0.0, 0.0, -distance);
            Model::Plain(scene).plan(&camera, WISH).formula
        };
        let formulas = [5.0, 100.0, 1e4].map(formula);
        assert_eq!(formulas, [Formula::Slide, Formula::Stable, Formula::InF64]);
    }

    /// A mirror wall shows the eye its ball from as far as the ball's image is.
    #[test]
    fn a_formula_that_holds_in_a_far_mirror_too() {
        let (Model::Plain(mut scene), camera) = scene("plastic") else {
            unreachable!("no colours")
        };
        scene.objects.truncate(2);
        let mut wall = scene.objects[0].clone();
        let behind = Vec3::new(0.0, 0.0, 800.0);
        wall.shape = Shape::Plane(Plane::new(behind, Vec3::NEG_Z).expect("a plane"));
        wall.material.body = Body::Opaque { reflectivity: 0.9 };
        let formula = |scene: &Scene<Material>| {
            Model::Plain(scene.clone()).plan(&camera, WISH).formula
        };
        assert_eq!(formula(&scene), Formula::Slide);
        scene.objects.push(wall);
        assert_eq!(formula(&scene), Formula::InF64);
        let off = off(&Model::Plain(scene), camera);
        assert!(off.elsewhere <= PIXELS as usize / 1000, "{}", off.elsewhere);
    }

    #[test]
    fn are_those_in_the_book() {
        let mut numbers = Numbers::default();
        for name in ["flat", "facing-mirrors", "still-life", "planet"] {
            let (model, camera) = scene(name);
            let plan = model.plan(&camera, WISH);
            numbers.note(name, format!("```text\n{plan}\n```"));
        }
        numbers.check("13-plans");
    }

    /// The exact counts, by which a change of cost shows.
    #[test]
    fn cast_as_many_rays_as_the_book_says() {
        let rows = SCENES.iter().map(|scene| {
            let (model, camera) = (scene.make)();
            let plan = model.plan(&camera, WISH);
            // Large enough for a change to show, small enough for 1,024 samples.
            let size = UVec2::new(32, 24);
            let centres =
                Canvas::paint(&model.clone().at_centres(plan.clone(), camera), size);
            let canvas = Canvas::paint(&model.planned(plan, camera), size);
            format!("| {} | {} | {} |", scene.name, centres.rays, canvas.rays)
        });
        let mut numbers = Numbers::default();
        numbers.note("plans", rows.collect::<Vec<_>>().join("\n"));
        numbers.check("13-plan-rays");
    }
}

/// What the oracle is asked for: much farther than half a level.
const DEEP: Limit = Limit {
    bounces: 1000,
    share: 1e-5,
};

/// The pixels of a planned picture, one sample each, that are off by more than half a level.
#[derive(Default)]
struct Off {
    /// Which the oracle itself sees differently a ten-thousandth of a pixel aside.
    at_an_edge: usize,
    /// All others.
    elsewhere: usize,
}

fn off(model: &Model, camera: Camera) -> Off {
    let plan = model.plan(&camera, WISH);
    let ours = Canvas::paint(&model.clone().at_centres(plan, camera), SIZE);
    let (scene, exact_camera) = (model.exactly(), exact_camera(&camera));
    let size = SIZE.to_array();
    let see = |at: DVec2| {
        let light = oracle::trace(&scene, &exact_camera.ray(at, size), DEEP);
        light.to_array().map(oracle::level)
    };
    let differ = |a: [f64; 3], b: [f64; 3]| (0..3).any(|i| (a[i] - b[i]).abs() > 0.5);
    let centres: Vec<DVec2> = oracle::pixel_centres(size).collect();
    let off = ours
        .light
        .par_iter()
        .zip(centres)
        .filter_map(|(light, at)| {
            let exact = see(at);
            let levels = light.to_array().map(|light| oracle::level(light.into()));
            differ(levels, exact).then(|| {
                let mut aside =
                    (0..32).map(|i| DVec2::from_angle(TAU * f64::from(i) / 32.0));
                aside.any(|aside| differ(see(at + 1e-4 * aside), exact))
            })
        });
    off.fold(Off::default, |mut off, is_at_an_edge| {
        off.at_an_edge += usize::from(is_at_an_edge);
        off.elsewhere += usize::from(!is_at_an_edge);
        off
    })
    .reduce(Off::default, |a, b| Off {
        at_an_edge: a.at_an_edge + b.at_an_edge,
        elsewhere: a.elsewhere + b.elsewhere,
    })
}

mod speed_and_accuracy_traces {
    use super::*;

    /// A thousandth of the pixels.
    const BOUND: usize = PIXELS as usize / 1000;

    #[test]
    fn every_scene_of_the_book_within_half_a_level_of_the_oracle() {
        let mut rows = Vec::new();
        for scene in &SCENES {
            let (model, camera) = (scene.make)();
            let off = off(&model, camera);
            assert!(off.elsewhere <= BOUND, "{}: {}", scene.name, off.elsewhere);
            let [edge, elsewhere] =
                [off.at_an_edge, off.elsewhere].map(|off| percent(off, PIXELS as usize));
            rows.push(format!("| {} | {edge} | {elsewhere} |", scene.name));
        }
        let mut numbers = Numbers::default();
        numbers.note("scenes", rows.join("\n"));
        numbers.check("13-plan-tracing");
    }

    #[test]
    fn two_hundred_random_scenes_within_half_a_level_of_the_oracle() {
        let offs: Vec<Off> = (0..200)
            .map(|seed| {
                let (model, camera) = random_scene(seed);
                let off = off(&model, camera);
                assert!(off.elsewhere <= BOUND, "seed {seed}: {}", off.elsewhere);
                off
            })
            .collect();
        let all = 200 * PIXELS as usize;
        let mut numbers = Numbers::default();
        let edge = offs.iter().map(|off| off.at_an_edge).sum();
        let elsewhere = offs.iter().map(|off| off.elsewhere).sum();
        let worst = offs.iter().map(|off| off.elsewhere).fold(0, Ord::max);
        numbers.note("edge", percent(edge, all));
        numbers.note("elsewhere", percent(elsewhere, all));
        numbers.note("worst", percent(worst, PIXELS as usize));
        numbers.check("13-plan-random");
    }
}

/// A floor, as a rule, with balls that do not touch, of plastic, mirror and glass, under up to three lamps;
/// as chapter 11 sees light, or as those before it do.
fn random_scene(seed: u64) -> (Model, Camera) {
    let mut random = fastrand::Rng::with_seed(seed);
    let mut between = |from: f32, to: f32| from + (to - from) * random.f32();
    let mut objects: Vec<Object<Tinted>> = Vec::new();
    if between(0.0, 1.0) < 0.8 {
        let paint = Pattern::Checker(colour(&mut between), colour(&mut between));
        objects.push(Object {
            name: "floor",
            shape: Shape::Plane(Plane::new(Vec3::ZERO, Vec3::Y).expect("a plane")),
            material: opaque(paint, &mut between),
        });
    }
    for _ in 0..between(1.0, 8.0) as u32 {
        let radius = between(0.2, 1.2);
        let height = radius + between(0.0, 1.5);
        let centre = Vec3::new(between(-3.0, 3.0), height, between(-2.0, 3.0));
        let touches = |object: &Object<Tinted>| match object.shape {
            Shape::Sphere(other) => other.centre.distance(centre) < other.radius + radius,
            Shape::Plane(_) => false,
        };
        if objects.iter().any(touches) {
            continue;
        }
        let material = if between(0.0, 1.0) < 0.25 {
            clear(&mut between)
        } else {
            opaque(Pattern::Plain(colour(&mut between)), &mut between)
        };
        objects.push(Object {
            name: "ball",
            shape: Shape::Sphere(Sphere::new(centre, radius).expect("a sphere")),
            material,
        });
    }
    let lights = (0..between(0.0, 3.99) as u32).map(|_| PointLight {
        position: Vec3::new(between(-6.0, 6.0), between(4.0, 9.0), between(-7.0, 2.0)),
        intensity: between(0.2, 0.8),
    });
    let lights = lights.collect();
    let background = colour(&mut between);
    let eye = Vec3::new(between(-3.0, 3.0), between(0.5, 4.0), between(-9.0, -5.0));
    let towards = Vec3::new(between(-0.5, 0.5), 1.0, 0.5) - eye;
    let camera = Camera::new(eye, towards, Vec3::Y, between(1.5, 3.0)).expect("a camera");
    let model = if seed.is_multiple_of(2) {
        Model::Tinted(Scene {
            objects,
            lights,
            background,
        })
    } else {
        let objects = objects.into_iter().map(|object| Object {
            name: object.name,
            shape: object.shape,
            material: object.material.material,
        });
        Model::Plain(Scene {
            objects: objects.collect(),
            lights,
            background,
        })
    };
    (model, camera)
}

fn colour(between: &mut impl FnMut(f32, f32) -> f32) -> Vec3 {
    Vec3::from_array(std::array::from_fn(|_| between(0.0, 1.0)))
}

fn opaque(colour: Pattern, between: &mut impl FnMut(f32, f32) -> f32) -> Tinted {
    let phong = Phong {
        colour,
        ambient: between(0.02, 0.3),
        diffuse: between(0.0, 0.9),
        specular: between(0.0, 0.9),
        shininess: between(1.0, 200.0) as u32,
    };
    let reflectivity = if between(0.0, 1.0) < 0.33 {
        between(0.1, 0.8)
    } else {
        0.0
    };
    Tinted {
        material: Material {
            phong,
            body: Body::Opaque { reflectivity },
        },
        absorption: Vec3::ZERO,
    }
}

fn clear(between: &mut impl FnMut(f32, f32) -> f32) -> Tinted {
    let phong = Phong {
        colour: Pattern::Plain(Vec3::ONE),
        ambient: 0.0,
        diffuse: 0.0,
        specular: between(0.0, 0.9),
        shininess: between(1.0, 200.0) as u32,
    };
    let inside = between(1.05, 2.4);
    Tinted {
        material: Material {
            phong,
            body: Body::Clear {
                inside,
                outside: 1.0,
            },
        },
        absorption: between(0.0, 2.0) * colour(between),
    }
}

mod speed_and_accuracy_samples {
    use super::*;

    /// A scene's planned picture with a wish of half a level, and those with n × n samples at a depth of 64,
    /// from the study's table.
    struct Pictures {
        planned: Measurement,
        fixed: Vec<Measurement>,
    }

    fn pictures(scene: &str) -> Pictures {
        let table = Table::from_csv(STUDY.table).expect("the study's table");
        let rows = |method| {
            let rows = table.rows.clone().into_iter();
            rows.filter(move |row| row.scene == scene && row.method == method)
        };
        Pictures {
            planned: rows(METHODS[0])
                .find(|row| row.setting == f64::from(WISH))
                .expect("the plan's row"),
            fixed: rows(METHODS[1]).collect(),
        }
    }

    impl Pictures {
        /// The cheapest of those with n × n samples that is as good as the planned one; where even 32 × 32
        /// are not, that.
        fn as_good(&self) -> &Measurement {
            let as_good = self.fixed.iter().find(|row| row.rms <= self.planned.rms);
            as_good.or(self.fixed.last()).expect("a picture")
        }
    }

    fn work(row: &Measurement) -> f64 {
        row.work.expect("counted rays")
    }

    /// For every scene, and three times fewer for all of the book's, one by one and together. Nested glass is
    /// in no picture of the book: nearly all its pixels differ in themselves, so that sampling spares little,
    /// and a fixed cut-off leaves out light that the plan does not.
    #[test]
    fn with_a_third_of_the_rays_that_a_fixed_setting_takes_to_be_as_good() {
        let (mut planned, mut fixed) = (0.0, 0.0);
        let mut rows = Vec::new();
        for scene in SCENES
            .iter()
            .filter(|scene| scene.name != "endless-mirrors")
        {
            let pictures = pictures(scene.name);
            let as_good = pictures.as_good();
            let [ours, theirs] = [&pictures.planned, as_good].map(work);
            let times = if scene.name == "nested" { 1.0 } else { 3.0 };
            assert!(
                theirs >= times * ours,
                "{}: {ours} for {theirs}",
                scene.name
            );
            planned += ours;
            fixed += theirs;
            let rms = |row: &Measurement| three_digits(row.rms.expect("an error"));
            rows.push(format!(
                "| {} | {} | {} | {} | {} | {} | {} |",
                scene.name,
                three_digits(ours),
                rms(&pictures.planned),
                as_good.setting,
                three_digits(theirs),
                rms(as_good),
                three_digits(theirs / ours),
            ));
        }
        assert!(fixed >= 3.0 * planned, "{planned} for {fixed}");
        let mut numbers = Numbers::default();
        numbers.note("scenes", rows.join("\n"));
        numbers.note("all", three_digits(fixed / planned));
        numbers.check("13-plan-sampling");
    }

    #[test]
    fn fewer_rays_and_worse_for_a_lesser_wish() {
        let table = Table::from_csv(STUDY.table).expect("the study's table");
        for scene in SCENES
            .iter()
            .filter(|scene| scene.name != "endless-mirrors")
        {
            let planned: Vec<&Measurement> = table
                .rows
                .iter()
                .filter(|row| row.scene == scene.name && row.method == METHODS[0])
                .collect();
            assert_eq!(planned.len(), 3);
            assert!(
                planned.is_sorted_by(|a, b| a.work > b.work),
                "{}",
                scene.name
            );
            assert!(planned.is_sorted_by(|a, b| a.rms < b.rms), "{}", scene.name);
        }
    }
}
