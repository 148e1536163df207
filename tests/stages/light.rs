//! Laws of light that hold in every chapter that has lamps, or follows rays.

use canvas::{Canvas, Picture};
use glam::{DVec3, UVec2, Vec3};
use harness::EPS;
use measure::Random;
use measure::random_scenes::ordinary;
use plane_hit::{Object, Plane, Shape, Texture};
use ray_casting::Camera;
use rayon::prelude::*;
use reflection::{MAX_DEPTH, PathBudget};
use shadows::{PointLight, Scene};
use sphere_hit::Sphere;
use stages::tracers::{BRANCHED, FIRST_HIT, OFFSET, Tracer, UNBRANCHED, budgeted};
use transparency::Absorbing;

const SIZE: UVec2 = UVec2::new(20, 15);

fn radiance(picture: &Picture) -> Vec<DVec3> {
    let canvas = Canvas::render(picture, SIZE);
    canvas.radiance.into_iter().map(Vec3::as_dvec3).collect()
}

/// The light of several lamps is the sum of what each gives alone: L(a, b) + L() = L(a) + L(b),
/// where L() is all the light that is no lamp's.
///
/// Every term of these sums is the same in all of them, and positive. On its way to the pixel each
/// ray after it adds it to ambient light, three lamps' and two rays', and multiplies it by a weight
/// and a transmittance: eight roundings of ε/2, of the light that all four have together.
#[test]
fn lamps_add_up() {
    const DEPTH: u32 = 8;
    let tracers = || FIRST_HIT.into_iter().chain(budgeted());
    let bar = f64::from(DEPTH + 1) * 8.0 * EPS / 2.0;
    let asked = (0..200).into_par_iter().map(|seed| {
        let (scene, camera) = ordinary(seed, true);
        let [first, others @ ..] = &scene.lights[..] else {
            return 0;
        };
        for (name, tracer) in tracers() {
            let lit_by = |lights: &[PointLight]| {
                let lights = lights.to_vec();
                let scene = Scene {
                    lights,
                    ..scene.clone()
                };
                radiance(&tracer(&scene, camera, PathBudget::new(DEPTH)))
            };
            let (all, none) = (lit_by(&scene.lights), lit_by(&[]));
            let (one, rest) = (lit_by(&[*first]), lit_by(others));
            for i in 0..all.len() {
                let (together, apart) = (all[i] + none[i], one[i] + rest[i]);
                let difference = (together - apart).abs();
                assert!(
                    difference.cmple(bar * (together + apart)).all(),
                    "{name}, scene {seed}: {together} and {apart}"
                );
            }
        }
        1
    });
    assert!(asked.sum::<u32>() > 100);
}

/// A ray that is followed farther, or for less of a contribution, sees no less light: no term is
/// negative, and rounding never turns "no less" into "less".
#[test]
fn a_larger_budget_never_darkens() {
    let mut budgets: Vec<PathBudget> = [0, 1, 2, 3, 5, 8, 20, MAX_DEPTH]
        .into_iter()
        .map(PathBudget::new)
        .collect();
    for budget in &mut budgets[..4] {
        budget.min_throughput = 0.3;
    }
    (0..300).into_par_iter().for_each(|seed| {
        let (scene, camera) = ordinary(seed, false);
        for (name, tracer) in budgeted() {
            let mut brighter = 0;
            let mut before = vec![DVec3::ZERO; SIZE.element_product() as usize];
            for &budget in &budgets {
                let after = radiance(&tracer(&scene, camera, budget));
                for (before, after) in before.iter().zip(&after) {
                    assert!(
                        after.cmpge(*before).all(),
                        "{name}, scene {seed}, {budget:?}: {before} to {after}"
                    );
                    brighter += u32::from(after != before);
                }
                before = after;
            }
            assert!(brighter > 0, "{name}, scene {seed} is black");
        }
    });
}

/// A rigid motion: a turn about the origin, then a shift.
struct Motion {
    /// Two mirror planes through the origin, by their unit normals: what is mirrored in both is
    /// turned.
    mirrors: [DVec3; 2],
    shift: DVec3,
}

impl Motion {
    fn turned(&self, v: Vec3) -> DVec3 {
        let mirrored = |v: DVec3, &n: &DVec3| v - 2.0 * v.dot(n) * n;
        self.mirrors.iter().fold(v.as_dvec3(), mirrored)
    }

