//! Inputs for the property tests, and their number.

use glam::{DVec3, Vec3};
use proptest::prelude::*;
use proptest::test_runner::RngSeed;
use std::ops::Range;

/// Returns the configuration of a property test: this number of cases, the same on every
/// run, and no file written when one fails.
#[must_use]
pub fn cases(cases: u32) -> ProptestConfig {
    ProptestConfig {
        cases,
        // As many as a narrow condition rejects.
        max_global_rejects: 100 * cases,
        failure_persistence: None,
        rng_seed: RngSeed::Fixed(1968),
        ..ProptestConfig::default()
    }
}

/// Returns numbers that a formula may not expect (zero, subnormal, huge, infinite, NaN) and
/// as many ordinary ones from −2 to 2.
pub fn special() -> impl Strategy<Value = f32> {
    const SPECIAL: [f32; 14] = [
        0.0,
        -0.0,
        1e-45,
        -1e-45,
        1e-38,
        1e-20,
        1.0,
        1e19,
        -1e19,
        3e38,
        -3e38,
        f32::INFINITY,
        f32::NEG_INFINITY,
        f32::NAN,
    ];
    prop_oneof![prop::sample::select(&SPECIAL[..]), -2.0_f32..2.0]
}

/// Returns vectors of [`special`] numbers.
pub fn special_vector() -> impl Strategy<Value = Vec3> {
    [special(), special(), special()].prop_map(Vec3::from)
}

/// Returns unit vectors in all directions.
pub fn unit_vector() -> impl Strategy<Value = DVec3> {
    // A square, wrapped around each half of the sphere.
    let square = (-1.0..1.0_f64, -1.0..1.0_f64, any::<bool>());
    square.prop_map(|(u, v, front)| {
        let z = (1.0 - u * u - v * v) / 2.0;
        DVec3::new(u, v, if front { z } else { -z }).normalize()
    })
}

/// Returns numbers of all orders of magnitude: powers of 10 with an exponent in this range.
#[expect(
    clippy::disallowed_methods,
    reason = "the last bit of an input does not matter"
)]
pub fn magnitude(exponents: Range<f64>) -> impl Strategy<Value = f64> + Clone {
    exponents.prop_map(|exponent| 10.0_f64.powf(exponent))
}

/// Returns the i-th point of a sequence that fills the unit cube evenly.
///
/// Source: Martin Roberts, "The Unreasonable Effectiveness of Quasirandom Sequences" (2018).
#[must_use]
pub fn evenly(i: usize) -> [f64; 3] {
    const STEPS: [f64; 3] = [
        0.819_172_513_396_164,
        0.671_043_606_703_789,
        0.549_700_477_901_97,
    ];
    STEPS.map(|step| (0.5 + step * i as f64).fract())
}
