//! Kinds of fault that others reported: what is where if clear bodies contain each other,
//! overlap or touch.

use ::plane_hit::{Object, Shape, Texture};
use ::ray_casting::Ray;
use ::reflection::{MAX_DEPTH, PathBudget};
use ::refraction::{Material, Optics};
use ::shading::Phong;
use ::shadow_acne::{from_eye, from_surface};
use ::shadows::{Interaction, PointLight, Scene};
use ::transparency::{
    Absorbing, as_if_alone, between_media, shadow_transmittance, trace,
};
use glam::{DVec3, Vec3, vec3};
use harness::{cases, magnitude, unit_vector};
use proptest::prelude::*;

fn object(
    shape: Shape,
    optics: Optics,
    ambient: f32,
    absorption: f32,
) -> Object<Absorbing> {
    let phong = Phong {
        colour: Texture::Solid(Vec3::ONE),
        ambient,
        diffuse: 0.0,
        // Where there is no interface, there is no highlight either.
        specular: 0.8,
        shininess: 9,
    };
    Object {
        name: "",
        shape,
        material: Absorbing {
            material: Material { phong, optics },
            absorption: Vec3::splat(absorption),
        },
    }
}

/// Returns a clear body of this index in air.
fn clear(shape: Shape, eta_inside: f32, absorption: f32) -> Object<Absorbing> {
    let optics = Optics::Dielectric {
        eta_inside,
        eta_outside: 1.0,
    };
    object(shape, optics, 0.0, absorption)
}

/// Returns a white wall that glows.
fn glowing(shape: Shape) -> Object<Absorbing> {
    object(shape, Optics::Opaque { reflectivity: 0.0 }, 1.0, 0.0)
}

fn ball(y: f32, radius: f32) -> Shape {
    Shape::sphere(y * Vec3::Y, radius)
}

/// Returns all that is below a height.
fn below(y: f32) -> Shape {
    Shape::plane(y * Vec3::Y, Vec3::Y)
}

fn scene(objects: Vec<Object<Absorbing>>) -> Scene<Absorbing> {
    Scene::new(objects, vec![], Vec3::ZERO).expect("distinct surfaces")
}

fn radiance(scene: &Scene<Absorbing>, origin: Vec3, direction: Vec3) -> f64 {
    let ray = from_eye(&scene.objects, origin)(Ray { origin, direction });
    let budget = PathBudget::new(MAX_DEPTH);
    f64::from(trace(scene, &ray, budget, between_media).x)
}

/// Returns the radiance along a ray that comes straight down from y = 9.
fn straight_down(objects: Vec<Object<Absorbing>>) -> f64 {
    radiance(&scene(objects), 9.0 * Vec3::Y, Vec3::NEG_Y)
}

fn is_close(measured: f64, exact: f64) -> bool {
    (measured - exact).abs() <= 4e-5
}

#[expect(clippy::disallowed_methods, reason = "a test makes no picture")]
fn exp(x: f64) -> f64 {
    x.exp()
}

/// The part of the light that an interface of two indices reflects straight back.
fn reflectance(a: f64, b: f64) -> f64 {
    ((a - b) / (a + b)) * ((a - b) / (a + b))
}

/// The part of the light that a slab between two interfaces transmits, after however many
/// reflections in it.
fn slab(r1: f64, r2: f64) -> f64 {
    (1.0 - r1) * (1.0 - r2) / (1.0 - r1 * r2)
}

/// Two units of water with an absorption of one half, over a ground that glows: e⁻¹. It was 1,
/// as a half-space had no inside for a ray that starts on it.
#[test]
fn water_absorbs_what_comes_through_it() {
    let pool = || vec![clear(below(0.0), 1.0, 0.5), glowing(below(-2.0))];
    assert!(is_close(straight_down(pool()), exp(-1.0)));
    // From the surface, where the eye is neither above nor below, and from within.
    let scene = scene(pool());
    assert!(is_close(
        radiance(&scene, Vec3::ZERO, Vec3::NEG_Y),
        exp(-1.0)
    ));
    assert!(is_close(
        radiance(&scene, Vec3::NEG_Y, Vec3::NEG_Y),
        exp(-0.5)
    ));
}

