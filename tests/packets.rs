//! Chapter 12: sixteen rays at once, and not a bit is different.

use canvas::{Canvas, Picture};
use glam::{UVec2, Vec3};
use packets::{LANES, paint};
use plane_hit::{Object, Pattern, Plane, Shape};
use ray_casting::Camera;
use ray_casting::views::{STILL_LIFE_FOCAL_LENGTH, still_life_camera};
use rayon::prelude::*;
use reflection::{MAX_DEPTH, Reach};
use refraction::views::{AIR, GLASS, still_life_with_glass};
use refraction::{Body, Material};
use shading::Phong;
use shadow_acne::{from_the_eye, from_the_surface};
use shadows::{PointLight, Scene};
use speed_and_accuracy::scenes::{Model, SCENES, nested};
use sphere_hit::Sphere;

/// By chapter 10's tracer; with more than one sample, as chapter 9 places and adds them.
fn one_by_one(scene: Scene<Material>, camera: Camera, reach: Reach, n: u32) -> Picture {
    let trace = move |point| {
        let leaving = from_the_eye(camera.ray(point));
        shadow_acne::trace(&scene, leaving, reach, from_the_surface)
    };
    Picture::new(move |pixel| {
        if n == 1 {
            trace(pixel.centre())
        } else {
            anti_aliasing::regular(pixel, n, &trace)
        }
    })
}

fn by_packets(scene: Scene<Material>, camera: Camera, reach: Reach, n: u32) -> Picture {
    Picture::by_runs(move |first, run| paint(&scene, &camera, reach, n, first, run))
}

/// The bits of a picture, and how many rays it took.
fn bits(picture: &Picture, size: UVec2) -> (Vec<[u32; 3]>, u64) {
    let canvas = Canvas::paint(picture, size);
    let light = canvas.light.iter();
    (
        light
            .map(|light| light.to_array().map(f32::to_bits))
            .collect(),
        canvas.rays,
    )
}

fn assert_same(
    name: &str,
    (scene, camera): (&Scene<Material>, Camera),
    reach: Reach,
    n: u32,
    size: UVec2,
) {
    let (light, rays) = bits(&one_by_one(scene.clone(), camera, reach, n), size);
    let (ours, our_rays) = bits(&by_packets(scene.clone(), camera, reach, n), size);
    let differing = light
        .iter()
        .zip(&ours)
        .filter(|(one, other)| one != other)
        .count();
    assert_eq!(
        differing, 0,
        "pixels differ in {name}, {size}, {n} × {n}, {reach:?}"
    );
    assert_eq!(
        rays, our_rays,
        "rays for {name}, {size}, {n} × {n}, {reach:?}"
    );
}

fn usual() -> Reach {
    Reach::new(MAX_DEPTH)
}

/// The book's scenes, but for coloured glass, which packets do not have.
fn scenes() -> impl Iterator<Item = (&'static str, Scene<Material>, Camera)> {
    SCENES.into_iter().filter_map(|book| match (book.make)() {
        (Model::Plain(scene), camera) => Some((book.name, scene, camera)),
        (Model::Tinted(_), _) => None,
    })
}

#[test]
fn every_scene_has_the_same_bits_and_rays() {
    for (name, scene, camera) in scenes() {
        assert_same(name, (&scene, camera), usual(), 1, UVec2::new(200, 150));
    }
}

#[test]
fn so_has_every_width() {
    for (name, scene, camera) in scenes() {
        for width in [1, 7, 8, 9, 15, 16, 17, 33] {
            assert_same(name, (&scene, camera), usual(), 1, UVec2::new(width, 24));
        }
    }
}

#[test]
fn so_has_every_reach() {
    for (name, scene, camera) in scenes() {
        for depth in [0, 1, 2, 5] {
            for least_weight in [0.0, 0.01, 0.3] {
                let reach = Reach {
                    least_weight,
                    ..Reach::new(depth)
                };
                assert_same(name, (&scene, camera), reach, 1, UVec2::new(40, 30));
            }
        }
        let reach = Reach {
            weight: 0.25,
            ..usual()
        };
        assert_same(name, (&scene, camera), reach, 1, UVec2::new(40, 30));
    }
}

#[test]
fn so_has_every_number_of_samples() {
    for (name, scene, camera) in scenes() {
        for n in [1, 2, 3, 4] {
            assert_same(name, (&scene, camera), usual(), n, UVec2::new(33, 24));
        }
    }
}

