//! The chapter's exercises: functions for you to write.

use reflection::MAX_DEPTH;

// ANCHOR: exercise-3
/// Returns the number of bounces between mirrors of some reflectivity, less than 1, after which
/// the throughput is for the first time at or below `least_throughput`, and the ray is traced no
/// farther.
pub fn bounces_allowed(_reflectivity: f32, _least_throughput: f32) -> u32 {
    // Yours to write.
    MAX_DEPTH
}
// ANCHOR_END: exercise-3

// ANCHOR: exercise-4
/// Returns the probability that each of some probe samples, placed at random in a pixel, misses a
/// dot whose radius is the given fraction of the pixel's side, at most a half.
pub fn probability_of_a_miss(radius: f32, samples: u32) -> f32 {
    // Yours to write.
    1.0 - radius * radius * samples as f32
}
// ANCHOR_END: exercise-4
