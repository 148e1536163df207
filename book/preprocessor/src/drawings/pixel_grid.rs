//! The pixels of a small picture on the image plane.

use super::{Panel, number, scale};
use canvas::Pixel;
use glam::{UVec2, Vec2};

const SIZE: UVec2 = UVec2::new(6, 4);
/// The image plane in the panel: from left to right and from bottom to top.
const COLUMNS: [f64; 2] = [46.0, 382.0];
const ROWS: [f64; 2] = [274.0, 50.0];

pub fn panels() -> Vec<Panel> {
    let pixel = |x, y| Pixel { x, y, size: SIZE };
    let (first, other) = (pixel(0, 0), pixel(4, 1));
    let half = half_plane();
    let x = scale([-half.x, half.x].map(f64::from), COLUMNS);
    let y = scale([-half.y, half.y].map(f64::from), ROWS);
    let at = |point: Vec2| [x(point.x.into()), y(point.y.into())];
    let mut panel = Panel::new([440.0, 308.0]);

    let name = |pixel: Pixel| format!("({}, {})", pixel.x, pixel.y);
    for shown in [first, other] {
        let corner = Vec2::splat(shown.footprint() / 2.0);
        panel.rectangle(
            "solid",
            [shown.centre() - corner, shown.centre() + corner].map(at),
        );
    }
    for column in 0..=SIZE.x {
        let x = x(f64::from(column as f32 * first.footprint() - half.x));
        panel.line("faint", [[x, ROWS[0]], [x, ROWS[1]]]);
    }
    for row in 0..=SIZE.y {
        let y = y(f64::from(row as f32 * first.footprint() - half.y));
        panel.line("faint", [[COLUMNS[0], y], [COLUMNS[1], y]]);
    }
    panel.arrow(
        "ray",
        [[COLUMNS[0] - 14.0, y(0.0)], [COLUMNS[1] + 34.0, y(0.0)]],
    );
    panel.arrow("ray", [[x(0.0), ROWS[0] + 14.0], [x(0.0), ROWS[1] - 34.0]]);
    panel.text("ray", "start", [COLUMNS[1] + 40.0, y(0.0) + 5.0], "x");
    panel.text("ray", "start", [x(0.0) + 10.0, ROWS[1] - 26.0], "y");
    let numbers = |x: f32| number(x.into(), 2);
    for end in [-half.x, half.x] {
        panel.text(
            "ray",
            "middle",
            [x(end.into()), ROWS[0] + 20.0],
            &numbers(end),
        );
    }
    panel.text("ray", "start", [x(0.0) + 8.0, ROWS[0] + 20.0], "0");
    for end in [-half.y, 0.0, half.y] {
        let text = [COLUMNS[0] - 18.0, y(end.into()) + 5.0];
        panel.text("ray", "end", text, &numbers(end));
    }
    for pixel in Pixel::all(SIZE) {
        let [x, y] = at(pixel.centre());
        panel.circle("dot", [x, y], 3.0);
        panel.text("small", "middle", [x, y + 20.0], &name(pixel));
    }
    let place = |pixel: Pixel| {
        let centre = pixel.centre();
        format!("({}, {})", numbers(centre.x), numbers(centre.y))
    };
    panel.caption = format!(
        "A picture of {} × {} pixels on the image plane, which is {} wide and {} high. Each pixel is a square with a \
         side of {}. The centre of pixel {} is at {}, that of pixel {} at {}.",
        SIZE.x,
        SIZE.y,
        numbers(2.0 * half.x),
        numbers(2.0 * half.y),
        numbers(first.footprint()),
        name(first),
        place(first),
        name(other),
        place(other),
    );
    panel.description = format!(
        "A grid of {} by {} pixels with a dot in the centre of each. Pixel {} is in the top left corner. The image \
         plane’s x axis points to the right, its y axis upwards, and both start in the middle of the grid.",
        SIZE.x,
        SIZE.y,
        name(first),
    );
    vec![panel]
}

/// Returns half the image plane's width and height: half a pixel beyond the last pixel's
/// centre.
fn half_plane() -> Vec2 {
    let last = Pixel {
        x: SIZE.x - 1,
        y: 0,
        size: SIZE,
    };
    last.centre() + Vec2::splat(last.footprint() / 2.0)
}

#[cfg(test)]
mod the_pixel_grid {
    use super::*;

    /// 2 is the plane's height, and 6/4 its width to its height.
    #[test]
    fn fills_the_image_plane() {
        let half = half_plane();
        assert!((half - Vec2::new(1.5, 1.0)).length() < 1e-6, "{half}");
        // As many pixels to the right as down, so that they are drawn as squares.
        let [width, height] = [COLUMNS, ROWS].map(|ends| (ends[1] - ends[0]).abs());
        assert_eq!(width * f64::from(SIZE.y), height * f64::from(SIZE.x));
        let caption = &panels()[0].caption;
        // (0 + ½ − 3)/2 and (2 − ½)/2; (4 + ½ − 3)/2 and (2 − 1½)/2.
        for place in ["at (−1.25, 0.75)", "at (0.75, 0.25)"] {
            assert!(caption.contains(place), "{caption}");
        }
    }
}
