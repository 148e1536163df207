// ANCHOR: head
//! Speed against accuracy: what each method costs, how wrong it is, and no more than a
//! picture needs.

pub mod chart;
pub mod patterns;
pub mod peers;
pub mod pictures;
pub mod plan;
pub mod sampling;
pub mod scenes;
pub mod studies;
pub mod study;
pub mod views;
pub use studies::{STUDIES, TASKS, measure};
pub use views::STAGE;
// ANCHOR_END: head
