//! A light is occluded by objects between it and a point, and by no others.

use ::plane_hit::{Object, Plane, Shape};
use ::ray_casting::Ray;
use ::shadows::scene::lit_still_life;
use ::shadows::{
    Interaction, PointLight, SHADOW_BIAS, STAGE, Scene, is_occluded, is_on_surface,
    is_visible, is_visible_buggy,
};
use ::sphere_hit::{Sphere, T_MAX};
use canvas::rays_so_far;
use glam::{DVec3, Vec3, dvec3, vec3};
use harness::{SMALL, cases, render, special, special_vector, unit_vector};
use oracle::{Camera, Optics, Surface, Texture};
use proptest::prelude::*;

fn object(shape: Shape) -> Object<()> {
    Object {
        name: "",
        shape,
        material: (),
    }
}

fn light(position: Vec3) -> PointLight {
    PointLight {
        position,
        intensity: 1.0,
    }
}

/// Returns a floor at y = 0, a ball of radius 1 with its centre at `height`, and a light at
/// (0, 10, 0), all at a `scale`.
fn ball_above_floor(height: f32, scale: f32) -> Scene<()> {
    let ball = Shape::sphere(scale * height * Vec3::Y, scale);
    let floor = Shape::plane(Vec3::ZERO, Vec3::Y);
    Scene {
        objects: vec![object(floor), object(ball)],
        lights: vec![light(scale * 10.0 * Vec3::Y)],
        background: Vec3::ZERO,
    }
}

/// Returns a plane of any numbers, whether or not [`Plane::new`] would accept them.
fn plane(point: Vec3, normal: Vec3) -> Plane {
    Plane {
        point,
        normal,
        axes: [Vec3::X, Vec3::Z],
    }
}

/// Returns the hit of a ray that comes straight down on a plane.
fn at(point: Vec3, normal: Vec3) -> Interaction {
    Interaction {
        index: 0,
        shape: Shape::Plane(plane(point, normal)),
        t: 1.0,
        point,
        incident: -normal,
        outward: normal,
        normal,
    }
}

/// Returns whether the light is visible from the floor at `x`, in units of the scale.
fn is_lit(x: f32, scale: f32) -> bool {
    let scene = ball_above_floor(1.0, scale);
    is_visible(&scene, &at(x * scale * Vec3::X, Vec3::Y), &scene.lights[0])
}

/// A unit ball on the floor, 9 below a light, has a shadow of radius 10/√80 = 1.11803399: the
/// ray that touches the ball has sin = 1/9, and tan = 1/√80. The same at larger scales.
#[test]
fn the_shadow_of_a_ball_ends_where_the_tangent_meets_the_floor() {
    for scale in [1.0, 1e3, 1e6] {
        assert!(!is_lit(0.01, scale));
        assert!(!is_lit(1.117, scale));
        assert!(is_lit(1.119, scale));
    }
}

/// The bug: in a scene a thousand times smaller the fixed bias is a tenth of the ball's
/// radius, and light falls into its shadow. The chapter about shadow acne has the cure.
#[test]
fn a_fixed_bias_shrinks_the_shadow_of_a_small_ball() {
    assert!(is_lit(1.117, 1e-3));
    assert!(is_lit(1.119, 1e-3));
}

/// A unit ball at (0, 20, 0), beyond the light at (0, 10, 0), casts no shadow. The lecture's
/// buggy shadow has one, of the rays that go on to hit the ball.
#[test]
fn a_ball_beyond_the_light_casts_no_shadow_but_for_the_bug() {
    let scene = ball_above_floor(20.0, 1.0);
    for x in [0.0, 0.5, -0.9] {
        let at = at(x * Vec3::X, Vec3::Y);
        assert!(is_visible(&scene, &at, &scene.lights[0]));
        assert!(!is_visible_buggy(&scene, &at, &scene.lights[0]));
    }
}

/// Its top is at 9.9, the light at 10.
#[test]
fn a_ball_just_before_the_light_casts_a_shadow() {
    let scene = ball_above_floor(8.9, 1.0);
    assert!(!is_visible(
        &scene,
        &at(Vec3::ZERO, Vec3::Y),
        &scene.lights[0]
    ));
}

