//! A camera has an orthonormal basis, or is refused.

use ::ray_casting::Camera;
use ::ray_casting::scene::still_life_camera;
use glam::{Vec2, Vec3};
use harness::{EPS, cases, magnitude, special, special_vector, unit_vector};
use proptest::prelude::*;

/// Returns whether the three vectors are of length 1, within 4 ε, and perpendicular, within
/// ε times the bound.
fn is_orthonormal(camera: &Camera, bound: f64) -> bool {
    let basis = [camera.right, camera.up, camera.forward].map(|v| v.as_dvec3());
    let [right, up, forward] = basis;
    let angles = [right.dot(up), up.dot(forward), forward.dot(right)];
    basis.iter().all(|v| (v.length() - 1.0).abs() <= 4.0 * EPS)
        && angles.iter().all(|cos| cos.abs() <= bound * EPS)
}

/// Parallel up to rounding, for all lengths.
#[test]
fn a_camera_that_looks_along_its_up_is_refused() {
    for scale in [1e-15, 1e-3, 1.0, 7.0, 1e3, 1e15] {
        for up in [Vec3::Y, Vec3::new(1.0, 2.0, -3.0), Vec3::new(0.1, 0.7, 0.3)] {
            for forward in [scale * up, -scale * up] {
                assert_eq!(Camera::new(Vec3::ZERO, forward, up, 1.0), None);
            }
        }
    }
}

/// No direction, no focal length, or anything that is not finite.
#[test]
fn a_camera_that_could_see_nothing_is_refused() {
    let refused = |eye, forward, up, focal_length| {
        assert_eq!(Camera::new(eye, forward, up, focal_length), None);
    };
    refused(Vec3::ZERO, Vec3::ZERO, Vec3::Y, 1.0);
    refused(Vec3::ZERO, Vec3::Z, Vec3::ZERO, 1.0);
    for x in [f32::NAN, f32::INFINITY, f32::NEG_INFINITY] {
        refused(Vec3::new(x, 0.0, 0.0), Vec3::Z, Vec3::Y, 1.0);
        refused(Vec3::ZERO, Vec3::new(0.0, x, 1.0), Vec3::Y, 1.0);
        refused(Vec3::ZERO, Vec3::Z, Vec3::new(0.0, x, 1.0), 1.0);
        refused(Vec3::ZERO, Vec3::Z, Vec3::Y, x);
    }
    refused(Vec3::ZERO, Vec3::Z, Vec3::Y, 0.0);
    refused(Vec3::ZERO, Vec3::Z, Vec3::Y, -1.0);
}

/// It looks along (0, −1.1, 7): right is (1, 0, 0), up is (0, 7, 1.1) normalised. A focal
/// length of 1 + √2 = 1/tan(45°/2) is 45° from top to bottom.
#[test]
fn the_still_lifes_camera_sees_forty_five_degrees_upright() {
    let camera = still_life_camera();
    assert_eq!(camera.right, Vec3::X);
    let up = Vec3::new(0.0, 7.0, 1.1).normalize();
    assert!(camera.up.distance(up) <= 4.0 * f32::EPSILON);
    let [top, bottom] = [1.0, -1.0].map(|y| camera.ray(Vec2::new(0.0, y)).direction);
    let cos_45 = 0.5_f64.sqrt();
    assert!((top.as_dvec3().dot(bottom.as_dvec3()) - cos_45).abs() <= 4.0 * EPS);
}

proptest! {
    #![proptest_config(cases(20_000))]

    /// Lengths of 10⁻¹⁵ to 10¹⁵ do not matter, nor does an angle of a hundredth: the cross
    /// product of unit vectors is wrong by 2 ε, and its normalisation multiplies that by
    /// 1/sin.
    #[test]
    fn a_camera_has_an_orthonormal_basis(
        forward in unit_vector(), up in unit_vector(),
        lengths in [magnitude(-15.0..15.0), magnitude(-15.0..15.0)],
        x in -2.0_f32..2.0, y in -2.0_f32..2.0,
    ) {
        let sine = forward.cross(up).length();
        prop_assume!(sine > 0.01);
        let forward = (lengths[0] * forward).as_vec3();
        let up = (lengths[1] * up).as_vec3();
        let camera = Camera::new(Vec3::ZERO, forward, up, 1.0).expect("a camera");
        prop_assert!(is_orthonormal(&camera, 4.0 / sine));
        let direction = camera.ray(Vec2::new(x, y)).direction.as_dvec3();
        prop_assert!((direction.length() - 1.0).abs() <= 4.0 * EPS);
    }

    /// Zero, subnormal, huge, infinite and NaN. The least angle that is accepted has a sine of
    /// 10⁻⁵.
    #[test]
    fn a_camera_of_any_numbers_has_a_finite_eye_and_an_orthonormal_basis_or_is_refused(
        eye in special_vector(), forward in special_vector(), up in special_vector(),
        focal_length in special(),
    ) {
        if let Some(camera) = Camera::new(eye, forward, up, focal_length) {
            prop_assert!(is_orthonormal(&camera, 4.0 / 1e-5), "{camera:?}");
            prop_assert!(camera.eye.is_finite());
        }
    }
}
