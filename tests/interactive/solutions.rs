//! The exercises' solutions, as the book prints them.

use ::ray_casting::Camera;

// ANCHOR: exercise-1
pub fn leaning(camera: &Camera, cos: f32, sin: f32) -> Camera {
    Camera {
        right: cos * camera.right - sin * camera.up,
        up: cos * camera.up + sin * camera.right,
        ..*camera
    }
}
// ANCHOR_END: exercise-1

// ANCHOR: exercise-2
pub fn middle_first(n: u32) -> Vec<u32> {
    let mut samples: Vec<u32> = (0..n * n).collect();
    samples.sort_by_key(|i| {
        // Twice the distance from the middle, in cells: a whole number.
        let [x, y] = [i % n, i / n].map(|place| (2 * place + 1).abs_diff(n));
        x * x + y * y
    });
    samples
}
// ANCHOR_END: exercise-2
