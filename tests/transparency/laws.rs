//! How much light a medium absorbs, on every path through it.

use ::plane_hit::{Object, Shape, Texture};
use ::ray_casting::Ray;
use ::reflection::PathBudget;
use ::refraction::{Material, Optics};
use ::shading::Phong;
use ::shadow_acne::{from_surface, untracked};
use ::shadows::{Interaction, Scene};
use ::sphere_hit::face_forward;
use ::transparency::scene::AMBER;
use ::transparency::{
    Absorbing, STAGE, between_media, shadow_transmittance, trace, transmittance,
};
use canvas::rays_so_far;
use glam::{DVec3, UVec2, Vec3, vec3};
use harness::{EPS, cases, magnitude, render_at, unit_vector};
use oracle::{Glass, Limit};
use proptest::prelude::*;

/// Returns the exact transmittance.
fn exactly(absorption: Vec3, distance: f64) -> DVec3 {
    (-absorption.as_dvec3() * distance).exp()
}

/// Returns the greatest relative difference of any channel.
fn relative_error(a: DVec3, b: DVec3) -> f64 {
    ((a - b) / b).abs().max_element()
}

proptest! {
    #![proptest_config(cases(50_000))]

    /// e^(−a d), to ε/2 of the exponent, which is rounded once, and the function's own ε.
    #[test]
    fn transmittance_falls_exponentially(
        absorption in [0.0..4.0_f32, 0.0..4.0_f32, 0.0..4.0_f32], distance in 0.0..10.0_f32
    ) {
        let absorption = Vec3::from(absorption);
        let measured = transmittance(absorption, distance).as_dvec3();
        let exact = exactly(absorption, f64::from(distance));
        let error = relative_error(measured, exact);
        prop_assert!(error <= (20.0 + 1.0) * EPS, "{measured} {exact}");
        prop_assert!(measured.max_element() <= 1.0 && measured.min_element() > 0.0);
    }

    /// The transmittance of a path is the product of those of its parts. The exponent, up to 40,
    /// is rounded in the sum of the lengths and in each product.
    #[test]
    fn transmittances_multiply(
        absorption in [0.0..4.0_f32, 0.0..4.0_f32, 0.0..4.0_f32],
        lengths in [0.0..5.0_f32, 0.0..5.0_f32],
    ) {
        let absorption = Vec3::from(absorption);
        let [first, second] = lengths.map(|length| transmittance(absorption, length));
        let both = transmittance(absorption, lengths[0] + lengths[1]);
        let error = relative_error((first * second).as_dvec3(), both.as_dvec3());
        prop_assert!(error <= (3.0 * 20.0 + 3.0) * EPS);
    }

    #[test]
    fn clear_glass_and_a_path_of_no_length_absorb_nothing(
        distance in magnitude(-30.0..18.0), absorption in magnitude(-3.0..3.0)
    ) {
        prop_assert_eq!(transmittance(Vec3::ZERO, distance as f32), Vec3::ONE);
        prop_assert_eq!(transmittance(Vec3::splat(absorption as f32), 0.0), Vec3::ONE);
    }
}

fn object(shape: Shape, optics: Optics, absorption: Vec3) -> Object<Absorbing> {
    let phong = Phong {
        colour: Texture::Solid(Vec3::ONE),
        ambient: 0.0,
        diffuse: 0.0,
        specular: 0.0,
        shininess: 1,
    };
    let material = Material { phong, optics };
    Object {
        name: "",
        shape,
        material: Absorbing {
            material,
            absorption,
        },
    }
}

const CLEAR: Optics = Optics::Dielectric {
    eta_inside: 1.5,
    eta_outside: 1.0,
};

fn amber(shape: Shape) -> Object<Absorbing> {
    object(shape, CLEAR, AMBER)
}

fn ball(centre: Vec3, radius: f32) -> Shape {
    Shape::sphere(centre, radius)
}

