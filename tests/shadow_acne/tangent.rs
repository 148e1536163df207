//! Rays along a surface: they do not enter it, and are not hit by it.

use ::plane_hit::Shape;
use ::ray_casting::Ray;
use ::shadow_acne::{exit_distance, from_eye, from_surface};
use ::shadows::Interaction;
use ::sphere_hit::{Sphere, T_MAX};
use glam::{Vec3, vec3};
use plane_hit::Object;

const BALL: Sphere = Sphere {
    centre: vec3(1.0, 2.0, 3.0),
    radius: 5.0,
};

/// The point of the ball at its right, (6, 2, 3), is exact, and so is all that is at right angles.
#[test]
fn a_ray_along_a_ball_or_a_plane_does_not_enter_it() {
    let point = BALL.centre + 5.0 * Vec3::X;
    for shape in [Shape::Sphere(BALL), Shape::plane(point, Vec3::X)] {
        let at = Interaction {
            index: 0,
            shape,
            t: 1.0,
            point,
            incident: Vec3::NEG_X,
            outward: Vec3::X,
            normal: Vec3::X,
        };
        let objects = [Object {
            name: "",
            shape,
            material: (),
        }];
        for (direction, enters) in [
            (Vec3::Y, false),
            (Vec3::NEG_Z, false),
            (Vec3::X, false),
            (vec3(1e-6, 1.0, 0.0), false),
            (vec3(-1e-6, 1.0, 0.0), true),
            (Vec3::NEG_X, true),
        ] {
            let origin = point;
            for ray in [
                from_surface(&at, direction),
                from_eye(&objects, origin)(Ray { origin, direction }),
            ] {
                assert_eq!((ray.origin, ray.enters), (Some(0), enters), "{direction}");
                assert_eq!(ray.ray, Ray { origin, direction });
            }
        }
    }
}

/// From (6, 2, 3) straight through: 10 away is not before 10. Along the ball there is no way
/// through it, and outwards the other root is behind.
#[test]
fn an_exit_is_ahead_and_before_the_end() {
    let exit = |direction, t_max| {
        let origin = BALL.centre + 5.0 * Vec3::X;
        exit_distance(&BALL, &Ray { origin, direction }, t_max)
    };
    assert_eq!(exit(Vec3::NEG_X, T_MAX), Some(10.0));
    assert_eq!(exit(Vec3::NEG_X, 10.0_f32.next_up()), Some(10.0));
    assert_eq!(exit(Vec3::NEG_X, 10.0), None);
    assert_eq!(exit(2.0 * Vec3::NEG_X, T_MAX), Some(5.0));
    for direction in [Vec3::Y, Vec3::Z, Vec3::X, Vec3::ZERO] {
        assert_eq!(exit(direction, T_MAX), None, "{direction}");
    }
}
