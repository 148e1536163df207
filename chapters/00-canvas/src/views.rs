//! The chapter's pictures.

use crate::{Picture, Stage, View, folder_name};
use glam::Vec3;

/// The chapter's description.
pub const STAGE: Stage = Stage {
    name: folder_name(env!("CARGO_MANIFEST_DIR")),
    title: "A picture, and a window to see it in",
    hero: "gradient",
    bugs: &[],
    views: &[
        View {
            name: "gradient",
            caption: "The first picture: red grows to the right, green grows upwards, blue stays the same.",
            knob: None,
            picture: |_| {
                Picture::new(|pixel| {
                    let size = pixel.size.as_vec2();
                    let right = (pixel.x as f32 + 0.5) / size.x;
                    let up = 1.0 - (pixel.y as f32 + 0.5) / size.y;
                    Vec3::new(right, up, 0.25)
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

/// The light of a screen's level 128: ((128/255 + 0.055) / 1.055)^2.4.
const LEVEL_128: f32 = 0.215_860_5;
