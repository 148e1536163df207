//! Inputs and references for tests and studies: the book's scenes and their pictures, exact
//! ones, and random numbers.

pub mod bvh;
pub mod inputs;
pub mod pictures;
mod random;
pub mod random_scenes;
pub mod scenes;
pub mod subjects;
pub use random::Random;

/// Returns the middle one of an odd number of values.
///
/// # Panics
/// If there are none.
#[must_use]
pub fn median(mut values: Vec<f64>) -> f64 {
    values.sort_by(f64::total_cmp);
    values[values.len() / 2]
}
