//! An explained ray: what is said of it is what the chapter `shadow-acne` renders.

use canvas::{Picture, Pixel, rays_so_far};
use glam::{UVec2, Vec2, Vec3};
use harness::{Numbers, bits};
use interactive::STAGE;
use interactive::explain::{Explained, Outcome, Visibility, budget, explain};
use measure::scenes::{Model, SCENES};
use plane_hit::Shape;
use ray_casting::Camera;
use ray_casting::scene::still_life_camera;
use reflection::PathBudget;
use refraction::Material;
use refraction::scene::{AIR, GLASS, still_life_with_glass};
use shadow_acne::scene::balls_on_a_planet;
use shadow_acne::{from_surface, untracked};
use shadows::Scene;

fn still_life() -> (Scene<Material>, Camera) {
    (still_life_with_glass(GLASS, AIR), still_life_camera())
}

/// Every pixel has the light that the explanation arrives at, and took as many rays.
fn assert_agrees(
    (scene, camera): &(Scene<Material>, Camera),
    picture: &Picture,
    budget: PathBudget,
    size: UVec2,
) {
    for pixel in Pixel::all(size) {
        let before = rays_so_far();
        let radiance = picture.radiance(pixel);
        let rays = rays_so_far() - before;
        let explained = explain(scene, camera, pixel.centre(), budget);
        assert_eq!(
            bits(&explained.radiance),
            bits(&radiance),
            "{pixel:?}\n{explained}"
        );
        assert_eq!(explained.rays, rays, "{pixel:?}\n{explained}");
        assert_adds_up(&explained);
    }
}

/// A ray's radiance is that by shading alone, and that of the rays after it times their
/// weights, by which the throughput falls, too.
fn assert_adds_up(explained: &Explained) {
    let Outcome::Hit(hit) = &explained.outcome else {
        return;
    };
    let mut radiance = hit.local;
    for next in &hit.secondary {
        radiance += next.weight * next.radiance;
        let throughput = explained.throughput * next.weight;
        assert_eq!(
            next.throughput.to_bits(),
            throughput.to_bits(),
            "{explained}"
        );
        assert_adds_up(next);
    }
    assert_eq!(bits(&explained.radiance), bits(&radiance), "{explained}");
}

fn of_shadow_acne(name: &str) -> Picture {
    let view = shadow_acne::STAGE.view(name).expect("a view");
    (view.picture)(view.default_setting())
}

#[test]
fn agrees_with_every_pixel_of_the_still_life() {
    let picture = of_shadow_acne("still-life");
    assert_agrees(&still_life(), &picture, budget(), UVec2::new(320, 240));
}

#[test]
fn agrees_with_every_pixel_of_the_planet() {
    let picture = of_shadow_acne("from-surface");
    let planet = balls_on_a_planet(1.0);
    assert_agrees(&planet, &picture, budget(), UVec2::new(320, 240));
}

/// The book's scenes, but for absorbing glass.
#[test]
fn agrees_with_every_scene_and_budget() {
    for book in SCENES {
        let (Model::Plain(scene), camera) = (book.make)() else {
            continue;
        };
        let sight = (scene, camera);
        for budget in [
            budget(),
            PathBudget::new(0),
            PathBudget::new(2),
            PathBudget {
                min_throughput: 0.1,
                throughput: 0.5,
                ..budget()
            },
        ] {
            let scene = sight.0.clone();
            let picture = Picture::new(move |pixel| {
                let ray = untracked(camera.ray(pixel.centre()));
                shadow_acne::trace(&scene, &ray, budget, from_surface)
            });
            assert_agrees(&sight, &picture, budget, UVec2::new(80, 60));
        }
    }
}

/// An object between a point and a light is where it is said to be.
#[test]
fn names_what_occludes_a_light() {
    let (scene, camera) = still_life();
    let mut occluded = 0;
    for pixel in Pixel::all(UVec2::new(160, 120)) {
        let explained = explain(&scene, &camera, pixel.centre(), budget());
        let Outcome::Hit(hit) = &explained.outcome else {
            continue;
        };
        assert_eq!(hit.lights.len(), scene.lights.len());
        for (&(light, visibility), expected) in hit.lights.iter().zip(&scene.lights) {
            assert_eq!(light, expected);
            let Visibility::Occluded(by, point) = visibility else {
                continue;
            };
            occluded += 1;
            let Shape::Sphere(sphere) = by.shape else {
                panic!("the floor is below everything");
            };
            let height = point.distance(sphere.centre) - sphere.radius;
            assert!(height.abs() < 1e-5, "{height}");
            // On the straight line: there is no detour over it.
            let [to, from] =
                [hit.at.point, light.position].map(|end| point.distance(end));
            let detour = to + from - hit.at.point.distance(light.position);
            assert!(detour.abs() < 1e-5, "{detour}");
        }
    }
    assert!(occluded > 1000, "{occluded}");
}

