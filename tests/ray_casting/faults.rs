//! Kinds of fault that others reported: numbers out of range.

use ::ray_casting::{Camera, MAX_LENGTH, is_length, is_position};
use glam::{Vec2, Vec3};
use harness::{cases, magnitude, special, special_vector, unit_vector};
use proptest::prelude::*;

#[test]
fn a_length_is_from_1e_minus_15_to_1e15() {
    let [least, most] = [1.0 / MAX_LENGTH, MAX_LENGTH];
    assert!(is_length(least) && is_length(most));
    let too_short = [least.next_down(), 0.0, -1.0, f32::NAN];
    let too_long = [most.next_up(), f32::INFINITY];
    for number in too_short.into_iter().chain(too_long) {
        assert!(!is_length(number), "{number}");
    }
}

proptest! {
    #![proptest_config(cases(100_000))]

    /// Zero, subnormal, huge, infinite and NaN in each place.
    #[test]
    fn a_position_has_finite_coordinates_in_range(point in special_vector()) {
        let in_range = |x: f32| x.abs() <= MAX_LENGTH;
        prop_assert_eq!(is_position(point), point.to_array().into_iter().all(in_range));
    }

    /// Over the whole range of eyes and focal lengths: every ray has a unit direction, that of
    /// the middle of an image of one pixel, too.
    #[test]
    fn a_camera_of_any_focal_length_in_range_casts_unit_directions(
        eye in unit_vector(), distance in magnitude(-15.0..15.0),
        forward in unit_vector(), focal_length in magnitude(-14.9..14.9),
        x in -20.0..20.0_f32, y in -1.0..1.0_f32,
    ) {
        let eye = (distance * eye).as_vec3();
        let up = forward.any_orthonormal_vector().as_vec3();
        let camera = Camera::new(eye, forward.as_vec3(), up, focal_length as f32);
        let camera = camera.expect("in range");
        for point in [Vec2::ZERO, Vec2::new(x, y)] {
            let length = camera.ray(point).direction.as_dvec3().length();
            prop_assert!((length - 1.0).abs() <= 4e-7, "{length}");
        }
    }

    /// A focal length of 2e19 made every direction zero, one of 1e-30 the middle one NaN.
    #[test]
    fn a_camera_out_of_range_is_refused(
        eye in special_vector(),
        focal_length in prop_oneof![special(), Just(2e19), Just(1e-30), Just(1.0)],
    ) {
        let camera = Camera::new(eye, Vec3::Z, Vec3::Y, focal_length);
        prop_assert_eq!(camera.is_some(), is_position(eye) && is_length(focal_length));
    }
}
