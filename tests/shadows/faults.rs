//! Kinds of fault that others reported: two objects with one surface, where a shadow ray ends,
//! which side a hit is on, and lights out of range.

use ::plane_hit::{Object, Shape};
use ::ray_casting::{MAX_LENGTH, Ray};
use ::shadows::{
    CoincidentSurfaces, Interaction, PointLight, Scene, is_on_surface, is_visible,
};
use ::sphere_hit::T_MAX;
use glam::{DVec3, Vec3, vec3};
use harness::{EPS, cases, magnitude, special, special_vector, unit_vector};
use proptest::prelude::*;

fn object(name: &'static str, shape: Shape) -> Object<()> {
    Object {
        name,
        shape,
        material: (),
    }
}

fn scene(shapes: &[Shape]) -> Scene<()> {
    let objects = shapes.iter().map(|shape| object("", *shape)).collect();
    Scene::new(objects, vec![], Vec3::ZERO).expect("distinct surfaces")
}

fn light(position: Vec3) -> PointLight {
    PointLight::new(position, 1.0).expect("in range")
}

/// A ball twice, a plane by two of its points, a plane from its other side, and each of them up
/// to rounding. A ball in a ball, balls that touch and planes that cross are accepted.
#[test]
fn two_objects_with_one_surface_are_refused_by_their_names() {
    let ball = Shape::sphere(vec3(1.0, 2.0, 3.0), 1.5);
    let tilted =
        |point: Vec3, sign: f32| Shape::plane(point, sign * vec3(0.1, 1.0, -0.05));
    let on_it = vec3(1.0, -0.1, 0.0) + vec3(0.0, 0.05, 1.0) * 40.0;
    for [first, second] in [
        [ball, ball],
        [ball, Shape::sphere(vec3(1.0, 2.0, 3.0_f32.next_up()), 1.5)],
        [ball, Shape::sphere(vec3(1.0, 2.0, 3.0), 1.5_f32.next_up())],
        [tilted(Vec3::ZERO, 1.0), tilted(on_it, 1.0)],
        [tilted(Vec3::ZERO, 1.0), tilted(on_it, -1.0)],
    ] {
        let objects = vec![
            object("first", first),
            object("between", Shape::plane(9.0 * Vec3::X, Vec3::X)),
            object("second", second),
        ];
        let error = Scene::new(objects, vec![], Vec3::ZERO).expect_err("one surface");
        assert_eq!(error, CoincidentSurfaces(["first", "second"]));
        let line = "first and second have the same surface; move one of them";
        assert_eq!(error.to_string(), line);
    }
    for [first, second] in [
        [ball, Shape::sphere(vec3(1.0, 2.0, 3.0), 1.4999)],
        [ball, Shape::sphere(vec3(1.0, 2.0, 3.001), 1.5)],
        [ball, Shape::sphere(vec3(4.0, 2.0, 3.0), 1.5)],
        [tilted(Vec3::ZERO, 1.0), tilted(1e-3 * Vec3::Y, 1.0)],
        [tilted(Vec3::ZERO, 1.0), Shape::plane(Vec3::ZERO, Vec3::Y)],
    ] {
        let objects = vec![object("first", first), object("second", second)];
        assert!(Scene::new(objects, vec![], Vec3::ZERO).is_ok());
    }
}

/// Two spheres are one if neither centre nor radius differs by more than 16 ε of the sum of the
/// centre's coordinates and the radius: that is the limit, whichever of the two is larger.
#[test]
fn how_near_two_surfaces_must_be_to_be_one() {
    let are_one = |first, second| {
        let objects = vec![object("first", first), object("second", second)];
        Scene::new(objects, vec![], Vec3::ZERO).is_err()
    };
    let sphere = |x, radius| Shape::sphere(Vec3::new(x, 0.0, 0.0), radius);
    let eps = f32::EPSILON;
    for [x, radius] in [[1.0, 1.0], [1.0, 99.0], [64.0, 0.5], [1e-4, 1e-4]] {
        let limit = 16.0 * eps * (x + radius);
        for (off, is_one) in [(0.8, true), (1.3, false)] {
            let moved = sphere(x + off * limit, radius);
            assert_eq!(are_one(sphere(x, radius), moved), is_one, "{x} {radius}");
            let grown = sphere(x, radius + off * limit);
            assert_eq!(are_one(sphere(x, radius), grown), is_one, "{x} {radius}");
        }
    }
    // Turned by a few ε about a point of the first plane: it is on the first one, while the
    // first one's own point, far away, is no longer on the second.
    let floor = Shape::plane(Vec3::ZERO, Vec3::Y);
    let turned = Shape::plane(1000.0 * Vec3::X, vec3(8.0 * eps, 1.0, 0.0));
    assert!(
        is_on_surface(&floor, 1000.0 * Vec3::X) && !is_on_surface(&turned, Vec3::ZERO)
    );
    assert!(are_one(floor, turned) && are_one(turned, floor));
}

