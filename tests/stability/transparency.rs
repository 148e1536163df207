//! Chapter 11: what coloured glass takes up, and what it lets through.

use crate::common::{EPS, cases, magnitude, unit};
use ::plane_hit::{Object, Pattern, Plane, Shape};
use ::ray_casting::Ray;
use ::reflection::Reach;
use ::refraction::{Body, Material};
use ::shading::Phong;
use ::shadow_acne::{Leaving, from_the_eye, from_the_surface};
use ::shadows::Scene;
use ::sphere_hit::Sphere;
use ::transparency::{STAGE, Tinted, light_through, trace, transmittance};
use canvas::{Canvas, View};
use glam::{DVec3, UVec2, Vec3, vec3};
use oracle::{Glass, Limit};
use proptest::prelude::*;

fn exactly(absorption: Vec3, distance: f64) -> DVec3 {
    (-absorption.as_dvec3() * distance).exp()
}

/// Relative, channel by channel.
fn differ(a: DVec3, b: DVec3) -> f64 {
    ((a - b) / b).abs().max_element()
}

proptest! {
    #![proptest_config(cases(50_000))]

    /// e^(−a d), to ε/2 of the exponent, which is rounded once, and the function's own ε.
    #[test]
    fn what_is_left_goes_down_exponentially(
        absorption in [0.0..4.0_f32, 0.0..4.0_f32, 0.0..4.0_f32], distance in 0.0..10.0_f32
    ) {
        let absorption = Vec3::from(absorption);
        let left = transmittance(absorption, distance).as_dvec3();
        let exact = exactly(absorption, f64::from(distance));
        prop_assert!(differ(left, exact) <= (20.0 + 1.0) * EPS, "{left} {exact}");
        prop_assert!(left.max_element() <= 1.0 && left.min_element() > 0.0);
    }

    /// Two ways one after the other take what one way as long as both takes.
    #[test]
    fn ways_multiply(
        absorption in [0.0..4.0_f32, 0.0..4.0_f32, 0.0..4.0_f32], ways in [0.0..5.0_f32, 0.0..5.0_f32]
    ) {
        let absorption = Vec3::from(absorption);
        let [first, second] = ways.map(|way| transmittance(absorption, way));
        let both = transmittance(absorption, ways[0] + ways[1]);
        // The exponent, up to 40, is rounded in the sum of the ways and in each product.
        prop_assert!(differ((first * second).as_dvec3(), both.as_dvec3()) <= (3.0 * 20.0 + 3.0) * EPS);
    }

    /// Clear glass takes nothing, and a way of no length takes nothing.
    #[test]
    fn nothing_is_taken_by_nothing(distance in magnitude(-30.0..18.0), absorption in magnitude(-3.0..3.0)) {
        prop_assert_eq!(transmittance(Vec3::ZERO, distance as f32), Vec3::ONE);
        prop_assert_eq!(transmittance(Vec3::splat(absorption as f32), 0.0), Vec3::ONE);
    }
}

const AMBER: Vec3 = Vec3::new(0.1, 0.7, 2.5);

fn object(shape: Shape, body: Body, absorption: Vec3) -> Object<Tinted> {
    let phong = Phong {
        colour: Pattern::Plain(Vec3::ONE),
        ambient: 0.0,
        diffuse: 0.0,
        specular: 0.0,
        shininess: 1,
    };
    let material = Material { phong, body };
    Object {
        name: "",
        shape,
        material: Tinted {
            material,
            absorption,
        },
    }
}

const CLEAR: Body = Body::Clear {
    inside: 1.5,
    outside: 1.0,
};

fn ball(centre: Vec3, radius: f32) -> Shape {
    Shape::Sphere(Sphere::new(centre, radius).expect("a sphere"))
}

/// All that is below a height.
fn below(height: f32) -> Shape {
    Shape::Plane(Plane::new(height * Vec3::Y, Vec3::Y).expect("a plane"))
}

fn scene(objects: Vec<Object<Tinted>>) -> Scene<Tinted> {
    Scene {
        objects,
        lights: vec![],
        background: Vec3::ZERO,
    }
}

/// What is left of light between two points, neither of them on a surface.
fn between(scene: &Scene<Tinted>, from: Vec3, to: Vec3) -> DVec3 {
    let ray = Ray {
        origin: from,
        direction: (to - from).normalize(),
    };
    light_through(scene, &from_the_eye(ray), (to - from).length()).as_dvec3()
}

/// A few roundings of t, and what the exponent makes of them.
fn is_left(left: DVec3, way: f64) -> bool {
    differ(left, exactly(AMBER, way)) <= 64.0 * EPS
}

/// Along a diameter 2 r; along a chord at a distance b from the centre 2 √(r² − b²); beside it nothing is
/// taken.
#[test]
fn a_ball_takes_light_along_its_chord() {
    let scene = scene(vec![object(ball(vec3(0.0, 1.0, 0.0), 0.5), CLEAR, AMBER)]);
    let across = |b: f32| between(&scene, vec3(b, 1.0, -4.0), vec3(b, 1.0, 5.0));
    assert!(is_left(across(0.0), 1.0));
    assert!(is_left(across(0.3), 0.8));
    assert_eq!(across(0.501), DVec3::ONE);
}

