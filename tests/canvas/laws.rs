//! The encoding of light, against its definition by a power in f64; and a picture that is
//! rendered in the background.

use ::canvas::{
    Canvas, Picture, Pixel, STAGE, decode, differing, render, spawn_render, srgb,
};
use glam::{UVec2, Vec2, Vec3};
use harness::bits;
use image::RgbImage;
use oracle::level;

/// Returns the level of linear light: by the formula, and by the table, which must agree.
fn encode(linear: f32) -> u8 {
    let linear = Vec3::splat(linear);
    let [level, ..] = ::canvas::encode(linear);
    assert_eq!(srgb::encode(linear), [level; 3], "{linear}");
    level
}

/// Returns the least f32 that the definition encodes to `wanted`: its level, rounded half up.
fn threshold(wanted: u8) -> f32 {
    let is_at_least =
        |bits| level(f64::from(f32::from_bits(bits))) >= f64::from(wanted) - 0.5;
    let (mut below, mut above) = (0, 1.0_f32.to_bits());
    while above - below > 1 {
        let middle = below.midpoint(above);
        if is_at_least(middle) {
            above = middle;
        } else {
            below = middle;
        }
    }
    f32::from_bits(above)
}

/// On both sides of all 255 thresholds. The definition is not in doubt there: the nearest
/// f32 is 10⁻⁹ of a level away from every threshold, and a power in f64 is exact to 10⁻¹³.
#[test]
fn every_level_begins_where_the_definition_says() {
    for wanted in 1..=255 {
        let first = threshold(wanted);
        let last = first.next_down();
        for linear in [first, last] {
            let from_half = level(f64::from(linear)) - (f64::from(wanted) - 0.5);
            assert!(from_half.abs() > 1e-9, "{linear} is on the edge");
        }
        assert_eq!((encode(first), encode(last)), (wanted, wanted - 1));
    }
}

/// Decoding gives the middle of a level: to f32's rounding, the light that is encoded to the
/// level exactly.
#[test]
fn a_decoded_level_is_encoded_to_itself() {
    assert_eq!((decode(0), decode(255)), (0.0, 1.0));
    for i in 0..=255 {
        let light = decode(i);
        assert_eq!(encode(light), i);
        assert!((level(f64::from(light)) - f64::from(i)).abs() < 1e-4);
    }
}

/// Their sum is rounded for each of them, which moves it over no threshold.
#[test]
fn the_mean_of_up_to_1024_equal_decoded_lights_has_the_same_level() {
    for i in 0..=255 {
        let light = decode(i);
        let mut sum = 0.0;
        for n in 1..=1024_u16 {
            sum += light;
            assert_eq!(encode(sum / f32::from(n)), i, "{n} times level {i}");
        }
    }
}

/// In either direction; and its rows, which are none, or empty.
#[test]
fn a_picture_without_a_pixel_is_an_empty_canvas() {
    let picture = || Picture::new(|_| unreachable!("there is no pixel"));
    for size in [(0, 5), (5, 0), (0, 0)].map(UVec2::from) {
        let canvas = Canvas::render(&picture(), size);
        assert_eq!((canvas.size, canvas.rays), (size, 0));
        assert!(canvas.radiance.is_empty() && canvas.levels.is_empty());
        let rows = spawn_render(picture(), size);
        assert!(rows.iter().all(|row| row.levels.is_empty()));
    }
}

/// A million floats from 0 to 1, by their bits, in order: correctly rounded, and never darker
/// than the one before.
#[test]
fn encoding_is_rounded_and_monotone() {
    let mut before = 0;
    for bits in (0..=1.0_f32.to_bits()).step_by(1013) {
        let linear = f32::from_bits(bits);
        let encoded = encode(linear);
        assert_eq!(
            f64::from(encoded),
            level(f64::from(linear)).round(),
            "{linear}"
        );
        assert!(encoded >= before);
        before = encoded;
    }
}

