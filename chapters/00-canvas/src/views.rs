//! The chapter's pictures.

use crate::{Picture, Pixel, Stage, View, decode, folder_name};
use glam::Vec3;

/// The chapter's description.
pub const STAGE: Stage = Stage {
    name: folder_name(env!("CARGO_MANIFEST_DIR")),
    title: "A canvas: a picture, and a window to see it in",
    hero: "gradient",
    bugs: &["gloomy"],
    views: &[
        View {
            name: "gradient",
            caption: "The first picture: red grows to the right, green grows upwards, blue stays the same.",
            knob: None,
            picture: |_| Picture::new(gradient),
        },
        View {
            name: "gloomy",
            caption: "The bug: the same numbers, written as levels without encoding. Too dark, except where they are 0 or 1.",
            knob: None,
            picture: |_| {
                Picture::new(|pixel| {
                    let levels = (255.0 * gradient(pixel)).round();
                    Vec3::from_array(levels.to_array().map(|level| decode(level as u8)))
                })
            },
        },
        View {
            name: "half-light",
            caption: "Three ways to half a light. Left: every other pixel white. Middle: linear 0.5, \
                      encoded as level 188. Right: level 128, which is not half the light. From a few \
                      steps away, left and middle are the same grey.",
            knob: None,
            picture: |_| {
                Picture::new(|pixel| {
                    Vec3::splat(match 3 * pixel.x / pixel.size.x {
                        0 => ((pixel.x + pixel.y) % 2) as f32,
                        1 => 0.5,
                        _ => LEVEL_128,
                    })
                })
            },
        },
    ],
};

fn gradient(pixel: Pixel) -> Vec3 {
    let [x, y] = [pixel.x, pixel.y].map(|i| i as f32 + 0.5);
    let size = pixel.size.as_vec2();
    Vec3::new(x / size.x, 1.0 - y / size.y, 0.25)
}

/// The light of a screen's level 128: ((128/255 + 0.055) / 1.055)^2.4.
const LEVEL_128: f32 = 0.215_860_5;
