//! Where a sphere and a ray are does not matter, only how they lie to each other.

use ::ray_casting::Ray;
use ::sphere_hit::{Sphere, T_MAX, face_forward};
use glam::{Vec3, vec3};
use harness::{cases, unit_vector};
use proptest::prelude::*;

/// Vectors of whole numbers, the sums of which are exact.
fn whole(limit: i16) -> impl Strategy<Value = Vec3> {
    let number = -limit..=limit;
    [number.clone(), number.clone(), number].prop_map(|v| Vec3::from(v.map(f32::from)))
}

proptest! {
    #![proptest_config(cases(20_000))]

    /// The difference of the ray's origin and the centre has the same bits everywhere, and so
    /// has all that is made of it.
    #[test]
    fn a_sphere_is_hit_at_the_same_distance_anywhere(
        centre in whole(1000), from_centre in whole(20), direction in unit_vector(),
        radius in 1..20_u8,
    ) {
        let radius = f32::from(radius);
        let direction = direction.as_vec3();
        let hit = |centre: Vec3| {
            let sphere = Sphere::new(centre, radius).expect("a sphere");
            let ray = Ray { origin: centre + from_centre, direction };
            (
                sphere.distance_quadratic(&ray, T_MAX),
                sphere.distance(&ray, T_MAX),
                sphere.hit_in_f64(&ray, T_MAX),
                [0.5, 5.0, 20.0].map(|t| sphere.is_entered(&ray, t)),
            )
        };
        prop_assert_eq!(hit(centre), hit(Vec3::ZERO));
    }

    /// From outside all hits are ahead or none is, and what is behind a ray is before its
    /// opposite. Of the textbook's formula only what is far from a rounding is asked: inside
    /// half of the radius or outside twice of it.
    #[test]
    fn a_ray_and_its_opposite_meet_the_two_ends_of_a_chord(
        centre in whole(1000), out in unit_vector(), direction in unit_vector(),
        inside in any::<bool>(),
    ) {
        let sphere = Sphere::new(centre, 16.0).expect("a sphere");
        let offset = if inside { 8.0 } else { 32.0 };
        let origin = centre + (offset * out).as_vec3();
        let direction = direction.as_vec3();
        let there = Ray { origin, direction };
        let back = Ray { origin, direction: -direction };
        type Distance = fn(&Sphere, &Ray, f32) -> Option<f32>;
        let methods: [Distance; 3] = [
            Sphere::distance_quadratic,
            Sphere::distance,
            |sphere, ray, t_max| Some(sphere.hit_in_f64(ray, t_max)?.t),
        ];
        for method in methods {
            let hits = [&there, &back].map(|ray| method(&sphere, ray, T_MAX));
            let ahead = hits.iter().flatten().count();
            prop_assert!(if inside { ahead == 2 } else { ahead <= 1 }, "{:?}", hits);
        }
    }
}

/// A ray along the surface is outside, and keeps the outward normal.
#[test]
fn a_ray_along_a_surface_does_not_turn_its_normal() {
    for (normal, along) in [(Vec3::Y, Vec3::X), (vec3(0.6, 0.8, 0.0), Vec3::Z)] {
        for incident in [along, -along] {
            assert_eq!(face_forward(normal, incident), normal);
            assert_eq!(face_forward(-normal, incident), -normal);
        }
    }
}
