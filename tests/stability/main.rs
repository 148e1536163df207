//! Where the chapters' functions are exact, where they are wrong, and that nothing makes them panic.
//!
//! Each module is named for the chapter whose functions it tests: `cargo test sphere_hit` runs that
//! chapter's. "The exact answer" is `oracle::exact`'s: it takes the f32 inputs at their word, and its
//! signs are certain.

mod common;

mod anti_aliasing;
mod canvas;
mod every_stage;
mod fresnel;
mod plane_hit;
mod ray_casting;
mod reflection;
mod refraction;
mod shading;
mod shadows;
mod sphere_hit;
mod transparency;