/// Below the floor, or at the point itself. Above it, it is visible from however near, even
/// from below the start of the shadow ray.
#[test]
fn a_light_is_visible_above_the_surface_and_not_below() {
    let scene = ball_above_floor(1.0, 1.0);
    let at = at(3.0 * Vec3::X, Vec3::Y);
    let is_visible = |y| is_visible(&scene, &at, &light(vec3(3.0, y, 0.0)));
    assert!(!is_visible(-1.0));
    assert!(!is_visible(0.0));
    assert!(is_visible(SHADOW_BIAS / 2.0));
    assert!(is_visible(SHADOW_BIAS));
    assert!(is_visible(0.01));
}

/// A ball hides the light from its own far side. From `SHADOW_BIAS` above it a ray would slip
/// past its edge until √(2 · `SHADOW_BIAS`) = 0.014 rad beyond the terminator, and there
/// would be a bright band.
///
/// The light is 100 radii away along x: n·l = 100 nₓ − 1, and the terminator is at nₓ = 0.01.
#[test]
fn a_ball_is_in_its_own_shadow_just_beyond_the_terminator() {
    let scene = ball_above_floor(1.0, 1.0);
    let light = light(vec3(100.0, 1.0, 0.0));
    for (sine, expected) in [(0.02_f32, true), (0.005, false), (-0.01, false)] {
        let normal = vec3(sine, 0.0, (1.0 - sine * sine).sqrt());
        let shape = scene.objects[1].shape;
        let at = Interaction {
            shape,
            ..at(Vec3::Y + normal, normal)
        };
        assert_eq!(is_visible(&scene, &at, &light), expected);
    }
}

/// A light behind the surface takes no ray.
#[test]
fn a_light_in_front_takes_one_ray_whether_or_not_it_is_visible() {
    let scene = ball_above_floor(1.0, 1.0);
    for (x, y, visible, rays) in [
        (3.0, 10.0, true, 1),
        (0.1, 10.0, false, 1),
        (3.0, -1.0, false, 0),
    ] {
        let before = rays_so_far();
        let at = at(x * Vec3::X, Vec3::Y);
        assert_eq!(is_visible(&scene, &at, &light(y * Vec3::Y)), visible);
        assert_eq!(rays_so_far() - before, rays);
    }
}

/// From inside a sphere that is the inward normal; the outward one is what the shape says.
#[test]
fn an_interaction_has_the_point_and_the_normals_of_the_hit() {
    let ball = object(Shape::sphere(2.0 * Vec3::Z, 1.0));
    let floor = object(Shape::plane(Vec3::ZERO, Vec3::Y));
    let objects = [floor, ball];
    let ray = |z, direction| Ray {
        origin: z * Vec3::Z,
        direction,
    };
    for (ray, t, point, outward, normal) in [
        (ray(-4.0, Vec3::Z), 5.0, Vec3::Z, Vec3::NEG_Z, Vec3::NEG_Z),
        (ray(2.0, Vec3::NEG_Z), 1.0, Vec3::Z, Vec3::NEG_Z, Vec3::Z),
    ] {
        let at = Interaction::new(&objects, &ray, (1, t));
        let incident = ray.direction;
        let expected = Interaction {
            index: 1,
            shape: objects[1].shape,
            t,
            point,
            incident,
            outward,
            normal,
        };
        assert_eq!(at, expected);
    }
}

proptest! {
    #![proptest_config(cases(100_000))]

    /// Zero, subnormal, huge, infinite and NaN in every field: what hides the light hides
    /// everything beyond it, too. A light farther away than `T_MAX` is left out.
    #[test]
    fn what_the_bug_finds_visible_is_visible_whatever_the_numbers(
        point in special_vector(),
        normal in prop_oneof![special_vector(), unit_vector().prop_map(|n| n.as_vec3())],
        position in special_vector(), intensity in special(), centre in special_vector(),
        radius in special(), plane_point in special_vector(), plane_normal in special_vector(),
    ) {
        let scene = Scene {
            objects: vec![
                object(Shape::Sphere(Sphere { centre, radius })),
                object(Shape::Plane(plane(plane_point, plane_normal))),
            ],
            lights: vec![],
            background: Vec3::ZERO,
        };
        let at = at(point, normal);
        let light = PointLight { position, intensity };
        let is_beyond = !((position - point).length() < T_MAX);
        prop_assert!(
            is_visible(&scene, &at, &light)
                || !is_visible_buggy(&scene, &at, &light)
                || is_beyond
        );
    }

    /// Zero, subnormal, huge, infinite and NaN in every field; the light is on no surface.
    #[test]
    fn a_ray_is_occluded_if_and_only_if_an_object_has_a_distance(
        origin in special_vector(), direction in special_vector(), centre in special_vector(),
        radius in special(), point in special_vector(), normal in special_vector(),
        t_max in special(), light in special_vector(),
    ) {
        let sphere = Shape::Sphere(Sphere { centre, radius });
        let plane = Shape::Plane(plane(point, normal));
        let ray = Ray { origin, direction };
        let has_distance = |shape: &Shape| shape.distance(&ray, t_max).is_some();
        let expected = has_distance(&sphere) || has_distance(&plane);
        prop_assume!(!is_on_surface(&sphere, light) && !is_on_surface(&plane, light));
        let objects = [sphere, plane].map(object);
        let before = rays_so_far();
        prop_assert_eq!(is_occluded(&objects, &ray, light, t_max), expected);
        prop_assert_eq!(rays_so_far() - before, 1);
    }
}

