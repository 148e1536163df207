// ANCHOR: rays
//! Counts rays: the cost of a picture, the same on every machine and at any time of day.

use std::cell::Cell;

thread_local! {
    static RAYS: Cell<u64> = const { Cell::new(0) };
}

/// Counts one ray. Called wherever a ray is tested against a scene.
#[inline]
pub fn count_ray() {
    count_rays(1);
}

/// Counts several rays at once.
#[inline]
pub fn count_rays(rays: u32) {
    RAYS.set(RAYS.get() + u64::from(rays));
}

/// Returns the number of rays that this thread has counted so far.
pub fn rays_so_far() -> u64 {
    RAYS.get()
}

/// Returns the number of rays that all threads have counted so far: those of rayon, which
/// render, and this one.
pub fn rays_traced() -> u64 {
    let counts = rayon::broadcast(|_| rays_so_far());
    rays_so_far() + counts.iter().sum::<u64>()
}
// ANCHOR_END: rays