/// Returns all that is below a height.
fn below(height: f32) -> Shape {
    Shape::plane(height * Vec3::Y, Vec3::Y)
}

fn scene(objects: Vec<Object<Absorbing>>) -> Scene<Absorbing> {
    Scene {
        objects,
        lights: vec![],
        background: Vec3::ZERO,
    }
}

/// Returns the transmittance between two points, neither of them on a surface.
fn between(scene: &Scene<Absorbing>, from: Vec3, to: Vec3) -> DVec3 {
    let (direction, distance) = (to - from).normalize_and_length();
    let ray = Ray {
        origin: from,
        direction,
    };
    shadow_transmittance(scene, &untracked(ray), to, distance).as_dvec3()
}

/// Returns whether this is the transmittance of amber of some thickness, up to what the exponent
/// makes of a few roundings of t.
fn is_amber(transmittance: DVec3, thickness: f64) -> bool {
    relative_error(transmittance, exactly(AMBER, thickness)) <= 64.0 * EPS
}

/// 2 r along a diameter, 2 √(r² − b²) along a chord at a distance b from the centre, and nothing
/// beside the ball.
#[test]
fn a_ball_absorbs_along_the_chord_of_a_ray() {
    let scene = scene(vec![amber(ball(vec3(0.0, 1.0, 0.0), 0.5))]);
    let across = |b: f32| between(&scene, vec3(b, 1.0, -4.0), vec3(b, 1.0, 5.0));
    assert!(is_amber(across(0.0), 1.0));
    assert!(is_amber(across(0.3), 0.8));
    assert_eq!(across(0.501), DVec3::ONE);
}

/// Straight down to 2 below the surface, at 60° twice as far, and the same upwards.
#[test]
fn a_half_space_absorbs_along_the_path_below_its_surface() {
    let scene = scene(vec![amber(below(0.0))]);
    let [above, deep] = [vec3(0.0, 3.0, 0.0), vec3(0.0, -2.0, 0.0)];
    assert!(is_amber(between(&scene, above, deep), 2.0));
    assert!(is_amber(between(&scene, deep, above), 2.0));
    let aside = vec3(5.0 * 3.0_f32.sqrt(), -2.0, 0.0);
    assert!(is_amber(between(&scene, above, aside), 4.0));
}

/// From the centre to the outside and back, half of the ball; between two points in the ball,
/// all of the path.
#[test]
fn a_light_inside_the_glass_shines_through_the_part_of_it_on_the_path() {
    let scene = scene(vec![amber(ball(Vec3::ZERO, 1.0))]);
    let [far, centre] = [vec3(0.0, 0.0, -5.0), Vec3::ZERO];
    assert!(is_amber(between(&scene, far, centre), 1.0));
    assert!(is_amber(between(&scene, centre, far), 1.0));
    let [left, right] = [vec3(-0.5, 0.0, 0.0), vec3(0.25, 0.0, 0.0)];
    assert!(is_amber(between(&scene, left, right), 0.75));
}

/// From a point of the surface: outwards nothing is on the path, and inwards the chord is.
#[test]
fn from_the_surface_light_leaves_the_glass_or_passes_through_it() {
    let scene = scene(vec![amber(ball(Vec3::ZERO, 1.0))]);
    let from = |direction: Vec3| {
        let at = Interaction {
            index: 0,
            shape: scene.objects[0].shape,
            t: 1.0,
            point: Vec3::X,
            incident: -direction,
            outward: Vec3::X,
            normal: face_forward(Vec3::X, -direction),
        };
        let ray = from_surface(&at, direction);
        let light = Vec3::X + 10.0 * direction;
        shadow_transmittance(&scene, &ray, light, 10.0).as_dvec3()
    };
    assert_eq!(from(Vec3::X), DVec3::ONE);
    assert!(is_amber(from(Vec3::NEG_X), 2.0));
    assert!(is_amber(from(vec3(-0.6, 0.8, 0.0)), 1.2));
}

