//! Kinds of fault that others reported: squares that leave f32's range, and a sign that
//! rounding decides.

use ::ray_casting::{MAX_LENGTH, Ray};
use ::sphere_hit::{Sphere, T_MAX};
use glam::Vec3;
use harness::{EPS, cases, magnitude, special, special_vector, unit_vector};
use proptest::prelude::*;

/// Between 1e-15 and 1e15, and no coordinate beyond 1e15: a radius of 1e-23 was accepted, and
/// its square was 0.
#[test]
fn a_sphere_out_of_range_is_refused() {
    for radius in [1e-23, 1e-16, 2e15, 1e20] {
        assert_eq!(Sphere::new(Vec3::ZERO, radius), None, "{radius}");
    }
    for x in [2e15, -1e16, 1e20] {
        assert_eq!(Sphere::new(x * Vec3::Y, 1.0), None, "{x}");
    }
    assert!(Sphere::new(Vec3::splat(-MAX_LENGTH), MAX_LENGTH).is_some());
    assert!(Sphere::new(Vec3::ZERO, 1.0 / MAX_LENGTH).is_some());
}

proptest! {
    #![proptest_config(cases(100_000))]

    /// Over the whole range of radii, of centres and of lengths of the direction. The ray comes
    /// from up to a thousand radii away, towards a point half a radius from the centre: there
    /// the hit of f64 is near, to the roundings of coordinates as large as the centre's.
    #[test]
    fn a_hit_over_the_whole_range_is_that_of_f64(
        radius in magnitude(-14.9..11.9), towards in unit_vector(), aside in unit_vector(),
        distance in magnitude(0.5..3.0), centre in unit_vector(),
        away in prop_oneof![Just(0.0), magnitude(-2.0..3.0)], length in magnitude(-3.0..3.0),
    ) {
        let centre = (away * radius * centre).as_vec3();
        let sphere = Sphere::new(centre, radius as f32).expect("in range");
        let origin = (centre.as_dvec3() - distance * radius * towards).as_vec3();
        let aim = centre.as_dvec3() + 0.5 * radius * aside;
        let direction = (length * (aim - origin.as_dvec3()).normalize()).as_vec3();
        let ray = Ray { origin, direction };
        let farthest = (distance + 2.0) * radius / length;
        prop_assume!(farthest < f64::from(T_MAX));
        let t = sphere.distance(&ray, T_MAX).map(f64::from);
        let exact = sphere.hit_in_f64(&ray, T_MAX).map(|hit| f64::from(hit.t));
        let (Some(t), Some(exact)) = (t, exact) else {
            return Err(TestCaseError::fail(format!("{t:?} {exact:?} {sphere:?} {ray:?}")));
        };
        // The closest approach is at most 0.5 radii from the centre: the slope of the sphere is
        // less than 1.
        let error = (t - exact).abs() * length / radius;
        prop_assert!(error <= 32.0 * EPS * (distance + away), "{error:e}");
        let normal = sphere.normal(ray.at(t as f32)).as_dvec3();
        prop_assert!((normal.length() - 1.0).abs() <= 4.0 * EPS);
        prop_assert!(sphere.is_entered(&ray, t as f32));
    }

    /// From outside a ray enters and then leaves, from inside it leaves; a ray that touches the
    /// sphere or only grazes it does as well, from however far, although the normal at the
    /// computed point may face away from it.
    #[test]
    fn the_first_of_two_hits_enters_and_the_second_leaves(
        out in unit_vector(), distance in magnitude(-3.0..6.0),
        height in prop_oneof![Just(0.0), magnitude(-9.0..0.0)],
    ) {
        let sphere = Sphere::new(Vec3::ZERO, 1.0).expect("a sphere");
        let along = out.any_orthonormal_vector();
        let direction = along.as_vec3();
        let origin = ((1.0 - height) * out - distance * along).as_vec3();
        let ray = Ray { origin, direction };
        let is_outside = origin.as_dvec3().length() > 1.0 + 4.0 * EPS;
        if let (Some(t), true) = (sphere.distance(&ray, T_MAX), is_outside) {
            prop_assert!(sphere.is_entered(&ray, t));
        }
        let inside = Ray { origin: 0.9 * out.as_vec3(), direction };
        let t = sphere.distance(&inside, T_MAX).expect("from inside it leaves");
        prop_assert!(!sphere.is_entered(&inside, t));
    }

    /// Zero, subnormal, huge, infinite and NaN in each place.
    #[test]
    fn what_a_constructor_accepts_is_in_range(centre in special_vector(), radius in special()) {
        let is_in_range = centre.to_array().iter().all(|x| x.abs() <= MAX_LENGTH)
            && (1.0 / MAX_LENGTH..=MAX_LENGTH).contains(&radius);
        prop_assert_eq!(Sphere::new(centre, radius).is_some(), is_in_range);
    }
}
