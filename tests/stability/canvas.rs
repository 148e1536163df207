//! Chapter 0: the encoding of light, against its definition by powers in f64.

use glam::Vec3;
use oracle::level;

fn encode(light: f32) -> u8 {
    ::canvas::encode(Vec3::splat(light))[0]
}

/// The least f32 that is encoded to `wanted`, by the definition: its level, rounded, half up.
fn threshold(wanted: u8) -> f32 {
    let reaches =
        |bits| level(f64::from(f32::from_bits(bits))) >= f64::from(wanted) - 0.5;
    let (mut below, mut above) = (0, 1.0_f32.to_bits());
    while above - below > 1 {
        let middle = below.midpoint(above);
        if reaches(middle) {
            above = middle;
        } else {
            below = middle;
        }
    }
    f32::from_bits(above)
}

/// On both sides of all 255 thresholds. The definition is not in doubt there: the nearest f32 is 10⁻⁹ of a
/// level away from every one, and a power in f64 is exact to 10⁻¹³.
#[test]
fn every_level_begins_where_the_definition_says() {
    for wanted in 1..=255 {
        let first = threshold(wanted);
        let last = first.next_down();
        for light in [first, last] {
            let from_half = level(f64::from(light)) - (f64::from(wanted) - 0.5);
            assert!(from_half.abs() > 1e-9, "{light} is on the edge");
        }
        assert_eq!((encode(first), encode(last)), (wanted, wanted - 1));
    }
}

/// A million floats from 0 to 1, by their bits, in order: correctly rounded, and never darker than before.
#[test]
fn encoding_is_rounded_and_monotone() {
    let mut before = 0;
    for bits in (0..=1.0_f32.to_bits()).step_by(1013) {
        let light = f32::from_bits(bits);
        let encoded = encode(light);
        assert_eq!(
            f64::from(encoded),
            level(f64::from(light)).round(),
            "{light}"
        );
        assert!(encoded >= before);
        before = encoded;
    }
}

/// Half the light is level 187.516, not 128; and what is no light is black.
#[test]
fn half_the_light_is_level_188() {
    assert_eq!(encode(0.5), 188);
    for (light, encoded) in [(0.0, 0), (1.0, 255), (1.0_f32.next_down(), 255), (2.0, 255)]
    {
        assert_eq!(encode(light), encoded);
    }
    for light in [-0.0, -1.0, -1e-45, f32::NEG_INFINITY, f32::NAN, 1e-45] {
        assert_eq!(encode(light), 0);
    }
    assert_eq!(encode(f32::INFINITY), 255);
}
