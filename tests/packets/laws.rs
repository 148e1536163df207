//! Sixteen rays at once, and not a bit is different.

use ::packets::{LANES, STAGE};
use canvas::{Canvas, Picture, Pixel};
use glam::{UVec2, Vec3};
use measure::pictures::{packet_picture, scalar_picture};
use measure::random_scenes::{extreme, ordinary};
use measure::scenes::{Model, SCENES, plain_scene};
use plane_hit::{Object, Shape, Texture};
use ray_casting::Camera;
use ray_casting::scene::still_life_camera;
use rayon::prelude::*;
use reflection::{MAX_DEPTH, PathBudget};
use refraction::scene::{AIR, GLASS, still_life_with_glass};
use refraction::{Material, Optics};
use shading::Phong;
use shadows::Scene;
use sphere_hit::Sphere;

/// The bits of a picture, and the number of rays traced for it.
fn bits(picture: &Picture, size: UVec2) -> (Vec<[u32; 3]>, u64) {
    let canvas = Canvas::render(picture, size);
    (
        canvas.radiance.iter().map(harness::bits).collect(),
        canvas.rays,
    )
}

fn assert_same(
    name: &str,
    (scene, camera): (&Scene<Material>, Camera),
    budget: PathBudget,
    n: u32,
    size: UVec2,
) {
    let (right, rays) = bits(&scalar_picture(scene.clone(), camera, budget, n), size);
    let (ours, our_rays) = bits(&packet_picture(scene.clone(), camera, budget, n), size);
    let differing = right
        .iter()
        .zip(&ours)
        .filter(|(one, other)| one != other)
        .count();
    assert_eq!(
        differing, 0,
        "pixels differ in {name}, {size}, {n} × {n}, {budget:?}"
    );
    assert_eq!(
        rays, our_rays,
        "rays for {name}, {size}, {n} × {n}, {budget:?}"
    );
}

fn usual() -> PathBudget {
    PathBudget::new(MAX_DEPTH)
}

