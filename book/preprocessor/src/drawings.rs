//! Drawings of what the chapters' code computes: every place and number in them is a
//! function's result.

mod hit_points;
mod pixel_grid;
mod reflectance;
mod sample_patterns;
mod scene_plan;

use crate::escape;
use mdbook_preprocessor::errors::{Error, Result};
use std::fmt::Write;
use std::iter::{once, repeat};

/// A drawing's panels, side by side where they fit.
type Draw = fn() -> Vec<Panel>;

const DRAWINGS: [(&str, Draw); 5] = [
    ("pixel-grid", pixel_grid::panels),
    ("scene-plan", scene_plan::panels),
    ("reflectance", reflectance::panels),
    ("sample-patterns", sample_patterns::panels),
    ("hit-points", hit_points::panels),
];

/// Returns the names of all drawings.
pub fn names() -> impl Iterator<Item = &'static str> {
    DRAWINGS.into_iter().map(|(name, _)| name)
}

/// Returns the HTML of the drawing called `name`.
///
/// # Errors
/// If there is no such drawing.
pub fn drawing(name: &str) -> Result<String> {
    let drawing = DRAWINGS.into_iter().find(|(known, _)| *known == name);
    let (_, panels) = drawing.ok_or_else(|| {
        let known = names().collect::<Vec<_>>().join(", ");
        Error::msg(format!("no drawing is called “{name}”, but {known}"))
    })?;
    let panels: String = panels().iter().map(Panel::html).collect();
    Ok(format!("<div class=\"figures\">\n{panels}</div>\n"))
}

/// A point in a panel: to the right and down, in pixels.
type Point = [f64; 2];

/// One panel of a drawing, in the classes of the book's style sheet.
struct Panel {
    size: Point,
    /// What is to be seen in it, for those who do not see it.
    description: String,
    caption: String,
    shapes: String,
}

impl Panel {
    fn new(size: Point) -> Self {
        Self {
            size,
            description: String::new(),
            caption: String::new(),
            shapes: String::new(),
        }
    }

    /// Adds a line through some points.
    fn line(&mut self, class: &str, points: impl IntoIterator<Item = Point>) {
        let words = once('M').chain(repeat('L')).zip(points);
        let path: String = words
            .map(|(word, [x, y])| format!("{word}{x:.1} {y:.1}"))
            .collect();
        self.push(format_args!("<path class=\"{class}\" d=\"{path}\"/>"));
    }

    /// Adds a line with an arrow's head at its end.
    fn arrow(&mut self, class: &str, [start, end]: [Point; 2]) {
        let [x, y] = [0, 1].map(|axis| end[axis] - start[axis]);
        let length = (x * x + y * y).sqrt();
        let [x, y] = [9.0 * x / length, 9.0 * y / length];
        let foot = [end[0] - x, end[1] - y];
        self.line(class, [start, foot]);
        let corners =
            [[-y, x], [y, -x]].map(|[x, y]| [foot[0] + x / 2.0, foot[1] + y / 2.0]);
        self.line(
            &format!("{class} head"),
            [corners[0], end, corners[1], corners[0]],
        );
    }

    /// Adds a rectangle with these opposite corners.
    fn rectangle(&mut self, class: &str, [[left, top], [right, bottom]]: [Point; 2]) {
        let corners = [[left, top], [right, top], [right, bottom], [left, bottom]];
        self.line(class, corners.into_iter().chain([[left, top]]));
    }

    fn circle(&mut self, class: &str, [x, y]: Point, radius: f64) {
        self.push(format_args!(
            "<circle class=\"{class}\" cx=\"{x:.1}\" cy=\"{y:.1}\" r=\"{radius:.1}\"/>"
        ));
    }

    /// Adds a line of text whose `anchor`, `start`, `middle` or `end`, is at a point.
    fn text(&mut self, class: &str, anchor: &str, [x, y]: Point, text: &str) {
        let text = escape(text);
        self.push(format_args!(
            "<text class=\"label {class}\" text-anchor=\"{anchor}\" x=\"{x:.1}\" y=\"{y:.1}\">{text}</text>"
        ));
    }

    fn push(&mut self, shape: std::fmt::Arguments) {
        writeln!(self.shapes, "{shape}").expect("a String takes everything");
    }

    fn html(&self) -> String {
        let [width, height] = self.size;
        format!(
            "<figure style=\"width: {width}px\">\n\
             <svg class=\"diagram\" width=\"{width}\" height=\"{height}\" viewBox=\"0 0 {width} {height}\" \
             role=\"img\" aria-label=\"{}\">\n{}</svg>\n\
             <figcaption>{}</figcaption>\n</figure>\n",
            escape(&self.description),
            self.shapes,
            escape(&self.caption),
        )
    }
}

/// Returns the linear map that takes the ends of `from` to those of `to`.
fn scale(from: [f64; 2], to: [f64; 2]) -> impl Fn(f64) -> f64 + Copy {
    move |x| to[0] + (x - from[0]) / (from[1] - from[0]) * (to[1] - to[0])
}

/// Returns a number with at most `digits` decimals, as we write it by hand.
fn number(x: f64, digits: usize) -> String {
    let text = format!("{x:.digits$}");
    let text = match text.split_once('.') {
        Some(_) => text.trim_end_matches('0').trim_end_matches('.'),
        None => &text,
    };
    if text == "-0" {
        "0".to_string()
    } else {
        text.replace('-', "−")
    }
}

#[cfg(test)]
mod a_drawing {
    use super::*;

    #[test]
    fn has_a_description_and_a_caption_for_each_panel_and_no_blank_line() {
        for (name, panels) in DRAWINGS {
            for panel in panels() {
                assert!(
                    panel.description.ends_with('.'),
                    "{name}: {}",
                    panel.description
                );
                assert!(!panel.caption.is_empty(), "{name}");
                // That would end Markdown's block of HTML.
                let html = panel.html();
                assert!(html.lines().all(|line| !line.trim().is_empty()), "{html}");
                assert!(!html.contains("NaN") && !html.contains("inf"), "{html}");
            }
        }
    }

    #[test]
    fn that_there_is_not_is_refused_by_the_names_of_those_there_are() {
        let problem = drawing("reflectanse").unwrap_err().to_string();
        assert!(names().all(|name| problem.contains(name)), "{problem}");
    }

    #[test]
    fn has_numbers_as_written_by_hand() {
        let written = [2.0, -1.25, 0.8, 1e-9, -1e-9, 100.0, 56.31].map(|x| number(x, 1));
        assert_eq!(written, ["2", "−1.2", "0.8", "0", "0", "100", "56.3"]);
    }
}
