//! Prepares pages.
fn main() {}