/// How near is near enough depends on the size of the numbers: at a height of a thousandth, a
/// plane and a point 10⁻⁸ above it are far apart.
#[test]
fn a_point_just_above_a_small_plane_is_not_on_it() {
    for height in [1e-3, 1.0, 1e3] {
        let plane = Shape::plane(height * Vec3::Y, Vec3::Y);
        assert!(is_on_surface(
            &plane,
            height * (1.0 + 2.0 * f32::EPSILON) * Vec3::Y
        ));
        assert!(!is_on_surface(&plane, height * (1.0 + 1e-5) * Vec3::Y));
    }
}

/// Of the sphere's tangent planes a light on the sphere is above none, also where rounding has
/// put it a little outside.
#[test]
fn a_light_on_a_sphere_is_in_front_of_no_point_of_it() {
    for i in 1..10_000 {
        let [x, y, z] = harness::evenly(i);
        let direction = (DVec3::new(x, y, z) - 0.5).normalize().as_vec3();
        for radius in [0.25, 1.0, 1024.0] {
            let objects = [object("", Shape::sphere(Vec3::ZERO, radius))];
            let lamp = radius * direction;
            let ray = Ray {
                origin: 2.0 * lamp,
                direction: -direction,
            };
            let hit = ::plane_hit::nearest(&objects, &ray).expect("a hit");
            let at = Interaction::new(&objects, &ray, hit);
            assert!(!at.is_in_front(lamp), "{direction}, {radius}");
        }
    }
}

/// A lamp at y = 2e19 lit the shadow of a ball: its distance's square is infinite.
#[test]
fn a_light_out_of_range_is_refused() {
    for y in [2e19, 1e18, -2e15, f32::INFINITY, f32::NAN] {
        assert_eq!(PointLight::new(y * Vec3::Y, 1.0), None);
    }
    for intensity in [-1e-45, 2e15, f32::INFINITY, f32::NAN] {
        assert_eq!(PointLight::new(Vec3::Y, intensity), None);
    }
    assert!(PointLight::new(Vec3::splat(MAX_LENGTH), 0.0).is_some());
}

/// Returns the hit of a ray that comes straight down on the floor y = 0.
fn on_the_floor(objects: &[Object<()>], x: f32, z: f32) -> Interaction {
    let ray = Ray {
        origin: vec3(x, 1e-2, z),
        direction: Vec3::NEG_Y,
    };
    Interaction::new(objects, &ray, (0, 1e-2))
}

/// On the ceiling y = 4: 5,492 of 44,160 pixels of the floor were dark.
#[test]
fn a_light_on_the_ceiling_lights_the_whole_floor() {
    let floor = Shape::plane(Vec3::ZERO, Vec3::Y);
    let ceiling = Shape::plane(4.0 * Vec3::Y, Vec3::NEG_Y);
    let scene = scene(&[floor, ceiling]);
    let lamp = light(vec3(0.3, 4.0, 1.7));
    for x in -200..200 {
        for z in -200..200 {
            let [x, z] = [x, z].map(|i| i as f32 * 0.173);
            let at = on_the_floor(&scene.objects, x, z);
            assert!(is_visible(&scene, &at, &lamp), "{x} {z}");
        }
    }
}

