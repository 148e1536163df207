//! Lights on surfaces, and patterns on them.

use crate::scenes::{ball, object, ray, scene};
use glam::{DVec2, DVec3, dvec2, dvec3};
use harness::{cases, unit_vector};
use oracle::{Optics, PointLight, Scene, Shape};
use proptest::prelude::*;

fn matte(shape: Shape) -> oracle::Object {
    object(shape, 0.0, Optics::Opaque(0.0))
}

/// Returns a point of a plane, rounded.
fn in_plane(point: DVec3, normal: DVec3, [a, b]: [f64; 2]) -> DVec3 {
    let u = normal.any_orthonormal_vector();
    point + a * u + b * normal.cross(u)
}

/// Returns whether the light at a place arrives at what a ray hits first.
fn is_lit(scene: &Scene, seen_by: &oracle::Ray, position: DVec3) -> bool {
    let at = scene.intersect(seen_by).expect("a hit");
    let light = PointLight {
        position,
        intensity: 1.0,
    };
    scene.visibility(&at, &light) == DVec3::ONE
}

proptest! {
    #![proptest_config(cases(20_000))]

    /// From a point between two planes, either of them is seen by the light on the other, and no point of
    /// a plane by a light behind the plane.
    #[test]
    fn a_light_on_a_plane_is_not_hidden_by_the_plane(
        normal in unit_vector(), tilt in unit_vector(), at in [-30.0..30.0_f64, -30.0..30.0],
        lamp in [-30.0..30.0_f64, -30.0..30.0], distance in 0.01..50.0_f64, world in -100.0..100.0_f64,
    ) {
        // Tilted so little that both are on the same side of each other within the range above.
        let origin = world * dvec3(0.3, -0.7, 0.2);
        let other = (-normal + 1e-4 * distance * tilt).normalize();
        let wall = Shape::Plane { point: origin + distance * normal, normal: other };
        let floor = Shape::Plane { point: origin, normal };
        let scene = scene(vec![matte(floor), matte(wall)], DVec3::ZERO);
        let place = in_plane(origin, normal, at);
        let down = ray(place + 0.1 * distance * normal, -normal);
        let lamp = in_plane(origin + distance * normal, other, lamp);
        prop_assert!(is_lit(&scene, &down, lamp));
        prop_assert!(!is_lit(&scene, &down, lamp - 1e-3 * distance * other));
        prop_assert!(is_lit(&scene, &down, lamp + 1e-3 * distance * other));
    }

    /// A light on a ball shines on all that is in front of its tangent plane, and on nothing behind: there, the
    /// ball is between.
    #[test]
    fn a_light_on_a_ball_is_hidden_by_the_rest_of_the_ball(
        side in unit_vector(), place in unit_vector(), distance in 1.5..50.0_f64,
        centre in unit_vector(), world in 0.0..100.0_f64, radius in 0.1..10.0_f64,
    ) {
        let (centre, place) = (world * centre, radius * distance * place);
        let lamp = centre + radius * side;
        let height = (centre + place - lamp).normalize().dot(side);
        prop_assume!(height.abs() > 1e-3);
        // A small ball is lit on its near side.
        let target = ball(centre + place, 0.1 * radius);
        let scene = scene(vec![matte(ball(centre, radius)), matte(target)], DVec3::ZERO);
        let seen = ray(lamp, centre + place - lamp);
        if height > 0.0 {
            prop_assert!(is_lit(&scene, &seen, lamp));
        } else {
            // From outside the first ball, to the same point.
            let near = centre + place - 0.1 * radius * (centre + place - lamp).normalize();
            let back = ray(near - 1e-6 * radius * (centre + place - near), centre + place - near);
            prop_assert!(!is_lit(&scene, &back, lamp));
        }
    }

    /// Inside a hollow ball, a light on its wall shines on all of the wall.
    #[test]
    fn a_light_on_the_inside_of_a_ball_shines_on_the_inside(
        lamp in unit_vector(), direction in unit_vector(), radius in 0.1..10.0_f64,
        centre in unit_vector(), world in 0.0..100.0_f64,
    ) {
        prop_assume!(lamp.distance(direction) > 1e-3);
        let centre = world * centre;
        let scene = scene(vec![matte(ball(centre, radius))], DVec3::ZERO);
        prop_assert!(is_lit(&scene, &ray(centre, direction), centre + radius * lamp));
    }

    /// All points of a plane have a light in the plane, or as rounded above or below it, on one side.
    #[test]
    fn a_light_in_a_plane_shines_on_all_of_it_or_on_nothing(
        normal in unit_vector(), lamp in [-30.0..30.0_f64, -30.0..30.0], world in -100.0..100.0_f64,
        places in [[-30.0..30.0_f64, -30.0..30.0], [-30.0..30.0_f64, -30.0..30.0]],
    ) {
        let point = world * dvec3(0.3, -0.7, 0.2);
        let scene = scene(vec![matte(Shape::Plane { point, normal })], DVec3::ZERO);
        let lamp = in_plane(point, normal, lamp);
        let [one, other] = places.map(|place| {
            let seen = ray(in_plane(point, normal, place) + 3.0 * normal, -normal);
            is_lit(&scene, &seen, lamp)
        });
        prop_assert_eq!(one, other);
    }

    /// The two coordinates of any plane are lengths along it, from its own point.
    #[test]
    fn coordinates_are_lengths_in_the_plane(
        normal in unit_vector(), places in [[-30.0..30.0_f64, -30.0..30.0], [-30.0..30.0_f64, -30.0..30.0]],
    ) {
        let plane = Shape::Plane { point: dvec3(3.0, -7.0, 2.0), normal };
        let points = places.map(|place| in_plane(dvec3(3.0, -7.0, 2.0), normal, place));
        let [a, b] = points.map(|point| plane.uv(point));
        prop_assert!((a.distance(b) - points[0].distance(points[1])).abs() <= 1e-12);
        prop_assert!((a.length() - dvec2(places[0][0], places[0][1]).length()).abs() <= 1e-12);
        // What is off the plane does not count.
        prop_assert!(plane.uv(points[0] + normal).distance(a) <= 1e-12);
    }
}

/// Floor and ceiling have x and z, a wall in front x and y, one at the side z and y; and a sphere x and z, from
/// its centre.
#[test]
fn coordinates_of_floors_and_walls_are_the_worlds() {
    let at = dvec3(3.5, -2.25, 7.75);
    let plane = |normal| Shape::Plane {
        point: DVec3::ZERO,
        normal,
    };
    for (shape, uv) in [
        (plane(DVec3::Y), dvec2(at.x, at.z)),
        (plane(DVec3::NEG_Y), dvec2(at.x, at.z)),
        (plane(DVec3::Z), dvec2(at.x, at.y)),
        (plane(DVec3::NEG_Z), dvec2(at.x, at.y)),
        (plane(DVec3::X), dvec2(at.z, at.y)),
        (plane(DVec3::NEG_X), dvec2(at.z, at.y)),
        (ball(DVec3::ONE, 3.0), dvec2(2.5, 6.75)),
    ] {
        assert_eq!(shape.uv(at), uv, "{shape:?}");
    }
    let moved = Shape::Plane {
        point: dvec3(0.5, 9.0, 0.25),
        normal: DVec3::Y,
    };
    assert_eq!(moved.uv(dvec3(3.5, 9.0, 7.75)), DVec2::new(3.0, 7.5));
}