/// Half the light is level 187.516, not 128; numbers that are no light are black.
#[test]
fn half_the_light_is_level_188() {
    assert_eq!(encode(0.5), 188);
    let ordinary = [(0.0, 0), (1.0, 255), (1.0_f32.next_down(), 255), (2.0, 255)];
    for (linear, encoded) in ordinary {
        assert_eq!(encode(linear), encoded);
    }
    for linear in [-0.0, -1.0, -1e-45, f32::NEG_INFINITY, f32::NAN, 1e-45] {
        assert_eq!(encode(linear), 0);
    }
    assert_eq!(encode(f32::INFINITY), 255);
}

/// Rows arrive in any order, each of them once; written to a canvas they are the picture.
#[test]
fn a_picture_rendered_in_the_background_is_the_same() {
    let size = UVec2::new(40, 30);
    for view in ::canvas::STAGE.views {
        let picture = || (view.picture)(view.default_setting());
        let canvas = Canvas::render(&picture(), size);
        let mut written = Canvas::black(size);
        let mut rows = 0;
        for row in spawn_render(picture(), size) {
            written.write_row(&row);
            rows += 1;
        }
        assert_eq!(rows, size.y);
        assert!(written.levels == canvas.levels);
        let [written, canvas] = [written, canvas]
            .map(|canvas| canvas.radiance.iter().map(bits).collect::<Vec<_>>());
        assert!(written == canvas);
    }
}

/// Row by row from the top left, each once; the corners' centres are half a footprint inside the image plane.
#[test]
fn all_pixels_tile_the_image_plane() {
    let size = UVec2::new(7, 3);
    let all: Vec<Pixel> = Pixel::all(size).collect();
    assert_eq!(all.len(), 21);
    for (i, pixel) in (0..).zip(&all) {
        assert_eq!((pixel.x, pixel.y, pixel.size), (i % 7, i / 7, size));
    }
    let half = Vec2::splat(all[0].footprint() / 2.0);
    let corner = all[0].centre() + Vec2::new(-half.x, half.y);
    assert!(
        corner.distance(Vec2::new(-7.0 / 3.0, 1.0)) < 1e-6,
        "{corner}"
    );
    let corner = all[20].centre() + Vec2::new(half.x, -half.y);
    assert!(
        corner.distance(Vec2::new(7.0 / 3.0, -1.0)) < 1e-6,
        "{corner}"
    );
}

/// Returns the first view as a reader renders it.
fn first_picture(size: UVec2) -> RgbImage {
    let picture = (STAGE.hero().picture)(0.0);
    render(size, |pixel| picture.radiance(pixel))
}

#[test]
fn a_rendered_picture_has_the_levels_of_the_canvas() {
    for size in [(23, 11), (1, 1), (0, 5), (5, 0)].map(UVec2::from) {
        let picture = first_picture(size);
        assert_eq!(picture.dimensions(), size.into());
        let canvas = Canvas::render(&(STAGE.hero().picture)(0.0), size);
        assert_eq!(picture.as_raw(), canvas.levels.as_flattened());
    }
}

#[test]
fn a_picture_differs_from_its_file_where_it_has_been_changed() {
    let mut picture = first_picture(UVec2::new(23, 11));
    let folder = tempfile::tempdir().expect("a temporary folder");
    let path = folder.path().join("picture.png");
    let path = path.to_str().expect("a readable name");
    assert!(differing(&picture, path).is_err());
    picture.save(path).expect("a PNG");
    assert_eq!(differing(&picture, path).expect("a PNG"), 0);
    picture.get_pixel_mut(7, 0).0[2] ^= 1;
    picture.get_pixel_mut(22, 10).0 = [1, 2, 3];
    assert_eq!(differing(&picture, path).expect("a PNG"), 2);
    let larger = first_picture(UVec2::new(11, 23));
    assert!(std::panic::catch_unwind(|| differing(&larger, path)).is_err());
}
