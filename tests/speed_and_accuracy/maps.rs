//! The maps' colours.

use canvas::{Canvas, Picture};
use glam::{DVec3, UVec2, Vec3};
use speed_and_accuracy::error_map::{cost_map, error_map, level_error};

/// The radiance of one pixel of a map, as levels.
fn levels_of(map: Picture) -> [u8; 3] {
    Canvas::render(&map, UVec2::ONE).levels[0]
}

fn grey(radiance: f32) -> Picture {
    Picture::new(move |_| Vec3::splat(radiance))
}

/// White is level 255, and 0.0031308 the last on the encoding's straight part, 12.92 L. A
/// screen shows no light beyond white.
#[test]
fn an_error_is_that_of_the_worst_channel_on_a_screen() {
    let exact = DVec3::new(1.0, 0.002, 0.5);
    assert!(level_error(exact.as_vec3(), exact) < 1e-4);
    let dark = level_error(Vec3::new(0.0, 0.002, 0.5), exact);
    assert!((dark - 255.0).abs() < 1e-9, "{dark}");
    assert!(level_error(Vec3::new(7.0, 0.002, 0.5), exact) < 1e-4);
    let off = level_error(Vec3::new(1.0, 0.003, 0.5), exact);
    assert!((off - 255.0 * 12.92 * 0.001).abs() < 1e-4, "{off}");
}

/// Ten times as much is the next colour, up to ten levels.
#[test]
fn a_larger_error_is_brighter() {
    let map = |levels: f32| {
        // On the straight part of the encoding.
        let ours = levels / (255.0 * 12.92);
        levels_of(error_map(grey(ours), grey(0.0)))
    };
    let errors = [2e-6, 2e-5, 2e-4, 2e-3, 2e-2, 0.2, 2.0, 10.1];
    let colours = errors.map(map);
    assert_eq!(colours[0], [0, 0, 4]);
    let brightness = colours.map(|levels| levels.map(u32::from).iter().sum::<u32>());
    assert!(brightness.is_sorted_by(|a, b| a < b), "{brightness:?}");
    for (error, colour) in errors.into_iter().zip(colours).take(7) {
        assert_eq!(map(4.0 * error), colour, "{error}");
    }
    assert_eq!(levels_of(error_map(grey(1.0), grey(0.0))), colours[7]);
}

#[test]
fn a_map_of_costs_counts_rays() {
    let map = |rays: u32| {
        levels_of(cost_map(Picture::new(move |_| {
            canvas::count_rays(rays);
            Vec3::ONE
        })))
    };
    let black = [0, 0, 4];
    let plum = [159, 42, 99];
    for (rays, colour) in [(0, black), (1, black), (8, plum), (15, plum)] {
        assert_eq!(map(rays), colour, "{rays} rays");
    }
    assert_ne!(map(2), black);
    assert_ne!(map(127), map(128));
    assert_eq!(map(100_000), map(128));
}