/// The book's scenes, but for glass that absorbs light, which packets do not have.
fn scenes() -> impl Iterator<Item = (&'static str, Scene<Material>, Camera)> {
    SCENES.into_iter().filter_map(|book| match (book.make)() {
        (Model::Plain(scene), camera) => Some((book.name, scene, camera)),
        (Model::Absorbing(_), _) => None,
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
fn so_has_every_budget() {
    for (name, scene, camera) in scenes() {
        for depth in [0, 1, 2, 5] {
            for min_throughput in [0.0, 0.01, 0.3] {
                let budget = PathBudget {
                    min_throughput,
                    ..PathBudget::new(depth)
                };
                assert_same(name, (&scene, camera), budget, 1, UVec2::new(40, 30));
            }
        }
        let budget = PathBudget {
            throughput: 0.25,
            ..usual()
        };
        assert_same(name, (&scene, camera), budget, 1, UVec2::new(40, 30));
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
    let camera = still_life_camera();
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
            (still_life_with_glass(GLASS, AIR), still_life_camera());
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

/// Scenes at the limits of f32, and coincident objects: a sphere too small for its distance, two spheres at one
/// position, a light on a surface, and no object at all.
#[test]
fn so_have_the_strangest_scenes() {
    let (still_life, camera) = plain_scene("nested");
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
        let centre = Vec3::splat(centre);
        let shape = Shape::Sphere(Sphere { centre, radius });
        with(&|scene| scene.objects[5].shape = shape);
        with(&|scene| scene.objects[2].shape = shape);
    }
    with(&|scene| scene.objects[3].material.phong.shininess = u32::MAX);
    with(&|scene| scene.objects[3].material.phong.diffuse = 0.0);
}

/// A room with lamps on its ceiling, on a wall and on balls, glossy, and the eye on its floor, on a
/// wall, on a ball: the lamps are hidden by nothing that they are on, for one ray and for sixteen.
#[test]
fn so_have_lamps_and_eyes_on_surfaces() {
    let (still_life, _) = plain_scene("still-life");
    let mut walls = still_life.clone();
    for (shape, index) in [
        (Shape::plane(4.0 * Vec3::Y, Vec3::NEG_Y), 1),
        (
            Shape::plane(Vec3::new(0.0, 0.0, 5.0), Vec3::new(0.1, 0.2, -1.0)),
            3,
        ),
    ] {
        walls.objects[index].shape = shape;
    }
    for lamp in [
        Vec3::new(0.3, 4.0, 1.7),
        Vec3::new(2.0, 1.0, 5.4),
        Vec3::new(0.2, 1.2, 0.8),
        Vec3::new(0.9, 1.2, -1.2),
    ] {
        for eye in [
            Vec3::new(0.0, 1.6, -5.0),
            Vec3::new(1.0, 0.0, -5.0),
            Vec3::new(0.5, 4.0, -3.0),
            Vec3::new(0.9, 0.6, -1.8),
        ] {
            let mut scene = walls.clone();
            scene.lights[0].position = lamp;
            let towards = Vec3::new(0.1, 0.9, 2.0) - eye;
            let camera = Camera::new(eye, towards, Vec3::Y, 1.0).expect("a camera");
            let name = format!("lamp {lamp}, eye {eye}");
            assert_same(&name, (&scene, camera), usual(), 1, UVec2::new(80, 60));
        }
    }
}

/// Equal indices reflect nothing: so near to grazing, sin²θ rounds to 1, and the formula alone would reflect all.
#[test]
fn so_has_an_interface_of_equal_indices_at_grazing_incidence() {
    let plane = |height: f32, ambient: f32, optics: Optics| {
        let point = Vec3::new(0.0, height, 0.0);
        Object {
            name: "plane",
            shape: Shape::plane(point, Vec3::Y),
            material: Material {
                phong: Phong {
                    colour: Texture::Solid(Vec3::X),
                    ambient,
                    diffuse: 0.0,
                    specular: 0.0,
                    shininess: 1,
                },
                optics,
            },
        }
    };
    let clear = Optics::Dielectric {
        eta_inside: GLASS,
        eta_outside: GLASS,
    };
    let floor = Optics::Opaque { reflectivity: 0.0 };
    let scene = Scene {
        objects: vec![plane(-1.0, 0.0, clear), plane(-2.0, 1.0, floor)],
        lights: vec![],
        background: Vec3::Z,
    };
    let towards = Vec3::new(0.0, -1.0 / 8192.0, 1.0);
    let camera = Camera::new(Vec3::ZERO, towards, Vec3::Y, 1.0).expect("a camera");
    assert_same("grazing", (&scene, camera), usual(), 1, UVec2::new(33, 9));
}

/// Ordinary ones, and those that overlap, touch, nest and stand far away.
#[test]
fn so_have_a_thousand_random_scenes() {
    (0..500_u32).into_par_iter().for_each(|seed| {
        for (kind, (scene, camera)) in [
            ("ordinary", ordinary(seed, false)),
            ("extreme", extreme(seed)),
        ] {
            let scene = scene.map(|absorbing| absorbing.material);
            let name = format!("{kind} scene {seed}");
            assert_same(&name, (&scene, camera), usual(), 1, UVec2::new(24, 16));
        }
    });
}

/// A pixel is the same in every span.
#[test]
fn a_pixel_alone_is_the_same_as_in_its_row() {
    let size = UVec2::new(3 * LANES as u32 + 5, 4);
    for view in STAGE.views {
        let picture = (view.picture)(view.default_setting());
        let canvas = Canvas::render(&picture, size);
        for (pixel, radiance) in Pixel::all(size).zip(&canvas.radiance) {
            assert_eq!(
                *radiance,
                picture.radiance(pixel),
                "{} {pixel:?}",
                view.name
            );
        }
    }
}

/// Sky alone, and lanes that go apart at the balls' edges.
#[test]
fn the_view_of_divergence_shows_full_and_partly_empty_packets() {
    let view = STAGE.view("divergence").expect("a view");
    let picture = (view.picture)(0.0);
    let canvas = Canvas::render(&picture, UVec2::new(320, 240));
    assert!(
        canvas
            .radiance
            .iter()
            .all(|light| light.x > 0.0 && light.x <= 1.0)
    );
    assert_eq!(canvas.radiance[0], Vec3::ONE);
    assert!(canvas.radiance.iter().any(|light| light.x < 0.5));
}