/// However many objects there are, and whether or not one of them occludes the light.
#[test]
fn a_shadow_ray_is_counted_once() {
    let wall = object(
        ball(Vec3::ZERO, 1.0),
        Optics::Opaque { reflectivity: 0.0 },
        AMBER,
    );
    for objects in [vec![], vec![amber(ball(Vec3::ZERO, 1.0))], vec![wall; 2]] {
        let before = rays_so_far();
        let _ = between(&scene(objects), -3.0 * Vec3::Z, 3.0 * Vec3::Z);
        assert_eq!(rays_so_far() - before, 1);
    }
}

/// An opaque ball with ambient light, inside one of amber: of its light e^(−a/2) arrives at the
/// surface, and 0.96 of that is transmitted.
#[test]
fn what_is_inside_the_glass_is_seen_through_it() {
    let mut core = object(
        ball(Vec3::ZERO, 0.5),
        Optics::Opaque { reflectivity: 0.0 },
        Vec3::ZERO,
    );
    core.material.material.phong.ambient = 1.0;
    let scene = scene(vec![amber(ball(Vec3::ZERO, 1.0)), core]);
    let inside = straight_on(&scene) / 0.96;
    assert!(is_amber(inside, 0.5), "{inside}");
}

/// Straight through a ball into a white sky: T = 0.96 and R = 0.04 at either end, A = e^(−2 a)
/// between them. T² A / (1 − R² A²) is transmitted, and R + T² R A² / (1 − R² A²) reflected.
#[test]
fn an_absorbing_ball_transmits_and_reflects_a_geometric_series() {
    let mut scene = scene(vec![amber(ball(Vec3::ZERO, 1.0))]);
    scene.background = Vec3::ONE;
    let a = exactly(AMBER, 2.0);
    let [r, t] = [0.04, 0.96];
    let transmitted = t * t * a / (1.0 - r * r * a * a);
    let exact = transmitted + r + r * a * transmitted;
    let radiance = straight_on(&scene);
    let error = relative_error(radiance, exact);
    assert!(error <= 16.0 * EPS, "{radiance} {exact}");
}

/// Returns the radiance along a ray to the origin from 5 away, after up to 100 bounces.
fn straight_on(scene: &Scene<Absorbing>) -> DVec3 {
    let ray = Ray {
        origin: 5.0 * Vec3::Z,
        direction: Vec3::NEG_Z,
    };
    let budget = PathBudget {
        depth: 100,
        throughput: 1.0,
        min_throughput: 0.0,
    };
    trace(scene, &untracked(ray), budget, between_media).as_dvec3()
}

/// An opaque object before the glass or behind it occludes the light; beyond the light it does
/// not, nor is anything absorbed there. Two balls absorb one after the other.
#[test]
fn opaque_objects_occlude_what_clear_ones_transmit() {
    let glass = amber(ball(vec3(0.0, 0.0, 0.0), 1.0));
    let second = amber(ball(vec3(0.0, 0.0, 4.0), 0.5));
    let wall = |z| {
        object(
            ball(vec3(0.0, 0.0, z), 0.5),
            Optics::Opaque { reflectivity: 0.9 },
            AMBER,
        )
    };
    let transmittance = |objects: &[&Object<Absorbing>]| {
        let scene = scene(objects.iter().map(|&object| object.clone()).collect());
        between(&scene, vec3(0.0, 0.0, -9.0), vec3(0.0, 0.0, 9.0))
    };
    assert!(is_amber(transmittance(&[&glass]), 2.0));
    assert!(is_amber(transmittance(&[&glass, &second]), 3.0));
    assert!(is_amber(
        transmittance(&[&glass, &wall(10.0), &wall(-10.0)]),
        2.0
    ));
    for z in [-5.0, 6.0] {
        assert_eq!(transmittance(&[&glass, &wall(z)]), DVec3::ZERO);
        assert_eq!(transmittance(&[&wall(z), &glass, &second]), DVec3::ZERO);
    }
    assert_eq!(
        transmittance(&[&amber(ball(vec3(0.0, 0.0, 12.0), 1.0))]),
        DVec3::ONE
    );
}

