//! The ends of the range of cosines and of indices.

use ::fresnel::{fresnel, scatter};
use ::plane_hit::Shape;
use ::refraction::Optics;
use ::shadows::Interaction;
use glam::{Vec3, vec3};
use harness::cases;
use proptest::prelude::*;

/// Between any two different media, even if their indices are neighbours and have a ratio of 1.
#[test]
fn along_an_interface_all_light_is_reflected() {
    for eta in [1e-3_f32, 1.0, 1.333_333_3, 1.5, 1.999_999_9, 1e3] {
        for other in [eta.next_down(), eta.next_up(), 0.5 * eta, 3.0 * eta] {
            assert_eq!(fresnel(0.0, eta, other), 1.0, "{eta} to {other}");
        }
    }
}

proptest! {
    #![proptest_config(cases(50_000))]

    /// A fraction of the light, for any cosine and indices, neighbours among them.
    #[test]
    fn the_reflectance_is_a_fraction(
        cos_theta_i in 0.0..=1.0_f32, eta_i in 0.1..10.0_f32, ulps in -3_i32..4,
        eta_t in 0.1..10.0_f32, are_neighbours in any::<bool>(),
    ) {
        let neighbour = f32::from_bits(eta_i.to_bits().wrapping_add_signed(ulps));
        let eta_t = if are_neighbours { neighbour } else { eta_t };
        let reflectance = fresnel(cos_theta_i, eta_i, eta_t);
        prop_assert!((0.0..=1.0).contains(&reflectance), "{reflectance}");
    }
}

/// What reflects nothing scatters nothing: there is no ray of weight 0 to be followed.
#[test]
fn a_surface_that_is_no_mirror_scatters_no_ray() {
    let incident = vec3(0.6, -0.8, 0.0);
    let at = Interaction {
        index: 0,
        shape: Shape::plane(Vec3::ZERO, Vec3::Y),
        t: 1.0,
        point: Vec3::ZERO,
        incident,
        outward: Vec3::Y,
        normal: Vec3::Y,
    };
    let opaque = |reflectivity| scatter(&Optics::Opaque { reflectivity }, &at, fresnel);
    assert_eq!(opaque(0.0), [None, None]);
    let [reflected, None] = opaque(1e-30) else {
        panic!("an opaque surface transmits nothing");
    };
    assert_eq!(reflected.map(|(weight, _)| weight), Some(1e-30));
}
