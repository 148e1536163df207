//! Am I right? Compares a reader's picture with the book's, and names what probably went wrong.
//!
//! It imports no chapter: it draws the book's pictures by a [`tracer`] of its own, and draws them
//! once more with every [`fault`] to see which of them differs from the book as the reader's does.

#![expect(
    clippy::disallowed_methods,
    reason = "no picture of the book is made here, and a cause is not a matter of last bits"
)]

pub mod fault;
pub mod figures;
pub mod image;
pub mod levels;
pub mod matching;
pub mod mutations;
pub mod report;
pub mod tracer;
