//! From linear light to levels, rightly and wrongly.

use crate::fault::Fault;
use glam::Vec3;

/// Returns the linear light, 0 to 1, that sRGB encodes to `encoded`.
#[must_use]
pub fn decode(encoded: f64) -> f64 {
    if encoded <= 0.04045 {
        encoded / 12.92
    } else {
        ((encoded + 0.055) / 1.055).powf(2.4)
    }
}

/// Returns the sRGB encoding of linear light; it may be above 1.
#[must_use]
pub fn encode(light: f64) -> f64 {
    if light <= 0.003_130_8 {
        12.92 * light
    } else {
        1.055 * light.powf(1.0 / 2.4) - 0.055
    }
}

/// Returns the levels of linear light, as `fault` would write them.
#[must_use]
pub fn levels(light: Vec3, fault: Fault) -> [u8; 3] {
    let light = match fault {
        Fault::Channels(order) => Vec3::from_array(order.map(|i| light[i])),
        Fault::Brighter(factor) => factor * light,
        Fault::Black => Vec3::ZERO,
        _ => light,
    };
    let levels = light.to_array().map(|light| level(f64::from(light), fault));
    match fault {
        Fault::Grey(weights) => {
            let levels = Vec3::from(levels.map(f32::from));
            [levels.dot(Vec3::from(weights)).round() as u8; 3]
        }
        Fault::Negative => levels.map(|level| 255 - level),
        _ => levels,
    }
}

fn level(light: f64, fault: Fault) -> u8 {
    if light.is_nan() {
        return 0;
    }
    let clamped = light.clamp(0.0, 1.0);
    let rounded = |encoded: f64| (255.0 * encoded).round() as u8;
    match fault {
        Fault::Linear => rounded(clamped),
        Fault::Gamma(gamma) => rounded(clamped.powf(1.0 / f64::from(gamma))),
        Fault::EncodedTwice => rounded(encode(encode(clamped))),
        Fault::DecodedInstead => rounded(decode(clamped)),
        Fault::Truncated(scale) => (scale * encode(clamped)) as u8,
        Fault::Wraps => (255.0 * encode(light.max(0.0)) + 0.5) as u32 as u8,
        Fault::ToneMapped => rounded(encode(light.max(0.0) / (1.0 + light.max(0.0)))),
        _ => rounded(encode(clamped)),
    }
}
