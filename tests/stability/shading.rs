//! Chapter 5: Phong's three terms.

use crate::common::{EPS, cases, special, special_vector, unit};
use ::plane_hit::Pattern;
use ::shading::{Phong, lit, power, shade};
use ::shadows::PointLight;
use glam::Vec3;
use proptest::prelude::*;

const WHITE: Phong = Phong {
    colour: Pattern::Plain(Vec3::ONE),
    ambient: 0.1,
    diffuse: 0.8,
    specular: 0.5,
    shininess: 10,
};

/// A surface that has a highlight and nothing else.
fn highlight(shininess: u32) -> Phong {
    Phong {
        ambient: 0.0,
        diffuse: 0.0,
        specular: 1.0,
        shininess,
        ..WHITE
    }
}

/// The highlight where the light stands upright above the surface, and R with it: R·V is as given.
fn highlight_at(r_dot_v: f32, shininess: u32) -> f32 {
    let towards_eye = Vec3::new((1.0 - r_dot_v * r_dot_v).sqrt(), r_dot_v, 0.0);
    let surface = highlight(shininess);
    lit(&surface, Vec3::ONE, -towards_eye, Vec3::Y, Vec3::Y).x
}

/// D38: 0.9¹⁰ = 0.3486784401, each of the ten factors rounded; nothing for a negative R·V, although its
/// tenth power is positive; and 0.5²⁰⁰ = 6·10⁻⁶¹ is 0 in f32.
#[test]
fn a_highlight_is_a_power_of_a_positive_cosine() {
    assert!(
        (f64::from(highlight_at(0.9, 10)) - 0.348_678_440_1).abs() <= 10.0 * EPS * 0.35
    );
    assert_eq!(highlight_at(-0.9, 10), 0.0);
    assert!(power(-0.9, 10) > 0.3);
    assert_eq!(highlight_at(0.5, 200), 0.0);
    assert_eq!(highlight_at(1.0, 200), 1.0);
}

/// The light of one lamp at `position`, of what is at the origin and looked at from straight above.
fn shaded_by(position: Vec3) -> Vec3 {
    let lamp = PointLight {
        position,
        intensity: 1.0,
    };
    shade(&WHITE, Vec3::NEG_Y, Vec3::ZERO, Vec3::Y, &[lamp], |_| true)
}

/// D37: a lamp at the very point, and a lamp below the surface: the ambient light is left. A mirror
/// direction that meets the eye does not help: below, R = (0, 1, 0) = V.
#[test]
fn a_lamp_at_the_point_or_behind_it_gives_nothing() {
    let ambient = Vec3::splat(0.1);
    for position in [Vec3::ZERO, Vec3::NEG_Y, Vec3::X, Vec3::new(1.0, -1e-3, 0.0)] {
        assert_eq!(shaded_by(position), ambient);
    }
    assert_eq!(
        lit(&WHITE, Vec3::ONE, Vec3::NEG_Y, Vec3::Y, Vec3::NEG_Y),
        Vec3::ZERO
    );
}

/// 0.1 + 0.8 + 0.5, straight above; and from 60° 0.1 + 0.8/2 + 0.5 · 0.5¹⁰.
#[test]
fn ambient_diffuse_and_specular_add_up() {
    let above = shaded_by(Vec3::Y).as_dvec3();
    assert!((above.x - 1.4).abs() <= 4.0 * EPS && above.x == above.y);
    let aslant = shaded_by(Vec3::new(3.0_f32.sqrt(), 1.0, 0.0)).as_dvec3();
    let exact = 0.1 + 0.4 + 0.5 / 1024.0;
    assert!((aslant.x - exact).abs() <= 4.0 * EPS);
}

/// A lamp that does not reach gives nothing, and one behind the surface is not asked about.
#[test]
fn only_lamps_in_front_are_asked_whether_they_reach() {
    let lamp = |y| PointLight {
        position: Vec3::new(0.0, y, 0.0),
        intensity: 1.0,
    };
    let asked = std::cell::Cell::new(0);
    let reaches = |_: &PointLight| {
        asked.set(asked.get() + 1);
        false
    };
    let lamps = [lamp(1.0), lamp(-1.0), lamp(0.0)];
    let light = shade(&WHITE, Vec3::NEG_Y, Vec3::ZERO, Vec3::Y, &lamps, reaches);
    assert_eq!((light, asked.get()), (Vec3::splat(0.1), 1));
}

