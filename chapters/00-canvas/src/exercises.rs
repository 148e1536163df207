//! The chapter's exercises: functions for you to write.

// ANCHOR: uses
use crate::Pixel;
use glam::Vec3;
// ANCHOR_END: uses

// ANCHOR: exercise-1
/// Returns the light of the gradient, red to the right and green upwards, but with a blue that
/// is the distance of the pixel's centre from the middle of the picture.
pub fn glow(pixel: Pixel) -> Vec3 {
    // Yours to write.
    let size = pixel.size.as_vec2();
    let right = (pixel.x as f32 + 0.5) / size.x;
    let up = 1.0 - (pixel.y as f32 + 0.5) / size.y;
    Vec3::new(right, up, 0.25)
}
// ANCHOR_END: exercise-1

// ANCHOR: exercise-2
/// Returns the light of a checkerboard of black and white squares, 8 pixels wide; the one in
/// the top left corner is white.
pub fn squares_of_pixels(pixel: Pixel) -> Vec3 {
    // Yours to write.
    Vec3::splat(((pixel.x + pixel.y) % 2) as f32)
}

/// Returns the light of a checkerboard of black and white squares, 0.1 wide on the image
/// plane; the one above and to the right of the middle is white.
pub fn squares_of_the_plane(pixel: Pixel) -> Vec3 {
    // Yours to write.
    squares_of_pixels(pixel)
}
// ANCHOR_END: exercise-2

// ANCHOR: exercise-3
/// Returns the levels of the one pixel that has the light of four: of a picture shrunk to half
/// its width and height.
pub fn shrink(four: [[u8; 3]; 4]) -> [u8; 3] {
    // Yours to write.
    [0, 1, 2].map(|channel| {
        let sum: u32 = four.iter().map(|levels| u32::from(levels[channel])).sum();
        (sum / 4) as u8
    })
}
// ANCHOR_END: exercise-3
