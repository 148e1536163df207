// ANCHOR: head
//! Speed against accuracy: what each method costs, and how wrong it is.

pub mod chart;
mod digits;
pub mod error_map;
pub mod lanes;
pub mod studies;
pub mod study;
pub mod table;
pub use studies::STUDIES;
// ANCHOR_END: head

// ANCHOR: ours
// The exercises; and the pictures of this page, for the window, the command line and the tests
// of this project.
pub mod exercises;
pub mod views;
pub use views::STAGE;
// ANCHOR_END: ours