/// A ground that glows by the light of a lamp alone, which comes through the water, too: e⁻².
#[test]
fn water_absorbs_the_light_that_falls_on_its_ground() {
    let mut ground = glowing(below(-2.0));
    ground.material.material.phong = Phong {
        ambient: 0.0,
        diffuse: 1.0,
        specular: 0.0,
        ..ground.material.material.phong
    };
    let light = PointLight::new(5.0 * Vec3::Y, 1.0).expect("in range");
    let objects = vec![clear(below(0.0), 1.0, 0.5), ground];
    let scene = Scene::new(objects, vec![light], Vec3::ZERO).expect("distinct surfaces");
    let measured = radiance(&scene, 9.0 * Vec3::Y, Vec3::NEG_Y);
    assert!(is_close(measured, exp(-2.0)), "{measured}");
}

/// A shadow ray that starts on the water's surface and goes down has all its path in it, and one
/// that goes up none of it.
#[test]
fn a_shadow_ray_from_the_surface_of_water_passes_through_it_or_leaves_it() {
    let scene = scene(vec![clear(below(0.0), 1.0, 0.5)]);
    let ray = Ray {
        origin: Vec3::Y,
        direction: Vec3::NEG_Y,
    };
    let at = Interaction::new(&scene.objects, &ray, (0, 1.0));
    for (direction, exact) in [(Vec3::NEG_Y, exp(-1.0)), (Vec3::Y, 1.0)] {
        let ray = from_surface(&at, direction);
        let transmitted = shadow_transmittance(&scene, &ray, 2.0 * direction, 2.0);
        assert!(is_close(f64::from(transmitted.x), exact), "{transmitted}");
    }
}

/// Below water without a ground there is nothing but water: no light comes from there, unless it
/// absorbs none.
#[test]
fn endless_water_is_black_and_endless_clear_water_is_the_sky() {
    for (absorption, exact) in [(0.1, 0.0), (0.0, 1.0)] {
        let mut scene = scene(vec![clear(below(0.0), 1.0, absorption)]);
        scene.background = Vec3::ONE;
        let measured = radiance(&scene, Vec3::Y, Vec3::NEG_Y);
        assert!(is_close(measured, exact), "{measured}");
    }
}

/// A ball of radius 1 with an absorption of 1, and in it a bubble of radius ½: e⁻¹. It was e⁻²,
/// as nothing displaced anything. A third ball in the bubble absorbs again.
#[test]
fn a_bubble_in_tinted_glass_absorbs_nothing() {
    let wall = || glowing(below(-2.0));
    let glass = || clear(ball(0.0, 1.0), 1.0, 1.0);
    let bubble = || clear(ball(0.0, 0.5), 1.0, 0.0);
    let core = || clear(ball(0.0, 0.25), 1.0, 1.0);
    assert!(is_close(
        straight_down(vec![wall(), glass(), bubble()]),
        exp(-1.0)
    ));
    assert!(is_close(
        straight_down(vec![wall(), glass(), bubble(), core()]),
        exp(-1.5)
    ));
    // In the other order the glass displaces the bubble.
    assert!(is_close(
        straight_down(vec![wall(), bubble(), glass()]),
        exp(-2.0)
    ));
}

/// Two balls of one glass, one half in the other: (1 − R) / (1 + R), with R = 0.04, as for one
/// ball. It was 0.8571, as light was reflected at the border inside, where there is none.
#[test]
fn two_overlapping_lenses_of_one_glass_have_no_border_between_them() {
    let lens = |y| clear(ball(y, 1.0), 1.5, 0.0);
    let two = straight_down(vec![glowing(below(-3.0)), lens(-0.5), lens(0.5)]);
    assert!(is_close(two, 0.96 / 1.04), "{two}");
    let one = straight_down(vec![glowing(below(-3.0)), lens(0.0)]);
    assert!(is_close(two, one));
    let scene = scene(vec![glowing(below(-3.0)), lens(-0.5), lens(0.5)]);
    let origin = 9.0 * Vec3::Y;
    let ray = from_eye(&scene.objects, origin)(Ray {
        origin,
        direction: Vec3::NEG_Y,
    });
    let alone = trace(&scene, &ray, PathBudget::new(MAX_DEPTH), as_if_alone);
    assert!((f64::from(alone.x) - 0.8571).abs() < 1e-3, "{alone}");
}