/// A light below the horizon is behind the surface. One above it without a shadow ray could
/// only show as a highlight.
#[test]
fn says_why_a_light_contributes_nothing() {
    let (scene, camera) = still_life();
    let (mut below, mut none) = (0, 0);
    for pixel in Pixel::all(UVec2::new(160, 120)) {
        let explained = explain(&scene, &camera, pixel.centre(), budget());
        let Outcome::Hit(hit) = &explained.outcome else {
            continue;
        };
        for &(light, visibility) in &hit.lights {
            let height = hit.at.normal.dot(light.position - hit.at.point);
            match visibility {
                Visibility::BelowHorizon => {
                    below += 1;
                    assert!(height < 0.0);
                }
                Visibility::NoContribution => {
                    none += 1;
                    assert!(height >= 0.0);
                    assert_eq!(hit.object.material.phong.diffuse, 0.0);
                }
                Visibility::Visible | Visibility::Occluded(..) => assert!(height > 0.0),
            }
        }
    }
    assert!(below > 100 && none > 100, "{below} {none}");
}

/// From an eye 0.5 beside the centre of the glass sphere of radius 0.6, sinθᵢ = 5/6 at a right
/// angle to the radius, and total internal reflection begins at 1/1.5.
#[test]
fn says_where_light_cannot_leave_glass() {
    let (scene, _) = still_life();
    let Shape::Sphere(glass) = &scene.objects[5].shape else {
        panic!("the glass is a sphere");
    };
    let eye = glass.centre - 0.5 * Vec3::X;
    for (forward, verb) in [(Vec3::Z, "cannot leave"), (Vec3::NEG_X, "leaves")] {
        let camera = Camera::new(eye, forward, Vec3::Y, 1.0).expect("a camera");
        let explained = explain(&scene, &camera, Vec2::ZERO, budget());
        let tree = explained.to_string();
        let line = format!("camera ray, throughput 1.0000: {verb} glass at t ");
        assert!(
            tree.lines().nth(1).is_some_and(|l| l.starts_with(&line)),
            "{tree}"
        );
        let Outcome::Hit(hit) = &explained.outcome else {
            panic!("{tree}");
        };
        let weights: Vec<_> = hit.secondary.iter().map(|ray| ray.weight).collect();
        assert_eq!(weights.iter().sum::<f32>(), 1.0);
        assert_eq!(weights.len() == 1, verb == "cannot leave");
    }
}

#[test]
fn the_trees_are_those_in_the_book() {
    let size = UVec2::new(800, 600);
    let (scene, camera) = still_life();
    let mut numbers = Numbers::default();
    for (name, x, y) in [
        ("glass", 525, 380),
        ("mirror", 478, 268),
        ("shadow", 640, 405),
    ] {
        let pixel = Pixel { x, y, size };
        let explained = explain(&scene, &camera, pixel.centre(), budget());
        numbers.note(name, explained);
    }
    numbers.check(&format!("{}-trees", STAGE.name));
}

/// On the ceiling it lights the whole floor, and in the plane of the floor none of it: the
/// explanation says so for every pixel that shows the floor.
#[test]
fn a_lamp_on_a_surface_is_explained_as_visible() {
    let (mut scene, _) = still_life();
    scene.objects.truncate(1);
    let mut ceiling = scene.objects[0].clone();
    ceiling.name = "ceiling";
    ceiling.shape = Shape::plane(4.0 * Vec3::Y, Vec3::NEG_Y);
    scene.objects.push(ceiling);
    scene.lights.truncate(1);
    let eye = Vec3::new(0.0, 1.6, -5.0);
    let camera = Camera::new(eye, Vec3::Z, Vec3::Y, 1.0).expect("a camera");
    for (lamp, is_visible) in [
        (Vec3::new(0.3, 4.0, 1.7), true),
        (Vec3::new(0.3, 0.0, 1.7), false),
    ] {
        scene.lights[0].position = lamp;
        let mut floor = 0;
        for pixel in Pixel::all(UVec2::new(80, 60)) {
            let explained = explain(&scene, &camera, pixel.centre(), budget());
            let Outcome::Hit(hit) = &explained.outcome else {
                continue;
            };
            if hit.object.name != "floor" {
                continue;
            }
            floor += 1;
            let (_, visibility) = hit.lights[0];
            let expected = if is_visible {
                matches!(visibility, Visibility::Visible)
            } else {
                matches!(visibility, Visibility::BelowHorizon)
            };
            assert!(expected, "{explained}");
        }
        assert!(floor > 1000);
    }
}
