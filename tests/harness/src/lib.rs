//! Helpers for the tests of all chapters. The harness depends on no chapter but the canvas,
//! so that an error in a chapter stops no earlier one's tests.

pub mod agreement;
mod exercises;
mod inputs;
mod numbers;
mod pictures;
pub mod povray;
mod rounding;
mod snapshots;

pub use exercises::{assert_close, check_solution, judge};
pub use inputs::{cases, evenly, magnitude, special, special_vector, unit_vector};
pub use numbers::{
    Numbers, edge_of_shadow, percent, table, three_digits, triple, vector,
    with_separators,
};
pub use pictures::{
    HERO, SMALL, chapter, check_threads, largest_difference, ray_counts, render,
    render_at, speckles,
};
pub use rounding::{EPS, bits, ulp};
pub use snapshots::check_pictures;
