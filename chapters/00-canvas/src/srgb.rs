//! From linear light to the levels of a screen, by thresholds: as exact as the formula, and
//! much faster.

use crate::linear;
use glam::Vec3;
use std::sync::LazyLock;

// ANCHOR: thresholds
/// `THRESHOLDS[i]` is the least f32 that is encoded to level i + 1: a level is 255 times
/// the encoded value, rounded, so it begins at half a level less.
static THRESHOLDS: LazyLock<[f32; 255]> = LazyLock::new(|| {
    std::array::from_fn(|i| {
        let exact = linear((i as f64 + 0.5) / 255.0);
        let nearest = exact as f32;
        if f64::from(nearest) < exact {
            nearest.next_up()
        } else {
            nearest
        }
    })
});
// ANCHOR_END: thresholds

// ANCHOR: encode
/// The number of equal parts of [0, 1) in the index. No part holds more than one
/// threshold: they are at least 1 / (12.92 · 255) apart.
const PARTS: usize = 4096;

/// `INDEX[i]` is the number of thresholds at or below i / `PARTS`.
static INDEX: LazyLock<[u8; PARTS]> = LazyLock::new(|| {
    std::array::from_fn(|i| {
        let start = i as f32 / PARTS as f32;
        THRESHOLDS.partition_point(|&threshold| threshold <= start) as u8
    })
});

fn encode_channel(linear: f32) -> u8 {
    if !(linear > 0.0) {
        return 0;
    }
    if linear >= THRESHOLDS[254] {
        return 255;
    }
    let level = INDEX[(linear * PARTS as f32) as usize];
    level + u8::from(THRESHOLDS[level as usize] <= linear)
}

/// Returns the sRGB levels of linear light, 0 to 255, correctly rounded.
///
/// Light below 0 and NaN give 0, light above 1 gives 255.
pub fn encode(radiance: Vec3) -> [u8; 3] {
    radiance.to_array().map(encode_channel)
}
// ANCHOR_END: encode
