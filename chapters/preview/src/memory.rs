//! Memory, asked for before it is needed: where it is short, Rust aborts.

use std::thread::available_parallelism;

/// What a program needs for each of its threads: their stacks, and what they allocate.
pub(crate) const PER_THREAD: u64 = 4 << 20;

/// The same while a window is open, whose threads allocate without end: the system's
/// allocator reserves 64 MB for each.
pub(crate) const PER_WINDOW_THREAD: u64 = 72 << 20;

/// Returns whether there is memory for so many `bytes`, and for so many on each thread.
///
/// It is asked for and given back. So this finds out what a limit allows (`ulimit -v`) and
/// what the system would refuse, not what other programs will take.
pub(crate) fn has_room(bytes: u64, per_thread: u64) -> bool {
    let threads = available_parallelism().map_or(1, |threads| threads.get() as u64);
    // Beside the workers: the main thread, that of signals, that of rendering, and a spare.
    let total = bytes + (threads + 4) * per_thread;
    usize::try_from(total)
        .is_ok_and(|total| Vec::<u8>::new().try_reserve_exact(total).is_ok())
}
