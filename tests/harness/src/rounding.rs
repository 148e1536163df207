//! Units of rounding error.

use glam::Vec3;

/// The ε of f32, 2⁻²³, as f64: the spacing of the f32 numbers from 1 to 2.
pub const EPS: f64 = f32::EPSILON as f64;

/// Returns the unit in the last place of an f32 of the size of `x`.
#[must_use]
pub fn ulp(x: f64) -> f64 {
    let x = (x as f32).abs();
    f64::from(x.next_up()) - f64::from(x)
}

/// Returns the bits of a vector: those of equal vectors can differ, for 0 and −0, and those
/// of NaN can be compared.
#[must_use]
pub fn bits(v: &Vec3) -> [u32; 3] {
    v.to_array().map(f32::to_bits)
}
