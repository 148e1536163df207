//! Rows that are rendered for a file, and are never a whole canvas.

use ::canvas::{Canvas, Picture, STAGE};
use glam::UVec2;
use std::convert::Infallible;

/// Whether there are fewer rows than are in memory at a time, as many, or some more.
#[test]
fn rows_in_order_are_the_canvass() {
    let picture = (STAGE.hero().picture)(0.0);
    for (width, height) in [
        (1, 1),
        (7, 1),
        (5, 63),
        (5, 64),
        (5, 65),
        (1, 128),
        (40, 200),
    ] {
        let size = UVec2::new(width, height);
        let mut rows = Vec::new();
        let Ok(()) = picture.render_rows(size, |levels| {
            assert_eq!(levels.len() % width as usize, 0);
            assert!(levels.len() < 100 * width as usize);
            rows.extend_from_slice(levels);
            Ok::<(), Infallible>(())
        });
        assert!(rows == Canvas::render(&picture, size).levels, "{size}");
    }
}

#[test]
fn an_error_ends_the_rendering() {
    let picture = (STAGE.hero().picture)(0.0);
    let mut calls = 0;
    let result = picture.render_rows(UVec2::new(8, 1000), |_| {
        calls += 1;
        if calls < 3 { Ok(()) } else { Err("full") }
    });
    assert_eq!((result, calls), (Err("full"), 3));
}

#[test]
fn a_picture_without_a_pixel_has_no_rows() {
    let picture = Picture::new(|_| unreachable!("there is no pixel"));
    for size in [(0, 5), (5, 0), (0, 0)].map(UVec2::from) {
        let Ok(()) = picture.render_rows(size, |levels| {
            assert!(levels.is_empty());
            Ok::<(), Infallible>(())
        });
    }
}