proptest! {
    #![proptest_config(cases(100_000))]

    /// A power of n takes no more roundings than n − 1 multiplications would: its relative error is at
    /// most n ε/2, and down among the subnormals one of their steps for each squaring.
    #[test]
    #[expect(clippy::disallowed_methods, reason = "f64's power is what it is measured against")]
    fn a_power_is_as_exact_as_its_multiplications(base in 0.0..1.001_f32, exponent in 0..1000_u32) {
        let exact = f64::from(base).powi(exponent as i32);
        let error = (f64::from(power(base, exponent)) - exact).abs();
        let bound = f64::from(exponent) * EPS / 2.0 * exact * (1.0 + 1e-3) + 1e-40;
        prop_assert!(error <= bound);
    }

    /// Nothing for a lamp behind the surface, however the eye looks at it; never less than nothing.
    #[test]
    fn light_is_never_negative(
        incident in unit(), normal in unit(), to_light in unit(), shininess in 1..300_u32
    ) {
        let [incident, normal, to_light] = [incident, normal, to_light].map(|v| v.as_vec3());
        let surface = Phong { shininess, ..WHITE };
        let light = lit(&surface, Vec3::ONE, incident, normal, to_light);
        if normal.dot(to_light) > 0.0 {
            prop_assert!(light.min_element() > 0.0);
        } else {
            prop_assert_eq!(light, Vec3::ZERO);
        }
        // k_d + kₛ at most; R·V may be 1 + 4 ε, and its power 1 + 4 n ε.
        prop_assert!(f64::from(light.max_element()) <= 1.3 + 4.0 * 300.0 * EPS);
    }

    /// Finite light wherever the point and the lamps are, at zero, at infinity or nowhere, as long as
    /// the directions are unit vectors, and the surface and the lamps' intensities are finite and
    /// their products too.
    #[test]
    fn nothing_makes_light_infinite(
        incident in unit(), normal in unit(), point in special_vector(),
        positions in [special_vector(), special_vector()],
        colour in prop_oneof![Just(0.0_f32), Just(1e-45), Just(1.0), Just(1e19)],
        intensity in prop_oneof![Just(0.0_f32), Just(1e-45), Just(1.0), Just(1e18)],
        coefficients in [0.0..1.0_f32, 0.0..1.0_f32, 0.0..1.0_f32],
        checkered in any::<bool>(), shininess in prop_oneof![Just(1_u32), 1..1000_u32],
    ) {
        let colour = Vec3::splat(colour);
        let [ambient, diffuse, specular] = coefficients;
        let pattern = if checkered { Pattern::Checker(colour, Vec3::ZERO) } else { Pattern::Plain(colour) };
        let surface = Phong { colour: pattern, ambient, diffuse, specular, shininess };
        let lamps = positions.map(|position| PointLight { position, intensity });
        let light = shade(&surface, incident.as_vec3(), point, normal.as_vec3(), &lamps, |_| true);
        prop_assert!(light.is_finite(), "{light}");
    }

    /// Zero, subnormal, huge, infinite and NaN in every argument: an answer, and ambient light where
    /// the normal is none.
    #[test]
    fn nothing_makes_shading_panic(
        incident in special_vector(), normal in special_vector(), point in special_vector(),
        position in special_vector(), intensity in special(), shininess in any::<u32>(),
    ) {
        let lamps = [PointLight { position, intensity }];
        let surface = Phong { shininess, ..WHITE };
        let light = shade(&surface, incident, point, normal, &lamps, |_| true);
        if normal.is_nan() {
            prop_assert_eq!(light, Vec3::splat(0.1));
        }
    }
}

/// The largest shininess of the still life, 200: an error of 200 ε/2 at most, which is 0.003 of a linear
/// level of 1/255. Measured: 3.3·10⁻⁶.
#[test]
#[expect(
    clippy::disallowed_methods,
    reason = "f64's power is what it is measured against"
)]
fn a_highlight_is_within_a_hundredth_of_a_level() {
    let worst = (0..=100_000).map(|i| {
        let base = i as f32 / 100_000.0;
        (f64::from(power(base, 200)) - f64::from(base).powi(200)).abs()
    });
    let worst = worst.fold(0.0, f64::max);
    assert!(worst <= 200.0 * EPS / 2.0);
}
