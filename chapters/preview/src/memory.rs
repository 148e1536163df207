//! Memory, asked for before it is needed: where it is short, Rust aborts.

use std::thread::available_parallelism;

/// What a program needs beside its pictures: its threads' stacks, and what they allocate.
const PER_THREAD: u64 = 4 << 20;

/// Returns whether there is memory for `count` times `bytes`, and for the program itself.
///
/// It is asked for and given back. So this finds out what a limit allows (`ulimit -v`) and
/// what the system would refuse, not what other programs will take.
pub(crate) fn has_room(count: u64, bytes: u64) -> bool {
    let threads = available_parallelism().map_or(1, |threads| threads.get() as u64);
    let total = count * bytes + (threads + 4) * PER_THREAD;
    usize::try_from(total)
        .is_ok_and(|total| Vec::<u8>::new().try_reserve_exact(total).is_ok())
}