/// Straight down to 2 below the surface of amber, and at 60° twice as far; up from there it is the same.
#[test]
fn a_slab_takes_light_by_its_depth() {
    let scene = scene(vec![object(below(0.0), CLEAR, AMBER)]);
    let [above, deep] = [vec3(0.0, 3.0, 0.0), vec3(0.0, -2.0, 0.0)];
    assert!(is_left(between(&scene, above, deep), 2.0));
    assert!(is_left(between(&scene, deep, above), 2.0));
    let aside = vec3(5.0 * 3.0_f32.sqrt(), -2.0, 0.0);
    assert!(is_left(between(&scene, above, aside), 4.0));
}

/// A lamp in the middle of the ball shines through half of it, whichever side it is asked from; a point in
/// the glass gets light through what is left of the way; and both in it, through all of the way.
#[test]
fn a_lamp_inside_the_glass_shines_through_the_rest_of_it() {
    let scene = scene(vec![object(ball(Vec3::ZERO, 1.0), CLEAR, AMBER)]);
    let [far, centre] = [vec3(0.0, 0.0, -5.0), Vec3::ZERO];
    assert!(is_left(between(&scene, far, centre), 1.0));
    assert!(is_left(between(&scene, centre, far), 1.0));
    let [left, right] = [vec3(-0.5, 0.0, 0.0), vec3(0.25, 0.0, 0.0)];
    assert!(is_left(between(&scene, left, right), 0.75));
}

/// From a point of the glass itself: out of it nothing is in the way, and into it the chord is.
#[test]
fn light_leaves_the_glass_or_goes_through_it() {
    let scene = scene(vec![object(ball(Vec3::ZERO, 1.0), CLEAR, AMBER)]);
    let glass = &scene.objects[0];
    let from = |direction: Vec3| {
        let ray: Leaving<Tinted> = from_the_surface(glass, Vec3::X, Vec3::X, direction);
        light_through(&scene, &ray, 10.0).as_dvec3()
    };
    assert_eq!(from(Vec3::X), DVec3::ONE);
    assert!(is_left(from(Vec3::NEG_X), 2.0));
    assert!(is_left(from(vec3(-0.6, 0.8, 0.0)), 1.2));
}

/// An opaque ball that glows, inside one of glass: of its light e^(−a/2) gets to the surface, and 0.96 out
/// of it.
#[test]
fn what_is_inside_the_glass_is_seen_through_it() {
    let mut core = object(
        ball(Vec3::ZERO, 0.5),
        Body::Opaque { reflectivity: 0.0 },
        Vec3::ZERO,
    );
    core.material.material.phong.ambient = 1.0;
    let scene = scene(vec![object(ball(Vec3::ZERO, 1.0), CLEAR, AMBER), core]);
    let light = straight_on(&scene) / 0.96;
    assert!(is_left(light, 0.5), "{light}");
}

/// Straight through a ball into a white sky: T = 0.96 and R = 0.04 at either end, A = e^(−2 a) on the way
/// between. What comes through is T² A / (1 − R² A²), what comes back R + T² R A² / (1 − R² A²).
#[test]
fn a_tinted_ball_passes_on_and_mirrors_a_geometric_series() {
    let mut scene = scene(vec![object(ball(Vec3::ZERO, 1.0), CLEAR, AMBER)]);
    scene.background = Vec3::ONE;
    let left = exactly(AMBER, 2.0);
    let [r, t] = [0.04, 0.96];
    let through = t * t * left / (1.0 - r * r * left * left);
    let exact = through + r + r * left * through;
    let light = straight_on(&scene);
    assert!(differ(light, exact) <= 16.0 * EPS, "{light} {exact}");
}

/// What a ray sees that looks at the origin from 5 away, however often it is mirrored.
fn straight_on(scene: &Scene<Tinted>) -> DVec3 {
    let ray = Ray {
        origin: 5.0 * Vec3::Z,
        direction: Vec3::NEG_Z,
    };
    let reach = Reach {
        depth: 100,
        weight: 1.0,
        least_weight: 0.0,
    };
    trace(scene, from_the_eye(ray), reach).as_dvec3()
}

/// Anything opaque stops all light, before the glass or behind it; beyond the lamp it stops none, and nor
/// does glass there. Two balls take one after the other.
#[test]
fn opaque_things_stop_what_clear_ones_let_through() {
    let glass = object(ball(vec3(0.0, 0.0, 0.0), 1.0), CLEAR, AMBER);
    let second = object(ball(vec3(0.0, 0.0, 4.0), 0.5), CLEAR, AMBER);
    let wall = |z| {
        object(
            ball(vec3(0.0, 0.0, z), 0.5),
            Body::Opaque { reflectivity: 0.9 },
            AMBER,
        )
    };
    let left = |objects: &[&Object<Tinted>]| {
        let scene = scene(objects.iter().map(|&object| object.clone()).collect());
        between(&scene, vec3(0.0, 0.0, -9.0), vec3(0.0, 0.0, 9.0))
    };
    assert!(is_left(left(&[&glass]), 2.0));
    assert!(is_left(left(&[&glass, &second]), 3.0));
    assert!(is_left(left(&[&glass, &wall(10.0), &wall(-10.0)]), 2.0));
    for z in [-5.0, 6.0] {
        assert_eq!(left(&[&glass, &wall(z)]), DVec3::ZERO);
        assert_eq!(left(&[&wall(z), &glass, &second]), DVec3::ZERO);
    }
    assert_eq!(
        left(&[&object(ball(vec3(0.0, 0.0, 12.0), 1.0), CLEAR, AMBER)]),
        DVec3::ONE
    );
}

