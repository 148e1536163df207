//! The two sides of a shape: in front of a plane and behind it, outside a ball and in it.

use ::plane_hit::Shape;
use ::ray_casting::Ray;
use ::sphere_hit::T_MAX;
use glam::{DVec3, Vec3, vec3};
use harness::{cases, unit_vector};
use proptest::prelude::*;

/// Returns a ray that passes a point along a direction, from some distance before it.
fn through(point: DVec3, direction: DVec3, distance: f64) -> Ray {
    Ray {
        origin: (point - distance * direction).as_vec3(),
        direction: direction.as_vec3(),
    }
}

/// Returns whether a shape contains the points of a ray just before its hit, and just beyond it.
fn before_and_beyond(shape: &Shape, ray: &Ray, t: f32) -> [bool; 2] {
    [-0.1, 0.1].map(|by| shape.contains(ray.at(t + by)))
}

proptest! {
    #![proptest_config(cases(20_000))]

    /// Where a ray enters a shape it comes from outside and goes inside, where it leaves one it
    /// comes from inside and goes outside. A plane is met at a cosine of at least a tenth: a tenth
    /// before the hit and beyond it is a hundredth from the plane. A ball of radius 1 is met at
    /// most 0.9 from its centre, from outside it or from that point of the chord.
    #[test]
    fn a_ray_that_enters_comes_from_outside_and_goes_inside(
        out in unit_vector(), direction in unit_vector(), place in unit_vector(),
        approach in 0.0..0.9_f64, distance in 2.0..20.0_f64, starts_inside in any::<bool>(),
    ) {
        let place = 3.0 * place;
        let cosine = direction.dot(out);
        prop_assume!(cosine.abs() > 0.1);
        let plane = Shape::plane(place.as_vec3(), out.as_vec3());
        let ray = through(place, direction, distance);
        let t = plane.distance(&ray, T_MAX).expect("it is ahead");
        prop_assert_eq!(plane.is_entered(&ray, t), cosine < 0.0);
        prop_assert_eq!(before_and_beyond(&plane, &ray, t), [cosine > 0.0, cosine < 0.0]);

        let ball = Shape::sphere(place.as_vec3(), 1.0);
        let aside = direction.any_orthonormal_vector();
        let distance = if starts_inside { 0.0 } else { distance };
        let ray = through(place + approach * aside, direction, distance);
        let t = ball.distance(&ray, T_MAX).expect("it is ahead");
        prop_assert_eq!(ball.is_entered(&ray, t), !starts_inside);
        prop_assert_eq!(before_and_beyond(&ball, &ray, t), [starts_inside, !starts_inside]);
    }
}

/// Whole numbers, in which nothing is rounded.
#[test]
fn a_point_of_the_surface_is_not_inside() {
    let ball = Shape::sphere(vec3(1.0, 2.0, 3.0), 5.0);
    let wall = Shape::plane(vec3(1.0, 2.0, 3.0), Vec3::X);
    for on_the_ball in [
        vec3(6.0, 2.0, 3.0),
        vec3(4.0, 6.0, 3.0),
        vec3(1.0, 5.0, -1.0),
    ] {
        assert!(!ball.contains(on_the_ball));
        let from_centre = on_the_ball - vec3(1.0, 2.0, 3.0);
        assert!(ball.contains(on_the_ball - 1e-3 * from_centre));
        assert!(!ball.contains(on_the_ball + 1e-3 * from_centre));
    }
    for in_the_wall in [vec3(1.0, 2.0, 3.0), vec3(1.0, -8.0, 9.0)] {
        assert!(!wall.contains(in_the_wall));
        assert!(wall.contains(in_the_wall - 1e-3 * Vec3::X));
    }
}
