//! The exercises' solutions, as the book prints them.

use ::canvas::{Pixel, decode, encode};
use glam::Vec3;

// ANCHOR: exercise-1
pub fn glow(pixel: Pixel) -> Vec3 {
    let size = pixel.size.as_vec2();
    let right = (pixel.x as f32 + 0.5) / size.x;
    let up = 1.0 - (pixel.y as f32 + 0.5) / size.y;
    Vec3::new(right, up, pixel.centre().length())
}
// ANCHOR_END: exercise-1

// ANCHOR: exercise-2
pub fn squares_of_pixels(pixel: Pixel) -> Vec3 {
    let is_white = (pixel.x / 8 + pixel.y / 8).is_multiple_of(2);
    Vec3::splat(f32::from(is_white))
}

pub fn squares_of_the_plane(pixel: Pixel) -> Vec3 {
    // Rounded down, and not towards zero; an integer, since the remainder by 2 is asked for.
    let cell = (pixel.centre() / 0.1).floor().as_ivec2();
    let is_white = (cell.x + cell.y).rem_euclid(2) == 0;
    Vec3::splat(f32::from(is_white))
}
// ANCHOR_END: exercise-2

// ANCHOR: exercise-3
pub fn shrink(four: [[u8; 3]; 4]) -> [u8; 3] {
    let light = four.map(|levels| Vec3::from_array(levels.map(decode)));
    encode(light.iter().sum::<Vec3>() / 4.0)
}
// ANCHOR_END: exercise-3
