//! The tests of `check`.

mod agreement;
mod program;
mod rates;
