//! The contents of a chart of a study's table: its lines, their styles, and the Pareto
//! front.

use crate::table::{Measurement, Table};
use std::collections::BTreeMap;

// ANCHOR: chart
/// One chart: two quantities against each other, on logarithmic axes.
pub struct Chart {
    /// Its title: what to see in it.
    pub title: &'static str,
    /// The scene whose measurements it shows.
    pub scene: &'static str,
    /// The horizontal axis.
    pub x: Axis,
    /// The vertical axis.
    pub y: Axis,
}

/// A quantity, and its label with the unit.
pub type Axis = (Quantity, &'static str);

/// A column of numbers in a study's table, as [`Measurement`] explains it.
#[derive(Clone, Copy, Debug, PartialEq)]
#[expect(missing_docs, reason = "they are the fields of `Measurement`")]
pub enum Quantity {
    Setting,
    Work,
    Max,
    Rms,
    Wrong,
    Ns,
}
// ANCHOR_END: chart

impl Quantity {
    /// Returns the number in this column of a row, or `None` if the cell is empty.
    pub fn of(self, row: &Measurement) -> Option<f64> {
        match self {
            Self::Setting => Some(row.setting),
            Self::Work => row.work,
            Self::Max => row.max,
            Self::Rms => row.rms,
            Self::Wrong => row.wrong,
            Self::Ns => row.ns,
        }
    }
}

/// A point of a chart: x and y.
pub type Point = (f64, f64);

/// The line of one method in a chart.
pub struct Line<'a> {
    /// The method's name.
    pub method: &'a str,
    /// A point for each setting, in the order of the table.
    pub points: Vec<Point>,
    /// These settings.
    pub settings: Vec<f64>,
}

impl Chart {
    /// Returns the chart of a scene, still without a title.
    pub const fn new(scene: &'static str, x: Axis, y: Axis) -> Self {
        let title = "";
        Self { title, scene, x, y }
    }

    /// Returns the chart with a title.
    pub const fn titled(self, title: &'static str) -> Self {
        Self { title, ..self }
    }

    /// Returns a line for each method, in the order of the table.
    pub fn lines<'a>(&self, table: &'a Table) -> Vec<Line<'a>> {
        let mut lines: Vec<Line> = Vec::new();
        for row in table.rows.iter().filter(|row| row.scene == self.scene) {
            let (Some(x), Some(y)) = (self.x.0.of(row), self.y.0.of(row)) else {
                continue;
            };
            let method = row.method.as_str();
            match lines.iter_mut().find(|line| line.method == method) {
                Some(line) => {
                    line.points.push((x, y));
                    line.settings.push(row.setting);
                }
                None => lines.push(Line {
                    method,
                    points: vec![(x, y)],
                    settings: vec![row.setting],
                }),
            }
        }
        lines
    }

    /// Returns whether x is a cost: then y is an error, and the front is drawn.
    pub const fn show_pareto_front(&self) -> bool {
        matches!(self.x.0, Quantity::Work | Quantity::Ns)
    }
}

// ANCHOR: front
/// Returns the Pareto front, from the left: the points that no other dominates in both x
/// and y.
pub fn pareto_front(points: impl IntoIterator<Item = Point>) -> Vec<Point> {
    let mut points: Vec<Point> = points.into_iter().collect();
    points.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.total_cmp(&b.1)));
    let mut least = None;
    points.retain(|&(_, y)| {
        let is_best = least.is_none_or(|least| y < least);
        least = if is_best { Some(y) } else { least };
        is_best
    });
    points
}
// ANCHOR_END: front

/// Returns the number of each method's colour and mark: the same in all charts, and another
/// for each method.
pub fn styles<'a>(charts: &[Chart], table: &'a Table) -> BTreeMap<&'a str, usize> {
    let mut styles = BTreeMap::new();
    for line in charts.iter().flat_map(|chart| chart.lines(table)) {
        let next = styles.len();
        styles.entry(line.method).or_insert(next);
    }
    styles
}
