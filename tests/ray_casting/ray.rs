//! The points of a ray, and those through which a camera casts one.

use ::ray_casting::scene::still_life_camera;
use ::ray_casting::{Camera, GROUND, Ray, SKY, trace};
use glam::{Vec2, Vec3, vec3};
use harness::{EPS, cases, unit_vector};
use proptest::prelude::*;

/// Small whole numbers and halves: no step is rounded.
#[test]
fn the_point_at_t_is_t_directions_from_the_origin() {
    let ray = Ray {
        origin: vec3(1.0, 2.0, 3.0),
        direction: vec3(0.5, -2.0, 4.0),
    };
    assert_eq!(ray.at(0.0), ray.origin);
    assert_eq!(ray.at(2.0), vec3(2.0, -2.0, 11.0));
    assert_eq!(ray.at(3.0), vec3(2.5, -4.0, 15.0));
}

proptest! {
    #![proptest_config(cases(20_000))]

    /// The ray through (x, y) meets the image plane, a focal length away along `forward`, x to
    /// the right of its middle and y above it. The direction's three products and two sums are
    /// rounded by ε/2 each, its normalisation by 2 ε, the basis by 4 ε, of the point's distance
    /// from the eye: 9 ε, and the test scales that by the same distance over the focal length.
    #[test]
    fn a_cameras_ray_goes_through_its_point_of_the_image_plane(
        forward in unit_vector(), x in -2.0_f32..2.0, y in -2.0_f32..2.0,
        focal_length in 0.25_f32..16.0,
    ) {
        let up = forward.any_orthonormal_vector().as_vec3();
        let eye = vec3(1.0, -2.0, 3.0);
        let camera = Camera::new(eye, forward.as_vec3(), up, focal_length).expect("a camera");
        let ray = camera.ray(Vec2::new(x, y));
        prop_assert_eq!(ray.origin, eye);
        let direction = ray.direction.as_dvec3();
        let [right, up, forward] =
            [camera.right, camera.up, camera.forward].map(|axis| direction.dot(axis.as_dvec3()));
        let focal_length = f64::from(focal_length);
        let scale = focal_length / forward;
        let (x, y) = (f64::from(x), f64::from(y));
        let distance = (x * x + y * y + focal_length * focal_length).sqrt();
        let bar = 9.0 * EPS * distance * distance / focal_length;
        prop_assert!((right * scale - x).abs() <= bar, "{} {x}", right * scale);
        prop_assert!((up * scale - y).abs() <= bar, "{} {y}", up * scale);
    }
}

/// Left-handed: with x to the right and y up, z points away from the viewer.
#[test]
fn a_camera_is_not_a_mirror() {
    let camera = still_life_camera();
    assert!(camera.right.cross(camera.up).dot(camera.forward) > 0.99);
    let ray = |x, y| camera.ray(Vec2::new(x, y)).direction;
    assert!(ray(1.0, 0.0).x > ray(-1.0, 0.0).x);
    assert!(ray(0.0, 1.0).y > ray(0.0, -1.0).y);
}

/// From 7 in front of the balls' axis, and 2 above the ground, at what is 0.9 high on the axis: on
/// the way (0, −1.1, 7), of whose 7.09 the roundings of three products and sums are 4 ε.
#[test]
fn the_still_lifes_camera_looks_at_the_axis_of_the_still_life() {
    let ray = still_life_camera().ray(Vec2::ZERO);
    let t = 50.21_f32.sqrt();
    let target = ray.at(t);
    assert!(
        target.distance(vec3(0.0, 0.9, 0.0)) <= 4.0 * f32::EPSILON * t,
        "{target}"
    );
}

/// The sky begins where a ray rises, however little; a level ray does not.
#[test]
fn the_sky_is_above_the_horizon_and_the_ground_is_not() {
    let seen = |y| {
        trace(&Ray {
            origin: Vec3::ZERO,
            direction: vec3(1.0, y, 0.0),
        })
    };
    assert_eq!([seen(1.0), seen(1e-45)], [SKY; 2]);
    assert_eq!(
        [seen(0.0), seen(-0.0), seen(-1e-45), seen(-1.0)],
        [GROUND; 4]
    );
}