/// Ice of radius ½, half out of its drink: air, ice, water. Only the borders of two media
/// reflect: the water's surface within the ice does not.
#[test]
fn ice_half_out_of_its_drink_displaces_the_water() {
    let objects = |absorption| {
        vec![
            glowing(below(-2.0)),
            clear(below(0.0), 1.33, absorption),
            clear(ball(0.0, 0.5), 1.31, 0.0),
        ]
    };
    let exact = slab(reflectance(1.0, 1.31), reflectance(1.31, 1.33));
    let measured = straight_down(objects(0.0));
    assert!(is_close(measured, exact), "{measured} {exact}");
    // 1.5 of the path is in the water.
    let absorbed = straight_down(objects(0.4));
    assert!(is_close(absorbed, exact * exp(-0.6)), "{absorbed}");
}

/// A ball on the ground of a pool: water, glass, water; and one that touches another.
#[test]
fn a_ball_in_water_reflects_by_the_index_of_water() {
    let objects = vec![
        glowing(below(-2.0)),
        clear(below(0.0), 1.33, 0.0),
        clear(ball(-1.0, 0.5), 1.5, 0.0),
    ];
    let r = reflectance(1.33, 1.5);
    let through = (1.0 - r) / (1.0 + r);
    let top = reflectance(1.0, 1.33);
    // The surface and the ball are two partial mirrors, one after the other.
    let back = 1.0 - through;
    let exact = (1.0 - top) * through / (1.0 - top * back);
    let measured = straight_down(objects);
    assert!(is_close(measured, exact), "{measured} {exact}");
}

/// Balls of one radius in a row, each touching the next: every one is met, and left again.
#[test]
fn balls_that_touch_are_passed_one_after_the_other() {
    let mut objects = vec![glowing(below(-9.0))];
    objects.extend((0..5).map(|i| clear(ball(2.0 * i as f32 - 4.0, 1.0), 1.0, 0.1)));
    let measured = straight_down(objects);
    assert!(is_close(measured, exp(-1.0)), "{measured}");
}

/// Returns up to four clear bodies that overlap, nest or touch as they like, and water.
fn bodies(
    places: &[(DVec3, f64, f32)],
    water: Option<f64>,
    absorption: f32,
) -> Vec<Object<Absorbing>> {
    let water = water.map(|y| clear(below(y as f32), 1.33, absorption));
    let balls = places.iter().map(|&(centre, radius, eta)| {
        clear(
            Shape::sphere(centre.as_vec3(), radius as f32),
            eta,
            absorption,
        )
    });
    water.into_iter().chain(balls).collect()
}

fn places() -> impl Strategy<Value = Vec<(DVec3, f64, f32)>> {
    let centre = (unit_vector(), 0.0..1.0_f64).prop_map(|(along, far)| far * along);
    let eta = prop_oneof![Just(1.0_f32), Just(1.33), Just(1.5), 1.0..2.4_f32];
    prop::collection::vec((centre, magnitude(-1.0..0.2), eta), 1..=4)
}

