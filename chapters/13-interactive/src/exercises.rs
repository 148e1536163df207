//! The chapter's exercises: functions for you to write.

use ray_casting::Camera;

// ANCHOR: exercise-1
/// Returns the camera leaning to the right by an angle of which the cosine and the sine are
/// given: its `up` turns towards its `right` by that angle. It looks where it looked before.
pub fn leaning(camera: &Camera, _cos: f32, _sin: f32) -> Camera {
    // Yours to write.
    *camera
}
// ANCHOR_END: exercise-1

// ANCHOR: exercise-2
/// Returns the numbers of a pixel's n × n samples, 0 to n² − 1, row by row from the top left, in
/// another order: those nearest to the middle of the pixel first.
pub fn middle_first(n: u32) -> Vec<u32> {
    // Yours to write.
    (0..n * n).collect()
}
// ANCHOR_END: exercise-2
