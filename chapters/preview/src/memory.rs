//! Memory, asked for before it is needed: where it is short, Rust aborts.

use rayon::ThreadPoolBuilder;
use std::thread::available_parallelism;

/// What a thread needs: its stack, and the 64 MB that glibc reserves for all it allocates.
const PER_THREAD: u64 = 72 << 20;

/// The threads beside rayon's: the main one, that of signals, and that of the walk.
const OTHER_THREADS: u64 = 3;

/// Returns whether there is memory for so many bytes, and for the threads that render. If it
/// is only for some of these, no more will be started.
///
/// It is asked for and given back. So this finds out what a limit allows (`ulimit -v`) and
/// what the system would refuse, not what other programs will take.
pub(crate) fn make_room(bytes: u64) -> bool {
    let all = available_parallelism().map_or(1, |threads| threads.get() as u64);
    let has_room = |threads| {
        let total = bytes + (threads + OTHER_THREADS) * PER_THREAD;
        usize::try_from(total)
            .is_ok_and(|total| Vec::<u8>::new().try_reserve_exact(total).is_ok())
    };
    let mut threads = all;
    while threads > 0 && !has_room(threads) {
        threads /= 2;
    }
    if threads > 0 && threads < all {
        // An error means that they have been started before.
        let _ = ThreadPoolBuilder::new()
            .num_threads(threads as usize)
            .build_global();
    }
    threads > 0
}
