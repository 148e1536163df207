// ANCHOR: head
//! An adaptive renderer, which decides how far rays are followed, and how many a pixel
//! takes.

mod plan;
mod sample;
pub mod study;
mod trace;
pub mod views;
pub use plan::{DEFAULT_TOLERANCE, Plan};
pub use trace::Sample;
pub use views::STAGE;
// ANCHOR_END: head
