//! From linear light to the levels of a screen, exactly.

use glam::Vec3;
use std::sync::LazyLock;

// ANCHOR: definition
/// Whether a linear `light` is encoded to `level` or to a higher one, 1 ≤ `level` ≤ 255.
///
/// sRGB says: the encoded value is 12.92 v up to v = 0.0031308, and 1.055 v^(1/2.4) −
/// 0.055 above; a screen's level is 255 times that, rounded. A power like 1/2.4 differs
/// in its last bit from one machine to the next, so we ask the same question with whole
/// powers, which do not: v^(1/2.4) ≥ y  ⇔  v⁵ ≥ y¹².
///
/// Source: IEC 61966-2-1.
fn reaches(light: f64, level: u8) -> bool {
    let encoded = (f64::from(level) - 0.5) / 255.0;
    if light <= 0.003_130_8 {
        12.92 * light >= encoded
    } else {
        let y = (encoded + 0.055) / 1.055;
        let y3 = y * y * y;
        let y6 = y3 * y3;
        light * light * light * light * light >= y6 * y6
    }
}
// ANCHOR_END: definition

// ANCHOR: thresholds
/// `THRESHOLDS[i]` is the least f32 that is encoded to level i + 1, found by bisection.
///
/// The bits of positive floats, read as integers, are in the order of the floats.
static THRESHOLDS: LazyLock<[f32; 255]> = LazyLock::new(|| {
    std::array::from_fn(|i| {
        let level = i as u8 + 1;
        let (mut below, mut above) = (0.0_f32.to_bits(), 1.0_f32.to_bits());
        while above - below > 1 {
            let middle = below + (above - below) / 2;
            if reaches(f64::from(f32::from_bits(middle)), level) {
                above = middle;
            } else {
                below = middle;
            }
        }
        f32::from_bits(above)
    })
});
// ANCHOR_END: thresholds

// ANCHOR: encode
/// How many equal parts of [0, 1) the index has: enough for no part to hold more than one
/// threshold, which are at least 1 / (12.92 · 255) from each other.
const PARTS: usize = 4096;

/// `INDEX[i]` is how many thresholds the light i / `PARTS` reaches: where the search
/// starts, and a step further ends.
static INDEX: LazyLock<[u8; PARTS]> = LazyLock::new(|| {
    std::array::from_fn(|i| {
        let light = i as f32 / PARTS as f32;
        THRESHOLDS.partition_point(|&threshold| threshold <= light) as u8
    })
});

fn encode_channel(light: f32) -> u8 {
    if !(light > 0.0) {
        return 0;
    }
    if light >= THRESHOLDS[254] {
        return 255;
    }
    let level = INDEX[(light * PARTS as f32) as usize];
    level + u8::from(THRESHOLDS[level as usize] <= light)
}

/// Encodes linear light for a screen: sRGB, 0 to 255, correctly rounded.
///
/// Below 0, and NaN, give 0; above 1 gives 255.
#[must_use]
pub fn encode(light: Vec3) -> [u8; 3] {
    light.to_array().map(encode_channel)
}
// ANCHOR_END: encode

// ANCHOR: decode
/// The least linear light that is encoded to `level`.
#[must_use]
pub fn decode(level: u8) -> f32 {
    match level.checked_sub(1) {
        Some(below) => THRESHOLDS[below as usize],
        None => 0.0,
    }
}
// ANCHOR_END: decode