#[test]
fn so_has_the_still_life_with_every_glass() {
    let camera = still_life_camera(STILL_LIFE_FOCAL_LENGTH);
    for (inside, outside) in [(GLASS, AIR), (AIR, GLASS), (GLASS, GLASS), (2.42, 1.33)] {
        let scene = still_life_with_glass(inside, outside);
        let name = format!("{inside} in {outside}");
        assert_same(&name, (&scene, camera), usual(), 1, UVec2::new(200, 150));
    }
}

#[test]
fn so_has_the_still_life_a_million_times_larger_or_smaller() {
    for scale in [1e-6, 1e6] {
        let (mut scene, mut camera) =
            (still_life_with_glass(GLASS, AIR), still_life_camera(2.0));
        camera.eye *= scale;
        for object in &mut scene.objects {
            if let Shape::Sphere(sphere) = &mut object.shape {
                sphere.centre *= scale;
                sphere.radius *= scale;
            }
        }
        assert_same(
            &format!("{scale}"),
            (&scene, camera),
            usual(),
            1,
            UVec2::new(160, 120),
        );
    }
}

/// What is beyond f32, and of what there are two: a sphere too small for its distance, two in one place, a lamp on
/// a surface, and no object at all.
#[test]
fn so_have_the_strangest_scenes() {
    let (Model::Plain(still_life), camera) = nested() else {
        panic!("glass without colour");
    };
    let size = UVec2::new(80, 60);
    let with = |change: &dyn Fn(&mut Scene<Material>)| {
        let mut scene = still_life.clone();
        change(&mut scene);
        assert_same("strange", (&scene, camera), usual(), 1, size);
    };
    with(&|scene| scene.objects.clear());
    with(&|scene| scene.lights.clear());
    with(&|scene| scene.objects.extend(scene.objects.clone()));
    with(&|scene| scene.lights[0].position = Vec3::ZERO);
    with(&|scene| scene.lights[0].position = Vec3::splat(1e30));
    for (centre, radius) in [
        (1e7, 1.0),
        (1e12, 1e12),
        (1e30, 1e30),
        (0.0, 1e-30),
        (0.0, 1e-22),
    ] {
        let shape =
            Shape::Sphere(Sphere::new(Vec3::splat(centre), radius).expect("a sphere"));
        with(&|scene| scene.objects[5].shape = shape);
        with(&|scene| scene.objects[2].shape = shape);
    }
    with(&|scene| scene.objects[3].material.phong.shininess = u32::MAX);
    with(&|scene| scene.objects[3].material.phong.diffuse = 0.0);
}

/// Equal indices mirror nothing: so near to grazing, sin²θ rounds to 1, and the formula alone would mirror all.
#[test]
fn so_has_a_border_of_equal_indices_at_grazing_incidence() {
    let plane = |height: f32, ambient: f32, body: Body| {
        let point = Vec3::new(0.0, height, 0.0);
        Object {
            name: "plane",
            shape: Shape::Plane(Plane::new(point, Vec3::Y).expect("a plane")),
            material: Material {
                phong: Phong {
                    colour: Pattern::Plain(Vec3::X),
                    ambient,
                    diffuse: 0.0,
                    specular: 0.0,
                    shininess: 1,
                },
                body,
            },
        }
    };
    let clear = Body::Clear {
        inside: GLASS,
        outside: GLASS,
    };
    let floor = Body::Opaque { reflectivity: 0.0 };
    let scene = Scene {
        objects: vec![plane(-1.0, 0.0, clear), plane(-2.0, 1.0, floor)],
        lights: vec![],
        background: Vec3::Z,
    };
    let towards = Vec3::new(0.0, -1.0 / 8192.0, 1.0);
    let camera = Camera::new(Vec3::ZERO, towards, Vec3::Y, 1.0).expect("a camera");
    assert_same("grazing", (&scene, camera), usual(), 1, UVec2::new(33, 9));
}

#[test]
fn so_have_a_thousand_random_scenes() {
    (0..1000_u64).into_par_iter().for_each(|seed| {
        let (scene, camera) = random_scene(seed);
        let size = UVec2::new(24, 16);
        assert_same(
            &format!("random scene {seed}"),
            (&scene, camera),
            usual(),
            1,
            size,
        );
    });
}

