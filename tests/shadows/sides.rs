//! A light in front of a surface is on the side from which the ray comes.

use ::plane_hit::{Object, Shape, nearest};
use ::ray_casting::Ray;
use ::shadows::Interaction;
use glam::{DVec3, Vec3, vec3};
use harness::{cases, unit_vector};
use proptest::prelude::*;

/// Returns the hit of a ray on the only object of a scene.
fn hit(shape: Shape, origin: DVec3, direction: DVec3) -> Interaction {
    let objects = [Object {
        name: "",
        shape,
        material: (),
    }];
    let ray = Ray {
        origin: origin.as_vec3(),
        direction: direction.as_vec3(),
    };
    let hit = nearest(&objects, &ray).expect("a hit");
    Interaction::new(&objects, &ray, hit)
}

proptest! {
    #![proptest_config(cases(20_000))]

    /// Whether the ray comes from outside or from inside: light and ray must be on the same side of
    /// the plane that touches the surface at the hit. Nearer to that plane than a thousandth, rounding
    /// may decide.
    #[test]
    fn a_light_in_front_is_on_the_side_of_the_ray(
        out in unit_vector(), direction in unit_vector(), place in unit_vector(),
        to_light in unit_vector(), light_distance in 0.1..5.0_f64,
    ) {
        let cosine = direction.dot(out);
        prop_assume!(cosine.abs() > 0.1);
        // The plane touches the ball, which is behind it.
        let shapes = [
            Shape::plane(place.as_vec3(), out.as_vec3()),
            Shape::sphere((place - out).as_vec3(), 1.0),
        ];
        let light = place + light_distance * to_light;
        let height = to_light.dot(out) * light_distance;
        prop_assume!(height.abs() > 1e-3);
        let is_outside = cosine < 0.0;
        for shape in shapes {
            // The way through the ball is 2 · cosine long: from inside the ray begins in its middle.
            let at = hit(shape, place - cosine.abs() * direction, direction);
            prop_assert!(at.point.as_dvec3().distance(place) < 1e-5);
            prop_assert_eq!(at.enters(), is_outside);
            prop_assert_eq!(at.is_in_front(light.as_vec3()), (height > 0.0) == is_outside);
        }
    }
}

/// In whole numbers nothing is rounded: from above and from below, the light is not in front.
#[test]
fn a_light_in_a_plane_is_in_front_of_neither_side() {
    let floor = Shape::plane(2.0 * Vec3::Y, Vec3::Y);
    for direction in [DVec3::Y, DVec3::NEG_Y] {
        let at = hit(floor, 2.0 * DVec3::Y - 5.0 * direction, direction);
        for light in [vec3(7.0, 2.0, -3.0), at.point] {
            assert!(!at.is_in_front(light));
        }
        assert!(at.is_in_front(at.point - 1e-3 * at.incident));
        assert!(!at.is_in_front(at.point + 1e-3 * at.incident));
    }
}
