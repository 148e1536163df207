// ANCHOR: head
//! Speed against accuracy: what each method costs, and how wrong it is.

pub mod chart;
mod digits;
pub mod error_map;
pub mod lanes;
pub mod studies;
pub mod study;
pub mod table;
pub mod views;
pub use studies::STUDIES;
pub use views::STAGE;
// ANCHOR_END: head