/// The scene of the views `beyond` and `beyond-buggy`, written out once more.
fn light_between_balls() -> (oracle::Scene, Camera) {
    let object = |shape, colour| oracle::Object {
        shape,
        surface: Surface {
            texture: Texture::Solid(colour),
            ambient: 0.0,
            diffuse: 0.0,
            specular: 0.0,
            shininess: 1,
        },
        optics: Optics::Opaque(0.0),
    };
    let ball = |height| oracle::Shape::Sphere {
        centre: dvec3(0.0, height, 0.0),
        radius: 0.5,
    };
    let floor = oracle::Shape::Plane {
        point: DVec3::ZERO,
        normal: DVec3::Y,
    };
    let scene = oracle::Scene {
        objects: vec![
            object(floor, DVec3::splat(0.7)),
            object(ball(0.5), dvec3(0.9, 0.3, 0.05)),
            object(ball(3.0), dvec3(0.1, 0.5, 0.6)),
        ],
        lights: vec![oracle::PointLight {
            position: dvec3(0.7, 2.0, 0.0),
            intensity: 1.0,
        }],
        background: dvec3(0.2, 0.5, 0.8),
    };
    let camera = Camera::upright(dvec3(0.0, 2.5, -8.0), dvec3(0.3, -1.0, 8.0), 3.0);
    (scene, camera)
}

/// The views `beyond-buggy`, in which pixels of the floor are dark that should not be, and
/// `beyond`, which agrees with the oracle everywhere but at a few edges.
#[test]
fn the_shadow_of_a_ball_beyond_the_light_is_in_the_buggy_view_alone() {
    let [bug, cure] =
        ["beyond-buggy", "beyond"].map(|view| render(&STAGE, view, SMALL).radiance);
    let (scene, camera) = light_between_balls();
    let [mut wrongly_dark, mut wrongly_lit, mut cure_differs] = [0, 0, 0];
    let centres = oracle::pixel_centres(SMALL.to_array());
    for (centre, (bug, cure)) in centres.zip(bug.into_iter().zip(cure)) {
        let ray = camera.ray(centre, SMALL.to_array());
        let truth = oracle::trace_shadows(&scene, &ray).as_vec3();
        let is_floor = scene.intersect(&ray).is_some_and(|at| at.object == 0);
        cure_differs += usize::from(cure.distance(truth) > 1e-3);
        wrongly_dark += usize::from(is_floor && bug == Vec3::ZERO && truth != Vec3::ZERO);
        wrongly_lit += usize::from(bug.length() > cure.length());
    }
    // Measured: 3,048 of 76,800 pixels.
    assert!(wrongly_dark > 3_000, "{wrongly_dark}");
    assert_eq!(wrongly_lit, 0);
    // Measured: 4, all at the edge of a shadow, which the bias moves.
    assert!(cure_differs <= 8, "{cure_differs}");
}

#[test]
fn a_scene_with_other_materials_keeps_all_else() {
    let scene = lit_still_life([1, 2, 3, 4, 5, 6]);
    let mapped = scene.clone().map(|material| 10 * material);
    assert_eq!(mapped.lights, scene.lights);
    assert_eq!(mapped.background, scene.background);
    assert_eq!(mapped.objects.len(), scene.objects.len());
    for (object, mapped) in scene.objects.iter().zip(mapped.objects) {
        assert_eq!((mapped.name, mapped.shape), (object.name, object.shape));
        assert_eq!(mapped.material, 10 * object.material);
    }
}
