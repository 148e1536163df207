//! Counts rays: the cost of a picture, the same on every machine and at any time of day.

use std::cell::Cell;

// ANCHOR: rays
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
#[must_use]
pub fn rays_so_far() -> u64 {
    RAYS.get()
}
// ANCHOR_END: rays