proptest! {
    #![proptest_config(cases(200_000))]

    /// On a ceiling or a wall, however tilted, seen from however flat an angle: the plane itself
    /// never hides it.
    #[test]
    fn a_light_on_a_plane_is_not_hidden_by_the_plane(
        normal in unit_vector(), point in unit_vector(), distance in magnitude(-1.0..2.0),
        along in unit_vector(), far in magnitude(-1.0..2.0), x in -9.0..9.0_f32, z in -9.0..9.0_f32,
    ) {
        let point = (distance * point).as_vec3();
        let plane = Shape::plane(point, normal.as_vec3());
        let floor = Shape::plane(Vec3::ZERO, Vec3::Y);
        let position = (point.as_dvec3() + far * along.cross(normal)).as_vec3();
        // Well above the floor.
        prop_assume!(position.y > 0.01);
        let scene = scene(&[floor, plane]);
        let at = on_the_floor(&scene.objects, x, z);
        prop_assert!(is_on_surface(&plane, position));
        prop_assert!(is_visible(&scene, &at, &light(position)));
    }

    /// On a ball it is hidden by the ball if it is on the far side, and only then.
    #[test]
    fn a_light_on_a_ball_is_hidden_by_the_ball_on_its_far_side_alone(
        centre in unit_vector(), away in 0.0..9.0_f64, radius in magnitude(-2.0..2.0),
        out in unit_vector(), x in -9.0..9.0_f32, z in -9.0..9.0_f32,
    ) {
        let centre = (away * centre + (radius + 0.1) * DVec3::Y).as_vec3();
        let ball = Shape::sphere(centre, radius as f32);
        let position = (centre.as_dvec3() + radius * out).as_vec3();
        prop_assume!(position.y > 0.01);
        let scene = scene(&[Shape::plane(Vec3::ZERO, Vec3::Y), ball]);
        let at = on_the_floor(&scene.objects, x, z);
        prop_assume!(at.point.as_dvec3().distance(centre.as_dvec3()) > radius * 1.01);
        let to_light = (position - at.point).as_dvec3().normalize();
        let cosine = out.dot(to_light);
        // At the horizon of the ball either will do.
        prop_assume!(cosine.abs() > 0.02);
        prop_assert!(is_on_surface(&ball, position));
        prop_assert_eq!(is_visible(&scene, &at, &light(position)), cosine < 0.0);
    }

    /// A thousandth before a plane or behind it is not on it.
    #[test]
    fn a_light_near_a_plane_is_seen_from_its_own_side_alone(
        normal in unit_vector(), height in prop_oneof![Just(1e-3), Just(-1e-3)],
        x in -9.0..9.0_f32, z in -9.0..9.0_f32,
    ) {
        let point = 4.0 * DVec3::Y;
        let plane = Shape::plane(point.as_vec3(), normal.as_vec3());
        let scene = scene(&[Shape::plane(Vec3::ZERO, Vec3::Y), plane]);
        let at = on_the_floor(&scene.objects, x, z);
        let side = (at.point.as_dvec3() - point).dot(normal);
        prop_assume!(side.abs() > 0.1);
        let light = light((point + height * normal).as_vec3());
        prop_assert_eq!(is_visible(&scene, &at, &light), (side > 0.0) == (height > 0.0));
    }

    /// From outside and from inside, of rays that touch the sphere too: from up to a million
    /// radii away. The angle between the ray and the normal is obtuse, and the ray is outside if
    /// and only if it enters.
    #[test]
    fn a_normal_never_faces_away_from_its_ray(
        out in unit_vector(), distance in magnitude(-2.0..6.0), radius in magnitude(-15.0..8.0),
        height in prop_oneof![Just(0.0), magnitude(-9.0..-0.1), magnitude(-9.0..-0.1).prop_map(|h| -h)],
    ) {
        let objects = [object("", Shape::sphere(Vec3::ZERO, radius as f32))];
        let along = out.any_orthonormal_vector();
        let origin = radius * ((1.0 - height) * out - distance * along);
        let ray = Ray { origin: origin.as_vec3(), direction: along.as_vec3() };
        let from_centre = ray.origin.as_dvec3().length() / f64::from(radius as f32);
        prop_assume!((from_centre - 1.0).abs() > 8.0 * EPS);
        if let Some(t) = objects[0].shape.distance(&ray, T_MAX) {
            let at = Interaction::new(&objects, &ray, (0, t));
            prop_assert!(at.normal.dot(at.incident) < 0.0, "{at:?}");
            prop_assert_eq!(at.enters(), from_centre > 1.0);
            prop_assert!((at.normal.as_dvec3().length() - 1.0).abs() <= 4.0 * EPS);
            let exact = if at.enters() { at.normal } else { -at.normal };
            prop_assert_eq!(at.outward, exact);
        }
    }

    /// Zero, subnormal, huge, infinite and NaN in each place.
    #[test]
    fn what_the_constructor_of_a_light_accepts_is_in_range(
        position in special_vector(), intensity in special()
    ) {
        let is_in_range = position.to_array().iter().all(|x| x.abs() <= MAX_LENGTH)
            && (0.0..=MAX_LENGTH).contains(&intensity);
        prop_assert_eq!(PointLight::new(position, intensity).is_some(), is_in_range);
    }
}

/// Far from the origin of the world a horizontal floor is where it is: only the coordinate along
/// its normal counts.
#[test]
fn a_point_above_a_floor_is_not_on_it_however_far_it_is() {
    let floor = |x: f32| Shape::plane(x * Vec3::X, Vec3::Y);
    for (shape, point) in [
        (floor(0.0), vec3(1e6, 0.2, 0.0)),
        (floor(0.0), vec3(1e4, 0.002, 0.0)),
        (floor(0.0), vec3(100.0, 1e-5, 100.0)),
        (floor(1e7), Vec3::Y),
        (Shape::sphere(-1e6 * Vec3::Y, 1e6), 0.3 * Vec3::Y),
        (Shape::sphere(-1e5 * Vec3::Y, 1e5), 0.04 * Vec3::Y),
        (Shape::sphere(-1e4 * Vec3::Y, 1e4), 0.004 * Vec3::Y),
    ] {
        assert!(!is_on_surface(&shape, point), "{shape:?} {point}");
    }
    let objects = vec![
        object("floor", Shape::plane(vec3(1e6, 0.0, 0.0), Vec3::Y)),
        object("step", Shape::plane(0.2 * Vec3::Y, Vec3::Y)),
    ];
    let reversed = objects.iter().rev().cloned().collect();
    for objects in [objects, reversed] {
        assert!(Scene::new(objects, vec![], Vec3::ZERO).is_ok());
    }
}
