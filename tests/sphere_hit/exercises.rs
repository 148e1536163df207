//! The exercises' checks. Yours are judged by name:
//! `cargo test --test sphere_hit exercise_1 -- --ignored`.

use crate::solutions;
use ::canvas::{Picture, Pixel};
use ::ray_casting::scene::still_life_camera;
use ::ray_casting::{Camera, Ray, trace};
use ::sphere_hit::{STAGE, Sphere, T_MAX, exercises};
use glam::{DVec3, Vec3};
use harness::{Numbers, SMALL, check_solution, evenly, judge, percent};

const SPHERE: Sphere = Sphere {
    centre: Vec3::new(0.5, -1.0, 2.0),
    radius: 1.5,
};

/// Returns rays from around a sphere and from within it, of which about two thirds hit it.
fn rays(sphere: Sphere) -> impl Iterator<Item = Ray> {
    (0..1000).map(move |i| {
        let from = 3.0 * (2.0 * DVec3::from(evenly(i)) - 1.0).as_vec3();
        let to = (2.0 * DVec3::from(evenly(i + 5000)) - 1.0).as_vec3();
        Ray {
            origin: sphere.centre + sphere.radius * from,
            direction: (to - from).normalize(),
        }
    })
}

/// The two distances at which a ray meets an ellipsoid, or, with three equal axes, a sphere;
/// `None` if it misses it, or passes so close to its edge that rounding decides.
fn both_hits(centre: Vec3, semi_axes: Vec3, ray: &Ray) -> Option<[f64; 2]> {
    let semi_axes = semi_axes.as_dvec3();
    let from = (ray.origin.as_dvec3() - centre.as_dvec3()) / semi_axes;
    let direction = ray.direction.as_dvec3() / semi_axes;
    let [a, b] = [direction.dot(direction), direction.dot(from)];
    let discriminant = b * b - a * (from.dot(from) - 1.0);
    (discriminant > 1e-3 * a).then(|| {
        let root = discriminant.sqrt();
        [(-b - root) / a, (-b + root) / a]
    })
}

/// Checks the first hit of many rays, the directions of which are `length` long.
fn check_first(
    [centre, semi_axes]: [Vec3; 2],
    length: f32,
    distance: impl Fn(&Ray, f32) -> Option<f32>,
) {
    let mut hits = 0;
    let around = Sphere {
        centre,
        radius: semi_axes.max_element(),
    };
    for mut ray in rays(around) {
        ray.direction *= length;
        let what = format!("{ray:?}, a direction of length {length}");
        let Some(roots) = both_hits(centre, semi_axes, &ray) else {
            continue;
        };
        // On the surface rounding decides.
        if roots.iter().any(|t| (t * f64::from(length)).abs() < 1e-3) {
            continue;
        }
        let yours = distance(&ray, T_MAX);
        let Some(right) = roots.into_iter().find(|&t| t > 0.0) else {
            assert_eq!(yours, None, "behind the ray: {what}");
            continue;
        };
        hits += 1;
        let t = yours
            .unwrap_or_else(|| panic!("no hit, and there is one at {right}: {what}"));
        let error = (f64::from(t) - right).abs() * f64::from(length);
        assert!(error < 1e-3, "yours is {t}, right is {right}: {what}");
        assert_eq!(
            distance(&ray, 0.9 * right as f32),
            None,
            "beyond t_max: {what}"
        );
    }
    assert!(hits > 100, "only {hits} rays hit it");
    let away = Ray {
        origin: centre + 2.0 * around.radius * Vec3::Y,
        direction: length * Vec3::X,
    };
    assert_eq!(distance(&away, T_MAX), None, "a miss: {away:?}");
}

fn check_1(distance: fn(&Sphere, &Ray, f32) -> Option<f32>) {
    for length in [1.0, 0.5, 3.0] {
        let sphere = [SPHERE.centre, Vec3::splat(SPHERE.radius)];
        check_first(sphere, length, |ray, t_max| distance(&SPHERE, ray, t_max));
    }
}