    fn direction(&self, v: Vec3) -> Vec3 {
        self.turned(v).as_vec3()
    }

    fn point(&self, p: Vec3) -> Vec3 {
        (self.turned(p) + self.shift).as_vec3()
    }

    fn moved(
        &self,
        (scene, camera): (Scene<Absorbing>, Camera),
    ) -> (Scene<Absorbing>, Camera) {
        let objects = scene.objects.into_iter().map(|object| Object {
            shape: match object.shape {
                Shape::Sphere(Sphere { centre, radius }) => {
                    Shape::sphere(self.point(centre), radius)
                }
                Shape::Plane(Plane { point, normal, .. }) => {
                    Shape::plane(self.point(point), self.direction(normal))
                }
            },
            ..object
        });
        let lights = scene.lights.into_iter().map(|light| PointLight {
            position: self.point(light.position),
            ..light
        });
        let scene = Scene {
            objects: objects.collect(),
            lights: lights.collect(),
            background: scene.background,
        };
        let [forward, up] = [camera.forward, camera.up].map(|v| self.direction(v));
        let camera =
            Camera::new(self.point(camera.eye), forward, up, camera.focal_length);
        (scene, camera.expect("its directions are orthonormal"))
    }
}

/// Returns an ordinary scene without patterns: where their squares begin is the world's matter.
fn plain(seed: u32) -> (Scene<Absorbing>, Camera) {
    let (scene, camera) = ordinary(seed, true);
    let scene = scene.map(|mut absorbing| {
        let colour = &mut absorbing.material.phong.colour;
        if let Texture::Checker(even, _) = *colour {
            *colour = Texture::Solid(even);
        }
        absorbing
    });
    (scene, camera)
}

/// Returns the fraction of the pixels of many scenes that a motion changes by more than half a
/// level.
fn changed(tracer: Tracer, depth: u32, distance: f64) -> f64 {
    let of_scene = |seed: u32| {
        let random = &mut Random::new(seed);
        let motion = Motion {
            mirrors: [random.direction(), random.direction()],
            shift: distance * random.direction(),
        };
        let before = plain(seed);
        let after = motion.moved(before.clone());
        let [before, after] = [before, after].map(|(scene, camera)| {
            radiance(&tracer(&scene, camera, PathBudget::new(depth)))
        });
        let level = |light: DVec3| light.to_array().map(oracle::level);
        let differs = |&(&before, &after): &(&DVec3, &DVec3)| {
            let (before, after) = (level(before), level(after));
            (0..3).any(|i| (before[i] - after[i]).abs() > 0.5)
        };
        before.iter().zip(&after).filter(differs).count()
    };
    const SCENES: u32 = 400;
    let changed: usize = (0..SCENES).into_par_iter().map(of_scene).sum();
    changed as f64 / f64::from(SCENES * SIZE.element_product())
}

/// Turned about the origin and moved a distance away together with its eye, a scene looks as
/// before. Its coordinates are rounded by some ε of that distance and of the ten units that the
/// scene is wide: where an edge is as near to a ray as that, the pixel may change. A pixel is half a
/// unit wide; with an edge in each of them, that is one in 1 / (4 ε (distance + 10)).
///
/// The chapters with a fixed bias have edges more, where it is just too small or just large enough:
/// they may change 2 pixels of 10,000 more. Measured: at most 17 of 100,000 in these, and in the
/// others none up to ten units away, and 5 of 100,000 a thousand units away.
#[test]
fn a_scene_that_is_turned_and_moved_with_its_eye_looks_the_same() {
    for distance in [0.0, 10.0, 1000.0] {
        let bar = 4.0 * EPS * (distance + 10.0);
        for (name, tracer) in BRANCHED {
            let changed = changed(tracer, 8, distance);
            assert!(changed <= bar, "{name}: {changed}, {distance} away");
        }
        for (name, tracer) in FIRST_HIT.into_iter().chain(UNBRANCHED).chain([OFFSET[0]]) {
            let changed = changed(tracer, 8, distance);
            assert!(changed <= bar + 2e-4, "{name}: {changed}, {distance} away");
        }
    }
}

/// Must fail: from the computed point, a surface shadows itself where rounding has it, and that
/// depends on where it is. Measured: 23 %.
#[test]
fn acne_changes_as_a_scene_is_moved() {
    let (_, without_offset) = OFFSET[1];
    assert!(changed(without_offset, 8, 10.0) > 0.1);
}
