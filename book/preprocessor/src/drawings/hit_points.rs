//! Hits that were computed in f32, and the surface that they should lie on.

use super::{Panel, number, scale};
use canvas::Pixel;
use glam::UVec2;
use plane_hit::scene::still_life;
use plane_hit::{Shape, nearest};
use ray_casting::scene::still_life_camera;

/// The object whose hits are drawn.
const NAME: &str = "mirror";
const PICTURE: UVec2 = UVec2::new(320, 240);
/// As many pixels of a row through the object's middle.
const SHOWN: usize = 48;
const SIZE: [f64; 2] = [480.0, 300.0];
/// The plot in the panel: from left to right and from bottom to top.
const COLUMNS: [f64; 2] = [40.0, 474.0];
const ROWS: [f64; 2] = [290.0, 10.0];
/// The unit of the heights.
const TEN_MILLIONTH: f64 = 1e-7;

pub fn panels() -> Vec<Panel> {
    let hits = hits();
    let (rows, heights): (Vec<u32>, Vec<f64>) = hits.into_iter().unzip();
    let middle = (rows[0] + rows[rows.len() - 1]) / 2;
    let row = rows.iter().zip(&heights).filter(|(row, _)| **row == middle);
    let row: Vec<f64> = row.map(|(_, height)| height / TEN_MILLIONTH).collect();
    let start = (row.len() - SHOWN) / 2;
    let row = &row[start..start + SHOWN];

    let highest = row
        .iter()
        .fold(0.0, |highest: f64, height| highest.max(height.abs()));
    // Beyond the highest there is room for a line of text.
    let end = highest + 3.0;
    let x = scale([-1.0, SHOWN as f64], COLUMNS);
    let y = scale([-end, end], ROWS);
    let mut panel = Panel::new(SIZE);
    panel.rectangle("solid", [[COLUMNS[0], y(0.0)], [COLUMNS[1], ROWS[0]]]);
    let tick = 5.0;
    let ticks = (end / tick) as i32;
    for height in (-ticks..=ticks).map(|count| tick * f64::from(count)) {
        panel.line("faint", COLUMNS.map(|x| [x, y(height)]));
        let text = [COLUMNS[0] - 8.0, y(height) + 4.0];
        panel.text("small", "end", text, &number(height, 0));
    }
    let left = COLUMNS[0] + 8.0;
    panel.text(
        "ray",
        "start",
        [left, ROWS[1] + 16.0],
        "above: from here the light is seen",
    );
    panel.text(
        "normal",
        "start",
        [left, ROWS[0] - 8.0],
        "below: from here the ball itself is in the way",
    );
    panel.line("ink", COLUMNS.map(|x| [x, y(0.0)]));
    for (i, &height) in row.iter().enumerate() {
        let class = if height < 0.0 {
            "dot normal"
        } else {
            "dot ray"
        };
        let at = [x(i as f64), y(height)];
        panel.line("faint", [at, [at[0], y(0.0)]]);
        panel.circle(class, at, 4.0);
    }
    let percent = |is_there: fn(f64) -> bool| {
        let count = heights.iter().filter(|height| is_there(**height)).count();
        number(100.0 * count as f64 / heights.len() as f64, 0)
    };
    let [above, below] = [
        percent(|height| height > 0.0),
        percent(|height| height < 0.0),
    ];
    panel.caption = format!(
        "The hits of {SHOWN} neighbouring pixels on the {NAME} ball, and their height above its surface in ten-millionths \
         (10⁻⁷). Of all hits on the ball, in a picture of {} × {}, {above} % are above the surface and {below} % below.",
        PICTURE.x, PICTURE.y
    );
    panel.description = format!(
        "A level line is the surface, greatly magnified. {SHOWN} points scatter about it, some above and some below, at \
         most {} ten-millionths away.",
        number(highest, 1),
    );
    vec![panel]
}

/// Returns the row of the picture, and the exact height above the surface, of every hit on
/// the object.
fn hits() -> Vec<(u32, f64)> {
    let objects = still_life([(); 6]);
    let camera = still_life_camera();
    let hit = |pixel: Pixel| {
        let ray = camera.ray(pixel.centre());
        let (index, t) = nearest(&objects, &ray)?;
        match objects[index].shape {
            Shape::Sphere(sphere) if objects[index].name == NAME => {
                let from_centre = ray.at(t).as_dvec3() - sphere.centre.as_dvec3();
                Some((pixel.y, from_centre.length() - f64::from(sphere.radius)))
            }
            _ => None,
        }
    };
    Pixel::all(PICTURE).filter_map(hit).collect()
}

#[cfg(test)]
mod the_hits {
    use super::*;

    /// A point 10 away is rounded to 10⁻⁶ or less.
    #[test]
    fn are_on_both_sides_of_the_surface_and_near_it() {
        let hits = hits();
        let count = |is_there: fn(f64) -> bool| {
            hits.iter().filter(|(_, height)| is_there(*height)).count() as f64
                / hits.len() as f64
        };
        assert!(count(|height| height > 0.0) > 0.3);
        assert!(count(|height| height < 0.0) > 0.3);
        assert!(hits.iter().all(|(_, height)| height.abs() < 2e-6));
    }
}