fn check_2(far_distance: fn(&Sphere, &Ray) -> Option<f32>) {
    for ray in rays(SPHERE) {
        let axes = Vec3::splat(SPHERE.radius);
        let Some([_, far]) = both_hits(SPHERE.centre, axes, &ray) else {
            continue;
        };
        let yours = far_distance(&SPHERE, &ray);
        match yours {
            Some(t) => assert!(
                (f64::from(t) - far).abs() < 1e-3,
                "{ray:?}: yours is {t}, right is {far}"
            ),
            None => assert!(far < 1e-3, "{ray:?}: none, and there is one at {far}"),
        }
    }
    let miss = Ray {
        origin: SPHERE.centre + 2.0 * Vec3::Y,
        direction: Vec3::X,
    };
    assert_eq!(far_distance(&SPHERE, &miss), None, "a miss");
}

fn check_4(distance: fn(Vec3, Vec3, &Ray, f32) -> Option<f32>) {
    for semi_axes in [
        Vec3::splat(1.5),
        Vec3::new(1.0, 2.0, 0.5),
        Vec3::new(3.0, 0.4, 1.0),
    ] {
        let ellipsoid = [SPHERE.centre, semi_axes];
        check_first(ellipsoid, 1.0, |ray, t_max| {
            distance(SPHERE.centre, semi_axes, ray, t_max)
        });
    }
}

#[test]
#[ignore = "an exercise for you"]
fn exercise_1() {
    check_1(exercises::distance_of_any_direction);
}

#[test]
#[ignore = "an exercise for you"]
fn exercise_2() {
    check_2(exercises::far_distance);
}

#[test]
#[ignore = "an exercise for you"]
fn exercise_4() {
    check_4(exercises::ellipsoid_distance);
}

#[test]
fn the_exercises_are_judged_rightly() {
    let source = include_str!("../../chapters/02-sphere-hit/src/exercises.rs");
    judge(source, "distance_of_any_direction", exercise_1, || {
        check_1(solutions::distance_of_any_direction);
    });
    judge(source, "far_distance", exercise_2, || {
        check_2(solutions::far_distance);
    });
    judge(source, "ellipsoid_distance", exercise_4, || {
        check_4(solutions::ellipsoid_distance);
    });
}

#[test]
fn the_solutions_are_those_in_the_book() {
    let sphere = Sphere::new(Vec3::ZERO, 1.0).expect("a sphere");
    let camera = |eye, focal_length| {
        Camera::new(eye, Vec3::Z, Vec3::Y, focal_length).expect("a camera")
    };
    let within = camera(Vec3::ZERO, 1.0);
    let inside = Picture::new(move |pixel| {
        let ray = within.ray(pixel.centre());
        let t = solutions::far_distance(&sphere, &ray).expect("a wall all around");
        (sphere.normal(ray.at(t)) + Vec3::ONE) / 2.0
    });
    check_solution(&STAGE, "exercise-2", &inside);

    let camera_of_life = still_life_camera();
    let ellipsoid = Picture::new(move |pixel| {
        let ray = camera_of_life.ray(pixel.centre());
        let centre = Vec3::new(0.0, 1.0, 1.0);
        let semi_axes = Vec3::new(2.5, 1.0, 0.6);
        match solutions::ellipsoid_distance(centre, semi_axes, &ray, T_MAX) {
            // Its normal is the gradient of the left side of its equation.
            Some(t) => {
                let gradient = (ray.at(t) - centre) / (semi_axes * semi_axes);
                (gradient.normalize() + Vec3::ONE) / 2.0
            }
            None => trace(&ray),
        }
    });
    check_solution(&STAGE, "exercise-4", &ellipsoid);

    // The view `far-textbook`, a thousand radii away, compared with f64.
    let to_centre = 1001.0_f32;
    let focal_length = 0.8 * (to_centre * to_centre - 1.0).sqrt();
    let far = camera(to_centre * Vec3::NEG_Z, focal_length);
    let pixels = (SMALL.x * SMALL.y) as usize;
    let wrong = |distance: fn(&Sphere, &Ray, f32) -> Option<f32>| {
        let is_wrong = |pixel: &Pixel| {
            let ray = far.ray(pixel.centre());
            let right = sphere.hit_in_f64(&ray, T_MAX).is_some();
            distance(&sphere, &ray, T_MAX).is_some() != right
        };
        percent(Pixel::all(SMALL).filter(is_wrong).count(), pixels)
    };
    let mut numbers = Numbers::default();
    numbers.note("wrong-textbook", wrong(Sphere::distance_quadratic));
    numbers.note("wrong-divided", wrong(solutions::distance_of_any_direction));
    numbers.note("wrong-stable", wrong(Sphere::distance));
    numbers.check("02-sphere-hit-exercises");
}
