//! Phong's three terms.

use ::plane_hit::{Plane, Shape, Texture};
use ::shading::{Phong, phong, powi, shade};
use ::shadows::{Interaction, PointLight};
use glam::{Vec3, vec3};
use harness::{EPS, cases, special, special_vector, unit_vector};
use proptest::prelude::*;

const WHITE: Phong = Phong {
    colour: Texture::Solid(Vec3::ONE),
    ambient: 0.1,
    diffuse: 0.8,
    specular: 0.5,
    shininess: 10,
};

/// Returns a surface that has a highlight and nothing else.
fn highlight(shininess: u32) -> Phong {
    Phong {
        ambient: 0.0,
        diffuse: 0.0,
        specular: 1.0,
        shininess,
        ..WHITE
    }
}

/// Returns the hit of a ray along `incident` on a surface with this `normal`.
fn at(point: Vec3, normal: Vec3, incident: Vec3) -> Interaction {
    let plane = Plane {
        point,
        normal,
        axes: [normal.any_orthogonal_vector(); 2],
    };
    Interaction {
        index: 0,
        shape: Shape::Plane(plane),
        t: 1.0,
        point,
        incident,
        outward: normal,
        normal,
    }
}

/// Returns the hit at the origin of a floor that is seen from straight above.
fn from_above() -> Interaction {
    at(Vec3::ZERO, Vec3::Y, Vec3::NEG_Y)
}

fn light(position: Vec3) -> PointLight {
    PointLight {
        position,
        intensity: 1.0,
    }
}

/// Returns the highlight of a light straight above the surface, where R is straight above,
/// too, by the cosine R·V.
fn highlight_at(r_dot_v: f32, shininess: u32) -> f32 {
    let to_eye = vec3((1.0 - r_dot_v * r_dot_v).sqrt(), r_dot_v, 0.0);
    let at = at(Vec3::ZERO, Vec3::Y, -to_eye);
    phong(&highlight(shininess), Vec3::ONE, &at, Vec3::Y).x
}

/// 0.9¹⁰ = 0.3486784401, each of the ten factors rounded; nothing for a negative R·V,
/// although its tenth power is positive; and 0.5²⁰⁰ = 6·10⁻⁶¹ is 0 in f32.
#[test]
fn a_highlight_is_a_power_of_a_positive_cosine() {
    let error = f64::from(highlight_at(0.9, 10)) - 0.348_678_440_1;
    assert!(error.abs() <= 10.0 * EPS * 0.35);
    assert_eq!(highlight_at(-0.9, 10), 0.0);
    assert!(powi(-0.9_f32, 10) > 0.3);
    assert_eq!(highlight_at(0.5, 200), 0.0);
    assert_eq!(highlight_at(1.0, 200), 1.0);
}

/// Returns the radiance of a white surface at the origin, seen from straight above, in
/// these lights, all of them visible.
fn shaded_by(lights: &[PointLight]) -> Vec3 {
    shade(&WHITE, &from_above(), lights, |_, _, _| Vec3::ONE)
}

/// A light at the point itself, below the surface or in its plane. Below it, R = (0, 1, 0) = V
/// makes no highlight.
#[test]
fn a_light_at_the_point_or_behind_the_surface_gives_nothing() {
    let ambient = Vec3::splat(0.1);
    for position in [Vec3::ZERO, Vec3::NEG_Y, Vec3::X, vec3(1.0, -1e-3, 0.0)] {
        assert_eq!(shaded_by(&[light(position)]), ambient);
    }
}

/// 0.1 + 0.8 + 0.5 straight above, and from 60° 0.1 + 0.8/2 + 0.5 · 0.5¹⁰.
#[test]
fn ambient_diffuse_and_specular_add_up() {
    let above = shaded_by(&[light(Vec3::Y)]).as_dvec3();
    assert!((above.x - 1.4).abs() <= 4.0 * EPS && above.x == above.y);
    let aslant = shaded_by(&[light(vec3(3.0_f32.sqrt(), 1.0, 0.0))]).as_dvec3();
    let exact = 0.1 + 0.4 + 0.5 / 1024.0;
    assert!((aslant.x - exact).abs() <= 4.0 * EPS);
}

/// Of lights above, below and at the surface `visibility` is called for the first alone, with
/// the direction to it and its distance; a light that is not visible gives nothing.
#[test]
fn visibility_is_called_for_lights_in_front_alone() {
    let lights = [4.0, -1.0, 0.0].map(|y| light(y * Vec3::Y));
    let mut calls = vec![];
    let radiance = shade(
        &WHITE,
        &from_above(),
        &lights,
        |light, direction, distance| {
            calls.push((*light, direction, distance));
            Vec3::ZERO
        },
    );
    assert_eq!(radiance, Vec3::splat(0.1));
    assert_eq!(calls, [(lights[0], Vec3::Y, 4.0)]);
}

/// A surface without a diffuse part, whose highlight is on the other side: R·V is negative.
#[test]
fn visibility_is_not_called_where_nothing_would_be_reflected() {
    let lights = [light(vec3(1.0, 1e-3, 0.0))];
    let at = at(Vec3::ZERO, Vec3::Y, vec3(-0.6, -0.8, 0.0));
    let radiance = shade(&highlight(10), &at, &lights, |_, _, _| unreachable!());
    assert_eq!(radiance, Vec3::ZERO);
}

/// 0.1 + 1.3 · (1, ½, ¼), to a rounding of each term and of the sum.
#[test]
fn light_through_a_coloured_glass_is_coloured() {
    let visible = vec3(1.0, 0.5, 0.25);
    let radiance = shade(&WHITE, &from_above(), &[light(Vec3::Y)], |_, _, _| visible);
    let exact = 0.1 + 1.3 * visible.as_dvec3();
    assert!(radiance.as_dvec3().distance(exact) <= 4.0 * EPS);
}

