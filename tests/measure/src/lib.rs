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
