// ANCHOR: head
//! An adaptive renderer, which decides how far rays are followed, and how many a pixel
//! takes.

mod plan;
mod sample;
pub mod study;
mod trace;
pub use plan::{DEFAULT_TOLERANCE, Plan};
pub use trace::Sample;
// ANCHOR_END: head

// ANCHOR: ours
// The exercises; and the pictures of this page, for the window, the command line and the tests
// of this project.
pub mod exercises;
pub mod views;
pub use views::STAGE;
// ANCHOR_END: ours