proptest! {
    #![proptest_config(cases(100_000))]

    /// A power of n takes no more roundings than n − 1 multiplications would: its relative error
    /// is at most n ε/2, and among the subnormal numbers one of their steps for each squaring.
    #[test]
    #[expect(clippy::disallowed_methods, reason = "f64's power is the reference")]
    fn a_power_is_as_exact_as_its_multiplications(
        base in 0.0..1.001_f32, exponent in 0..1000_u32
    ) {
        let exact = f64::from(base).powi(exponent as i32);
        let error = (f64::from(powi(base, exponent)) - exact).abs();
        let bound = f64::from(exponent) * EPS / 2.0 * exact * (1.0 + 1e-3) + 1e-40;
        prop_assert!(error <= bound);
    }

    /// From every side of the surface. Rounding makes R·V up to 1 + 4 ε, and a power of that
    /// would have no bound.
    #[test]
    fn reflected_light_is_positive_for_a_light_in_front_and_never_more_than_all(
        incident in unit_vector(), normal in unit_vector(), to_light in unit_vector(),
        shininess in prop_oneof![1..300_u32, any::<u32>()],
    ) {
        let [incident, normal, to_light] = [incident, normal, to_light].map(|v| v.as_vec3());
        let surface = Phong { shininess, ..WHITE };
        let at = at(Vec3::ZERO, normal, incident);
        let reflected = phong(&surface, Vec3::ONE, &at, to_light);
        prop_assert!(reflected.min_element() > 0.0 || normal.dot(to_light) <= 0.0);
        // k_d + kₛ at most, each rounded.
        prop_assert!(reflected.max_element() <= WHITE.diffuse + WHITE.specular);
        // Straight from above, R·V is 1, up to rounding.
        let at = Interaction { incident: -to_light, normal: to_light, ..at };
        let straight = phong(&highlight(shininess), Vec3::ONE, &at, to_light);
        prop_assert!(straight.max_element() <= 1.0);
    }

    /// Two lights give the sum of what each gives, to the rounding of sums that are below 4.
    #[test]
    fn lights_add_up(
        positions in [unit_vector(), unit_vector()], intensities in [0.0..1.0_f32, 0.0..1.0_f32],
        incident in unit_vector(), normal in unit_vector(),
    ) {
        let [a, b] = [0, 1].map(|i| PointLight {
            position: 5.0 * positions[i].as_vec3(),
            intensity: intensities[i],
        });
        let at = at(Vec3::ZERO, normal.as_vec3(), incident.as_vec3());
        let shaded = |lights: &[PointLight]| shade(&WHITE, &at, lights, |_, _, _| Vec3::ONE);
        let separately = shaded(&[a]) + shaded(&[b]) - shaded(&[]);
        let difference = shaded(&[a, b]).as_dvec3().distance(separately.as_dvec3());
        prop_assert!(difference <= 8.0 * EPS, "{difference:e}");
    }

    /// The point and the lights may be at zero, at infinity, or not a number, as long as the
    /// directions are unit vectors, and the surface and the intensities are finite and their
    /// products too.
    #[test]
    fn radiance_is_finite_wherever_the_point_and_the_lights_are(
        incident in unit_vector(), normal in unit_vector(), point in special_vector(),
        positions in [special_vector(), special_vector()],
        colour in prop_oneof![Just(0.0_f32), Just(1e-45), Just(1.0), Just(1e19)],
        intensity in prop_oneof![Just(0.0_f32), Just(1e-45), Just(1.0), Just(1e18)],
        coefficients in [0.0..1.0_f32, 0.0..1.0_f32, 0.0..1.0_f32],
        checkered in any::<bool>(), shininess in prop_oneof![Just(1_u32), 1..1000_u32],
    ) {
        let colour = Vec3::splat(colour);
        let [ambient, diffuse, specular] = coefficients;
        let colour = if checkered {
            Texture::Checker(colour, Vec3::ZERO)
        } else {
            Texture::Solid(colour)
        };
        let surface = Phong { colour, ambient, diffuse, specular, shininess };
        let lights = positions.map(|position| PointLight { position, intensity });
        let at = at(point, normal.as_vec3(), incident.as_vec3());
        let radiance = shade(&surface, &at, &lights, |_, _, _| Vec3::ONE);
        prop_assert!(radiance.is_finite(), "{radiance}");
    }

    /// Zero, subnormal, huge, infinite and NaN in every argument.
    #[test]
    fn where_the_normal_is_nan_there_is_ambient_light_alone(
        incident in special_vector(), normal in special_vector(), point in special_vector(),
        position in special_vector(), intensity in special(), shininess in any::<u32>(),
    ) {
        let lights = [PointLight { position, intensity }];
        let surface = Phong { shininess, ..WHITE };
        let at = at(point, normal, incident);
        let radiance = shade(&surface, &at, &lights, |_, _, _| Vec3::ONE);
        if normal.is_nan() {
            prop_assert_eq!(radiance, Vec3::splat(0.1));
        }
    }
}

/// For the largest shininess of the still life, 200, the error is at most 200 ε/2, which is
/// 0.003 of a linear level of 1/255. Measured: 3.3·10⁻⁶.
#[test]
#[expect(clippy::disallowed_methods, reason = "f64's power is the reference")]
fn a_highlight_is_within_a_hundredth_of_a_level() {
    let errors = (0..=100_000).map(|i| {
        let base = i as f32 / 100_000.0;
        (f64::from(powi(base, 200)) - f64::from(base).powi(200)).abs()
    });
    assert!(errors.fold(0.0, f64::max) <= 200.0 * EPS / 2.0);
}