proptest! {
    #![proptest_config(cases(20_000))]

    /// A ball between any two points, either of them inside it or not; the exact path is between
    /// the roots of the quadratic in f64.
    #[test]
    fn the_path_inside_a_ball_is_between_the_ends_of_its_chord(
        directions in [unit_vector(), unit_vector()],
        distances in [0.0..3.0_f64, 0.0..3.0_f64], radius in 0.2..2.0_f64,
    ) {
        let radius = radius as f32;
        let [from, to] = [0, 1].map(|i| (directions[i] * distances[i]).as_vec3());
        prop_assume!(from.distance(to) > 1e-3);
        let scene = scene(vec![object(ball(Vec3::ZERO, radius), CLEAR, Vec3::ONE)]);
        let [o, d] = [from.as_dvec3(), (to - from).as_dvec3()];
        let [a, b, c] = [d.dot(d), d.dot(o), o.dot(o) - f64::from(radius) * f64::from(radius)];
        let root = (b * b - a * c).max(0.0).sqrt();
        let [enters, leaves] = [(-b - root) / a, (-b + root) / a].map(|t| t.clamp(0.0, 1.0));
        let exact = (leaves - enters) * d.length();
        // At a grazing chord the rounding of the closest approach counts by its root.
        let absorbed = between(&scene, from, to).x;
        prop_assert!((absorbed - exactly(Vec3::X, exact).x).abs() <= 2e-3, "{absorbed}");
    }
}

proptest! {
    #![proptest_config(cases(20_000))]

    /// At 1 − δ radii from the centre a ray has a chord of √(8 δ), give or take the rounding of δ,
    /// some ε for each of its four radii: no more than that is absorbed.
    #[test]
    fn little_is_absorbed_along_a_grazing_ray(
        along in unit_vector(), delta in magnitude(-9.0..-1.0)
    ) {
        let scene = scene(vec![object(ball(Vec3::ZERO, 1.0), CLEAR, Vec3::ONE)]);
        let aside = (1.0 - delta) * along.any_orthonormal_vector();
        let [from, to] = [-4.0, 90.0].map(|t| (aside + t * along).as_vec3());
        let transmittance = between(&scene, from, to).x;
        let chord = (8.0 * (delta + 64.0 * EPS)).sqrt();
        prop_assert!(transmittance >= exactly(Vec3::X, chord).x, "{transmittance}");
    }
}

/// Without absorption the picture is the last chapter's, bit for bit, but where a shadow of the
/// glass is seen, or seen in the mirror or through the glass: there, and only there, the
/// oracle's two pictures differ, too. Measured: 5,286 of 120,000 pixels.
#[test]
fn colourless_glass_differs_from_the_last_chapter_in_its_shadow_alone() {
    let size = UVec2::new(400, 300);
    let [before, after] = [&::shadow_acne::STAGE, &STAGE]
        .map(|stage| render_at(stage, stage.hero, 0.0, size).radiance);
    let scenes =
        [Glass::Reflects, Glass::Absorbs(DVec3::ZERO)].map(oracle::still_life_with_glass);
    let camera = oracle::still_life_camera();
    let deep = Limit {
        bounces: 100,
        min_throughput: 1e-5,
    };
    let centres = oracle::pixel_centres(size.to_array());
    let mut count = 0;
    for (centre, (before, after)) in centres.zip(before.iter().zip(&after)) {
        if before == after {
            continue;
        }
        count += 1;
        let ray = camera.ray(centre, size.to_array());
        let [opaque, clear] = scenes
            .each_ref()
            .map(|scene| oracle::trace(scene, &ray, deep));
        // The clear shadow is the brighter one.
        assert!((*after - *before).min_element() >= 0.0);
        assert_ne!(opaque, clear, "not in the shadow of the glass: {centre}");
    }
    assert!(count > 5_000, "{count}");
}
