//! What tests and studies measure by: the book's scenes and their pictures, exact ones, and
//! random numbers.

pub mod inputs;
pub mod pictures;
mod random;
pub mod random_scenes;
pub mod scenes;
pub mod subjects;
pub mod tree;
pub use random::Random;