proptest! {
    #![proptest_config(cases(3_000))]

    /// In a sky without a feature whatever absorbs nothing is invisible, however it overlaps.
    /// Balls that overlap can keep a ray for a hundred total reflections; what is missing is the
    /// light of rays that are not traced.
    #[test]
    fn clear_bodies_are_invisible_in_a_sky_without_a_feature(
        places in places(), water in prop_oneof![Just(None), (-1.0..1.0_f64).prop_map(Some)],
        from in unit_vector(), aside in unit_vector(),
    ) {
        let mut scene = scene(bodies(&places, water, 0.0));
        scene.background = Vec3::ONE;
        let (origin, direction) = (4.0 * from, (0.8 * aside - 4.0 * from).normalize());
        let ray = Ray { origin: origin.as_vec3(), direction: direction.as_vec3() };
        let ray = from_eye(&scene.objects, ray.origin)(ray);
        let budget = PathBudget { depth: 1000, throughput: 1.0, min_throughput: 1e-5 };
        let radiance = trace(&scene, &ray, budget, between_media).x;
        prop_assert!((0.97..=1.0001).contains(&radiance), "{radiance}");
    }

    /// A body of the same medium inside another changes nothing.
    #[test]
    fn a_body_in_a_body_of_the_same_medium_is_not_there(
        centre in unit_vector(), far in 0.0..0.5_f64, radius in 0.01..0.49_f64,
        eta in 1.0..2.4_f32, absorption in 0.0..2.0_f32, is_first in any::<bool>(),
        from in unit_vector(), aside in unit_vector(),
    ) {
        let outer = clear(ball(0.0, 1.0), eta, absorption);
        let inner = (far * centre).as_vec3();
        let inner = clear(Shape::sphere(inner, radius as f32), eta, absorption);
        let both = if is_first { vec![inner, outer.clone()] } else { vec![outer.clone(), inner] };
        let [mut one, mut two] = [scene(vec![outer]), scene(both)];
        for scene in [&mut one, &mut two] {
            scene.background = vec3(1.0, 0.5, 0.25);
            scene.lights.push(PointLight::new(6.0 * Vec3::Y, 1.0).expect("in range"));
        }
        let (origin, direction) = (4.0 * from, (0.9 * aside - 4.0 * from).normalize());
        let [one, two] = [one, two].map(|scene| {
            radiance(&scene, origin.as_vec3(), direction.as_vec3())
        });
        prop_assert!((one - two).abs() <= 1e-4, "{one} {two}");
    }

    /// Disjoint bodies may stand in any order.
    #[test]
    fn the_order_of_disjoint_bodies_does_not_matter(
        radii in [0.1..0.9_f64, 0.1..0.9_f64, 0.1..0.9_f64], etas in [1.0..2.4_f32, 1.0..2.4_f32, 1.0..2.4_f32],
        from in unit_vector(), aside in unit_vector(), absorption in 0.0..2.0_f32,
    ) {
        let balls: Vec<Object<Absorbing>> = (0..3).map(|i| {
            clear(ball(2.0 * i as f32 - 2.0, radii[i] as f32), etas[i], absorption)
        }).collect();
        let (origin, direction) = (6.0 * from, (1.5 * aside - 6.0 * from).normalize());
        let seen = [[0, 1, 2], [2, 0, 1], [1, 2, 0], [2, 1, 0]].map(|order| {
            let mut scene = scene(order.map(|i: usize| balls[i].clone()).to_vec());
            scene.background = Vec3::ONE;
            radiance(&scene, origin.as_vec3(), direction.as_vec3()).to_bits()
        });
        prop_assert!(seen.iter().all(|&bits| bits == seen[0]));
    }
}

/// Bodies that touch, in every order of the list: at the point of contact rounding would let a
/// ray miss a surface, or cross it twice.
#[test]
fn bodies_that_touch_are_entered_and_left_once() {
    let water = |a| clear(below(0.0), 1.0, a);
    let small = |y, a| clear(ball(y, 0.5), 1.0, a);
    let large = |y, a| clear(ball(y, 1.0), 1.0, a);
    let orders: [(Vec<Object<Absorbing>>, f64); 12] = [
        (vec![water(0.5), small(-0.5, 0.0)], 0.5),
        (vec![small(-0.5, 0.0), water(0.5)], 1.0),
        (vec![water(0.0), small(-0.5, 1.0)], 1.0),
        (vec![small(0.5, 0.0), water(0.5)], 1.0),
        (vec![water(0.5), small(0.5, 0.0)], 1.0),
        (vec![large(0.0, 1.0), small(0.5, 0.0)], 1.0),
        (vec![large(0.0, 0.0), small(0.5, 1.0)], 1.0),
        (vec![small(0.5, 1.0), large(0.0, 0.0)], 0.0),
        (vec![large(1.0, 0.2), large(-1.0, 0.4)], 1.2),
        (vec![large(-1.0, 0.4), large(1.0, 0.2)], 1.2),
        (vec![large(4.0, 0.3), large(2.0, 0.1), large(0.0, 0.2)], 1.2),
        (vec![large(0.0, 0.2), large(2.0, 0.1), large(4.0, 0.3)], 1.2),
    ];
    for (i, (mut objects, absorbed)) in orders.into_iter().enumerate() {
        let clear = scene(objects.clone());
        objects.insert(0, glowing(below(-2.0)));
        let seen = straight_down(objects);
        assert!(is_close(seen, exp(-absorbed)), "{i}: {seen}");
        let ray = Ray {
            origin: 9.0 * Vec3::Y,
            direction: Vec3::NEG_Y,
        };
        let ray = from_eye(&clear.objects, ray.origin)(ray);
        let light = shadow_transmittance(&clear, &ray, -2.0 * Vec3::Y, 11.0);
        assert!(is_close(f64::from(light.x), exp(-absorbed)), "{i}: {light}");
    }
}

