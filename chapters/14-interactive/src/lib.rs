//! A walk through the still life, while it is traced.

pub mod explain;
pub mod overlay;
mod tree;