/// Balls of all kinds, mostly on a floor, under up to three lamps.
fn random_scene(seed: u64) -> (Scene<Material>, Camera) {
    let mut random = fastrand::Rng::with_seed(seed);
    let mut between = |from: f32, to: f32| from + (to - from) * random.f32();
    let mut objects = Vec::new();
    if between(0.0, 1.0) < 0.8 {
        let floor = Shape::Plane(Plane::new(Vec3::ZERO, Vec3::Y).expect("a plane"));
        objects.push(thing(floor, &mut between));
    }
    for _ in 0..between(1.0, 8.0) as u32 {
        let radius = between(0.2, 1.2);
        let height = radius + between(-0.5, 1.5);
        let centre = Vec3::new(between(-3.0, 3.0), height, between(-2.0, 3.0));
        let ball = Shape::Sphere(Sphere::new(centre, radius).expect("a sphere"));
        objects.push(thing(ball, &mut between));
    }
    let lights = (0..between(0.0, 3.99) as u32).map(|_| PointLight {
        position: Vec3::new(between(-6.0, 6.0), between(1.0, 9.0), between(-7.0, 2.0)),
        intensity: between(0.2, 0.8),
    });
    let lights = lights.collect();
    let eye = Vec3::new(between(-3.0, 3.0), between(0.5, 4.0), between(-9.0, -1.0));
    let towards = Vec3::new(between(-0.5, 0.5), 1.0, 0.5) - eye;
    let camera = Camera::new(eye, towards, Vec3::Y, between(0.5, 3.0)).expect("a camera");
    let background = colour(&mut between);
    (
        Scene {
            objects,
            lights,
            background,
        },
        camera,
    )
}

fn colour(between: &mut impl FnMut(f32, f32) -> f32) -> Vec3 {
    Vec3::from_array(std::array::from_fn(|_| between(0.0, 1.0)))
}

fn thing(shape: Shape, between: &mut impl FnMut(f32, f32) -> f32) -> Object<Material> {
    let is_clear = between(0.0, 1.0) < 0.3;
    let paint = if between(0.0, 1.0) < 0.5 {
        Pattern::Plain(colour(between))
    } else {
        Pattern::Checker(colour(between), colour(between))
    };
    let phong = Phong {
        colour: paint,
        ambient: between(0.0, 0.3),
        diffuse: between(0.0, 0.9),
        specular: between(0.0, 0.9),
        shininess: between(1.0, 300.0) as u32,
    };
    let body = if is_clear {
        let outside = if between(0.0, 1.0) < 0.8 { 1.0 } else { 1.5 };
        Body::Clear {
            inside: between(0.9, 2.4),
            outside,
        }
    } else {
        let reflectivity = between(-1.0, 0.9);
        Body::Opaque {
            reflectivity: if reflectivity > 0.0 {
                reflectivity
            } else {
                0.0
            },
        }
    };
    Object {
        name: "thing",
        shape,
        material: Material { phong, body },
    }
}

/// A pixel is the same in whatever run it is painted.
#[test]
fn a_pixel_alone_is_the_same_as_in_its_row() {
    let size = UVec2::new(3 * LANES as u32 + 5, 4);
    for view in packets::STAGE.views {
        let picture = (view.picture)(view.default_setting());
        let canvas = Canvas::paint(&picture, size);
        for (i, light) in (0..).zip(&canvas.light) {
            let pixel = canvas::Pixel {
                x: i % size.x,
                y: i / size.x,
                size,
            };
            assert_eq!(*light, picture.light(pixel), "{} {pixel:?}", view.name);
        }
    }
}

/// Sky alone, and lanes that go apart at the balls' edges.
#[test]
fn the_view_of_divergence_shows_full_and_partly_empty_packets() {
    let divergence = packets::STAGE.find("divergence").expect("a view");
    let picture = (packets::STAGE.views[divergence].picture)(0.0);
    let canvas = Canvas::paint(&picture, UVec2::new(320, 240));
    assert!(
        canvas
            .light
            .iter()
            .all(|light| light.x > 0.0 && light.x <= 1.0)
    );
    assert_eq!(canvas.light[0], Vec3::ONE);
    assert!(canvas.light.iter().any(|light| light.x < 0.5));
}