proptest! {
    #![proptest_config(cases(20_000))]

    /// Two balls that touch from outside, or of which one is in the other, in a room that glows:
    /// a ray aimed at the point of contact comes out, and has been absorbed nowhere.
    #[test]
    fn a_ray_through_a_point_of_contact_comes_out(
        out in unit_vector(), far in magnitude(-9.0..-1.0), aside in unit_vector(),
        from in unit_vector(), is_inside in any::<bool>(), is_first in any::<bool>(),
    ) {
        let centre = if is_inside { 0.5 } else { 1.5 } * out;
        let mut balls = vec![
            clear(ball(0.0, 1.0), 1.0, 0.0),
            clear(Shape::sphere(centre.as_vec3(), 0.5), 1.0, 0.0),
        ];
        if is_first {
            balls.reverse();
        }
        balls.push(glowing(ball(0.0, 8.0)));
        let towards = out + far * aside;
        let origin = (4.0 * from).as_vec3();
        let direction = (towards - 4.0 * from).normalize().as_vec3();
        prop_assert_eq!(radiance(&scene(balls), origin, direction), 1.0);
    }

    /// A ray that grazes a tinted ball, near to the origin of the world or far away, loses no more
    /// than a chord as long as rounding can make it.
    #[test]
    fn a_ray_that_grazes_a_tinted_ball_far_away_goes_on(
        centre in unit_vector(), away in magnitude(0.0..3.0), out in unit_vector(),
        height in -1e-6..1e-6_f64,
    ) {
        let centre = away * centre;
        let mut scene = scene(vec![clear(Shape::sphere(centre.as_vec3(), 1.0), 1.0, 0.5)]);
        scene.background = Vec3::ONE;
        let along = out.any_orthonormal_vector();
        let origin = centre + (1.0 + height) * out - 4.0 * along;
        let seen = radiance(&scene, origin.as_vec3(), along.as_vec3());
        prop_assert!(seen > exp(-0.5 * (0.02 * away.sqrt()).max(0.02)), "{seen}");
    }
}

/// A lamp in the plane of glossy water, however it is tilted: its highlights are all there, or
/// none is.
#[test]
fn a_lamp_in_the_plane_of_water_makes_no_speckles() {
    for i in 1..60 {
        let [x, y, z] = harness::evenly(i);
        let normal = (DVec3::Y + 0.2 * (DVec3::new(x, y, z) - 0.5)).normalize();
        let point = 0.7 * DVec3::Y;
        let along = DVec3::new(z - 0.5, 0.0, x - 0.5).cross(normal).normalize();
        let lamp = point + 9.0 * y * along;
        let water = clear(Shape::plane(point.as_vec3(), normal.as_vec3()), 1.33, 0.5);
        let light = PointLight::new(lamp.as_vec3(), 1.0).expect("in range");
        let scene =
            Scene::new(vec![water], vec![light], Vec3::ZERO).expect("one surface");
        let eye = vec3(0.0, 2.6, -5.0);
        let row: Vec<f32> = (0..4000)
            .map(|i| {
                let [u, v] = [i % 80, i / 80].map(|i| i as f32 / 100.0 - 0.4);
                radiance(&scene, eye, vec3(u, v - 0.4, 1.0).normalize()) as f32
            })
            .collect();
        let speckles = harness::speckles(&row);
        assert!(speckles <= 8, "{speckles} with {normal}");
    }
}