proptest! {
    #![proptest_config(cases(20_000))]

    /// Against the oracle, a ball between any two places, either of them inside it or not.
    #[test]
    fn light_through_a_ball_is_the_oracles(
        directions in [unit(), unit()], distances in [0.0..3.0_f64, 0.0..3.0_f64], radius in 0.2..2.0_f64,
    ) {
        let radius = radius as f32;
        let [from, to] = [0, 1].map(|i| (directions[i] * distances[i]).as_vec3());
        prop_assume!(from.distance(to) > 1e-3);
        let scene = scene(vec![object(ball(Vec3::ZERO, radius), CLEAR, Vec3::ONE)]);
        let left = between(&scene, from, to).x;
        // The part of the way that is inside, by its ends on the quadratic.
        let [o, d] = [from.as_dvec3(), (to - from).as_dvec3()];
        let [a, b, c] = [d.dot(d), d.dot(o), o.dot(o) - f64::from(radius) * f64::from(radius)];
        let root = (b * b - a * c).max(0.0).sqrt();
        let [enters, leaves] = [(-b - root) / a, (-b + root) / a].map(|t| t.clamp(0.0, 1.0));
        let exact = exactly(Vec3::X, (leaves - enters) * d.length()).x;
        // At a grazing chord the rounding of the closest approach counts by its root.
        prop_assert!((left - exact).abs() <= 2e-3, "{left} {exact}");
    }
}

proptest! {
    #![proptest_config(cases(20_000))]

    /// A ray that grazes a ball at 1 − δ radii from its centre has a chord of √(8 δ), give or take the
    /// rounding of δ, some ε for each of its four radii: no more than that is taken. Nearer than 2·10⁻⁶ to
    /// the edge, the sign of N·I does not tell entering from leaving, and one ray in a hundred loses as
    /// much as if it had been in the glass all the way: a ten-thousandth of a pixel.
    #[test]
    fn a_grazing_ray_is_hardly_dimmed(along in unit(), delta in magnitude(-5.5..-1.0)) {
        let scene = scene(vec![object(ball(Vec3::ZERO, 1.0), CLEAR, Vec3::ONE)]);
        let aside = (1.0 - delta) * along.any_orthonormal_vector();
        let left = between(&scene, (aside - 4.0 * along).as_vec3(), (aside + 90.0 * along).as_vec3()).x;
        let chord = (8.0 * (delta + 64.0 * EPS)).sqrt();
        prop_assert!(left >= exactly(Vec3::X, chord).x, "{left}");
    }
}

const SIZE: [u32; 2] = [400, 300];

fn paint(stage: &::canvas::Stage, setting: f32) -> Canvas {
    let view: &View = &stage.views[0];
    Canvas::paint(&(view.picture)(setting), UVec2::from_array(SIZE))
}

/// Without absorption chapter 11's picture is chapter 10's, bit for bit, but where a shadow of the glass
/// is seen, or seen mirrored or through the glass: there, and only there, the oracle's two pictures
/// differ, too. Measured: 5,286 of 120,000 pixels.
#[test]
fn glass_without_a_colour_differs_from_the_last_chapter_in_its_shadow_alone() {
    let [before, after] = [(&::shadow_acne::STAGE, 0.0), (&STAGE, 0.0)]
        .map(|(stage, setting)| paint(stage, setting).light);
    let scenes =
        [Glass::Mirrors, Glass::Tints(DVec3::ZERO)].map(oracle::still_life_with_glass);
    let camera = oracle::still_life_camera();
    let deep = Limit {
        bounces: 100,
        share: 1e-4,
    };
    let differ = |(at, before, after): (_, &Vec3, &Vec3)| {
        let ray = camera.ray(at, SIZE);
        let [opaque, clear] = scenes
            .each_ref()
            .map(|scene| oracle::trace(scene, &ray, deep));
        // The clear shadow is the brighter one.
        assert!((*after - *before).min_element() >= 0.0);
        assert_ne!(opaque, clear, "not in the shadow of the glass: {at}");
    };
    let centres = oracle::pixel_centres(SIZE);
    let pixels = centres.zip(before.iter().zip(&after));
    let pixels = pixels.map(|(at, (before, after))| (at, before, after));
    let brighter = pixels.filter(|(_, before, after)| before != after);
    let count = brighter.map(differ).count();
    assert!(count > 5_000, "{count}");
}
