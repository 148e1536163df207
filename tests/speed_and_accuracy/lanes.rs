//! The formulas that are timed in full registers: they are the chapters' own.

use glam::Vec3;
use measure::Random;
use measure::inputs::{from_afar, plane_ray, refractions, sphere_rays};
use packets::Lanes;
use plane_hit::Plane;
use speed_and_accuracy::lanes::{
    self, plane, refract_by_textbook, refract_tangential, results, sphere_quadratic,
    sphere_stable,
};
use speed_and_accuracy::studies::{plane as planes, refraction, sphere};
use sphere_hit::{Sphere, T_MAX};
use wide::f64x8;

/// Rays from outside: the near root is the hit.
#[test]
fn a_spheres_formulas_have_the_bits_of_its_methods() {
    let ball = Sphere::new(Vec3::ZERO, 1.0).expect("a sphere");
    let rays = sphere_rays(ball, |random| from_afar(random, 10.0));
    let cases = rays.iter().map(|((sphere, ray), _)| {
        let radius = Vec3::splat(sphere.radius);
        [ray.origin, ray.direction, sphere.centre, radius]
    });
    let cases: Vec<[Vec3; 4]> = cases.collect();
    let quadratic: Vec<[f32; 1]> = results(&cases, sphere_quadratic);
    let stable: Vec<[f32; 1]> = results(&cases, sphere_stable);
    let mut hits = 0;
    for (((sphere, ray), _), ([quadratic], [stable])) in
        rays.iter().zip(quadratic.iter().zip(&stable))
    {
        let number = |t: &f32| (!t.is_nan()).then_some(*t);
        assert_eq!(sphere.distance_quadratic(ray, T_MAX), number(quadratic));
        assert_eq!(sphere.distance(ray, T_MAX), number(stable));
        hits += u32::from(!stable.is_nan());
    }
    assert!(hits > 500, "only {hits} hits");
}

#[test]
fn a_planes_formula_has_the_bits_of_its_method() {
    let mut random = Random::new(3);
    let rays = (0..1000).map(|_| plane_ray(&mut random, [10.0, 0.0, 0.5]).0);
    let rays: Vec<(Plane, _)> = rays.collect();
    let cases = rays
        .iter()
        .map(|(plane, ray)| [ray.origin, ray.direction, plane.point, plane.normal]);
    let cases: Vec<[Vec3; 4]> = cases.collect();
    let ts: Vec<[f32; 1]> = results(&cases, plane);
    for ((plane, ray), [t]) in rays.iter().zip(ts) {
        assert_eq!(plane.distance(ray, T_MAX), Some(t));
    }
}

#[test]
fn refractions_formula_has_the_bits_of_its_function() {
    let cases = refractions(|random| (random.f64(), random.between(0.5, 2.0)));
    let inputs = cases
        .iter()
        .map(|((incident, normal, eta), _)| [*incident, *normal, Vec3::splat(*eta)]);
    let inputs: Vec<[Vec3; 3]> = inputs.collect();
    let directions: Vec<[f32; 3]> = results(&inputs, lanes::refract);
    for (((incident, normal, eta), _), direction) in cases.iter().zip(directions) {
        let direction = Vec3::from_array(direction);
        let expected = ::refraction::refract(*incident, *normal, *eta);
        assert_eq!(expected, (!direction.is_nan()).then_some(direction));
    }
}

/// By hand: a dot product is 5 operations, a sum or a difference of vectors 3, a vector times
/// a number 3, a unit vector 5 + 1 + 1 + 3.
#[test]
fn operations_are_counted() {
    let lanes_of = |rows: Vec<speed_and_accuracy::table::Measurement>| -> Vec<f64> {
        let rows = rows.into_iter().filter(|row| row.scene == "lanes");
        rows.map(|row| row.work.expect("operations")).collect()
    };
    let clock = speed_and_accuracy::study::Clock::STOPPED;
    let spheres = lanes_of((sphere::STUDY.measure)(&clock));
    // o − c, d·oc, oc·oc, b² − (… − r²), √, one sum.
    assert_eq!(spheres[0], f64::from(3 + 5 + 5 + 2 + 2 + 1 + 1));
    // o − c, d·d, d·oc / …, oc + t d, r² − …·…, √(… / …), one sum.
    assert_eq!(spheres[1], f64::from(3 + 5 + 6 + 6 + 7 + 2 + 1));
    assert_eq!(spheres[1], spheres[2]);
    let planes = lanes_of((planes::STUDY.measure)(&clock));
    assert_eq!(planes, [14.0, 12.0, 14.0]);
    let refractions = lanes_of((refraction::STUDY.measure)(&clock));
    assert_eq!(refractions[2], refractions[1] + 10.0);
}

/// Each lane has the result that its case has alone.
#[test]
fn lanes_have_the_results_of_single_cases() {
    let cases = refractions(|random| (random.f64(), 0.7));
    let inputs = cases
        .iter()
        .map(|((incident, normal, eta), _)| [*incident, *normal, Vec3::splat(*eta)]);
    let inputs: Vec<[Vec3; 3]> = inputs.take(64).collect();
    let single: Vec<[f32; 3]> = results(&inputs, refract_by_textbook);
    let packed: Vec<[Lanes; 3]> = results(&inputs, refract_by_textbook);
    let double: Vec<[f64; 3]> = results(&inputs, refract_tangential);
    let packed_double: Vec<[f64x8; 3]> = results(&inputs, refract_tangential);
    for (i, (single, double)) in single.iter().zip(&double).enumerate() {
        for axis in 0..3 {
            assert_eq!(packed[i / 16][axis].to_array()[i % 16], single[axis]);
            assert_eq!(packed_double[i / 8][axis].to_array()[i % 8], double[axis]);
        }
    }
}
