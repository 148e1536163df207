//! A study's table as charts: for the book as SVG in its theme's colours, for the window
//! as pixels.

use crate::study::{Measurement, Table};
use plotters::coord::Shift;
use plotters::coord::ranged1d::{
    KeyPointHint, NoDefaultFormatting, Ranged, ValueFormatter,
};
use plotters::element::PathElement;
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};
use plotters::style::{FontStyle, RGBColor, register_font};
use std::sync::Once;

/// One chart: two quantities against each other, on logarithmic axes.
pub struct Chart {
    /// What to see in it.
    pub title: &'static str,
    /// Whose measurements it shows.
    pub scene: &'static str,
    /// To the right.
    pub x: Axis,
    /// Up.
    pub y: Axis,
    /// Whether x and y are cost and error: then the Pareto front is drawn, beyond which
    /// no method gets.
    pub front: bool,
}

/// A quantity, and what a study calls it.
pub struct Axis {
    /// The column of the table.
    pub quantity: Quantity,
    /// Its name and unit.
    pub label: &'static str,
}

impl Axis {
    /// An axis in a line.
    #[must_use]
    pub const fn new(quantity: Quantity, label: &'static str) -> Self {
        Self { quantity, label }
    }
}

/// A column of a study's table.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Quantity {
    /// The knob's setting.
    Setting,
    /// Rays or operations.
    Work,
    /// The largest error.
    Max,
    /// The RMS error.
    Rms,
    /// Wrong decisions, in percent.
    Wrong,
    /// Nanoseconds.
    Ns,
}

impl Quantity {
    fn of(self, row: &Measurement) -> Option<f64> {
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

/// A chart's width, and the height of each of those that stand above each other.
const WIDTH: u32 = 800;
const HEIGHT: u32 = 300;
/// The room for the methods' names, to the right of the axes.
const NAMES: u32 = 165;
const FONT: &str = "sans-serif";
/// The size of all letters, and the least distance of two names' lines.
const LETTERS: f64 = 17.0;
const LINE: i32 = 17;

struct Palette {
    paper: Option<RGBColor>,
    ink: RGBColor,
    faint: RGBColor,
    methods: [RGBColor; 6],
    /// A raised minus sign.
    minus: char,
}

/// Stands in for the colours of the theme, which a page knows and we do not.
const THEME: Palette = Palette {
    paper: None,
    ink: RGBColor(1, 1, 1),
    faint: RGBColor(1, 1, 2),
    methods: [
        RGBColor(1, 2, 1),
        RGBColor(1, 2, 2),
        RGBColor(1, 2, 3),
        RGBColor(1, 2, 4),
        RGBColor(1, 2, 5),
        RGBColor(1, 2, 6),
    ],
    minus: '⁻',
};

/// The window's; those of a light page.
const PAPER: Palette = Palette {
    paper: Some(WHITE),
    ink: RGBColor(0x22, 0x22, 0x22),
    faint: RGBColor(0xcc, 0xcc, 0xcc),
    methods: [
        RGBColor(0x1d, 0x64, 0xb4),
        RGBColor(0xc2, 0x57, 0x0c),
        RGBColor(0x04, 0x78, 0x57),
        RGBColor(0x8b, 0x2f, 0xa0),
        RGBColor(0x8a, 0x61, 0x00),
        RGBColor(0x55, 0x55, 0x55),
    ],
    // A macron: our font has no ⁻.
    minus: '¯',
};

/// The charts above each other as an SVG, whose colours are the variables `--chart-ink`,
/// `--chart-faint` and `--chart-1` to `--chart-6` of the page that shows it.
#[must_use]
pub fn svg(title: &str, charts: &[Chart], table: &Table) -> String {
    let size = (WIDTH, HEIGHT * charts.len() as u32);
    let mut svg = String::new();
    let area = SVGBackend::with_string(&mut svg, size).into_drawing_area();
    draw_all(&area, charts, table, &THEME, 1.0);
    drop(area);
    let mut colours = vec![
        (THEME.ink, PAPER.ink, "ink".to_string()),
        (THEME.faint, PAPER.faint, "faint".to_string()),
    ];
    let methods = THEME.methods.into_iter().zip(PAPER.methods);
    colours.extend(
        (1..)
            .zip(methods)
            .map(|(i, (stand_in, own))| (stand_in, own, i.to_string())),
    );
    for (stand_in, own, name) in colours {
        let variable = format!("\"var(--chart-{name}, {})\"", hex(own));
        svg = svg.replace(&format!("\"{}\"", hex(stand_in)), &variable);
    }
    let label = title.replace('&', "&amp;").replace('"', "&quot;");
    svg.replacen(
        "<svg ",
        &format!("<svg class=\"chart\" role=\"img\" aria-label=\"{label}\" "),
        1,
    )
}

fn hex(RGBColor(r, g, b): RGBColor) -> String {
    format!("#{r:02X}{g:02X}{b:02X}")
}

/// The charts above each other as pixels, row by row from the top: width, height, levels.
#[must_use]
pub fn pixels(charts: &[Chart], table: &Table) -> (u32, u32, Vec<u8>) {
    // Twice as many as the window has, for smooth letters.
    let [width, height] = [2 * WIDTH, 2 * HEIGHT * charts.len() as u32];
    let mut levels = vec![0; 3 * width as usize * height as usize];
    let area =
        BitMapBackend::with_buffer(&mut levels, (width, height)).into_drawing_area();
    draw_all(&area, charts, table, &PAPER, 2.0);
    drop(area);
    (width, height, levels)
}

type Area<B> = DrawingArea<B, Shift>;

fn draw_all<B: DrawingBackend>(
    area: &Area<B>,
    charts: &[Chart],
    table: &Table,
    palette: &Palette,
    scale: f64,
) {
    // Without it, nothing is known of the letters' widths.
    static REGISTERED: Once = Once::new();
    REGISTERED.call_once(|| {
        let font = epaint_default_fonts::UBUNTU_LIGHT;
        assert!(
            register_font(FONT, FontStyle::Normal, font).is_ok(),
            "a font"
        );
    });
    if let Some(paper) = palette.paper {
        area.fill(&paper)
            .unwrap_or_else(|_| unreachable!("memory takes everything"));
    }
    for (chart, area) in charts.iter().zip(area.split_evenly((charts.len(), 1))) {
        chart
            .draw(&area, table, palette, scale)
            .unwrap_or_else(|error| unreachable!("memory takes everything: {error}"));
    }
}

/// A logarithmic axis.
#[derive(Clone)]
struct Logarithmic {
    /// The decimal logarithms of its ends.
    from: f64,
    to: f64,
    /// Whether the lower end stands for 0, which has no logarithm.
    has_zero: bool,
    /// Whether the upper end stands for infinity.
    has_infinity: bool,
    /// A raised minus sign.
    minus: char,
}

impl Logarithmic {
    /// Holds all the values, and ends at whole decades, or a little beyond what is less
    /// than one.
    fn of(values: impl Iterator<Item = f64> + Clone, minus: char) -> Self {
        let has_zero = values.clone().any(|value| value == 0.0);
        let has_infinity = values.clone().any(f64::is_infinite);
        let places = values
            .filter(|&value| value > 0.0 && value.is_finite())
            .map(logarithm);
        let mut places: Vec<f64> = places.collect();
        places.sort_by(f64::total_cmp);
        let (from, to) = match places[..] {
            [] => (0.0, 1.0),
            [from, .., to] if to - from > 1.0 => {
                ((from + 0.01).floor(), (to - 0.01).ceil())
            }
            [from, ..] => (from - 0.1, places[places.len() - 1] + 0.1),
        };
        let from = if has_zero { (from - 0.5).floor() } else { from };
        let to = if has_infinity { (to + 0.5).ceil() } else { to };
        Self {
            from,
            to,
            has_zero,
            has_infinity,
            minus,
        }
    }
}

#[expect(clippy::disallowed_methods, reason = "a place in a chart")]
fn logarithm(value: f64) -> f64 {
    value.log10()
}

#[expect(clippy::disallowed_methods, reason = "a tick in a chart")]
fn power_of_ten(exponent: i32) -> f64 {
    10.0_f64.powi(exponent)
}

impl Ranged for Logarithmic {
    type FormatOption = NoDefaultFormatting;
    type ValueType = f64;

    /// What is beyond an end, 0 or infinite, is drawn there.
    fn map(&self, &value: &f64, (start, end): (i32, i32)) -> i32 {
        let part = (logarithm(value) - self.from) / (self.to - self.from);
        start + (part.clamp(0.0, 1.0) * f64::from(end - start)).round() as i32
    }

    /// Powers of ten, no more than nine; or 1, 2 and 5 of each; or 1 to 9, and 1.5.
    fn key_points<Hint: KeyPointHint>(&self, _: Hint) -> Vec<f64> {
        let decades = self.from.floor() as i32..=self.to.ceil() as i32;
        let step = ((self.to - self.from) / 8.0).ceil() as i32;
        let ticks: Vec<f64> = if self.to - self.from > 2.0 {
            decades
                .filter(|decade| decade % step == 0)
                .map(power_of_ten)
                .collect()
        } else {
            let is_short = self.to - self.from < 0.7;
            let digits: &[f64] = if is_short {
                &[1.0, 1.5, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 9.0]
            } else {
                &[1.0, 2.0, 5.0]
            };
            let of_one =
                |decade| digits.iter().map(move |digit| digit * power_of_ten(decade));
            decades.flat_map(of_one).collect()
        };
        let [mut from, mut to] = [self.from - 1e-9, self.to + 1e-9];
        let mut shown = Vec::new();
        if self.has_zero {
            shown.push(0.0);
            from += 0.6;
        }
        if self.has_infinity {
            shown.push(f64::INFINITY);
            to -= 0.6;
        }
        let is_shown = |&tick: &f64| (from..=to).contains(&logarithm(tick));
        shown.extend(ticks.into_iter().filter(is_shown));
        shown
    }

    fn range(&self) -> std::ops::Range<f64> {
        0.0..f64::INFINITY
    }
}

impl ValueFormatter<f64> for Logarithmic {
    /// `0.001` to `10000`, `10⁵` or `2·10⁵` beyond.
    fn format_ext(&self, &value: &f64) -> String {
        // Without the digits that are only rounding.
        let rounded: f64 = format!("{value:.3e}").parse().expect("a number");
        if value == 0.0 || (9e-4..2e4).contains(&value) {
            return rounded.to_string();
        }
        if value.is_infinite() {
            return "∞".to_string();
        }
        let rounded = format!("{rounded:e}");
        let (digit, exponent) = rounded.split_once('e').expect("it has an exponent");
        let times = if digit == "1" {
            String::new()
        } else {
            format!("{digit}·")
        };
        let raised = |c: char| match c.to_digit(10) {
            Some(digit) => {
                ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹'][digit as usize]
            }
            None => self.minus,
        };
        format!(
            "{times}10{}",
            exponent.chars().map(raised).collect::<String>()
        )
    }
}

/// What a chart shows of one method, in the order of its settings.
struct Line<'a> {
    method: &'a str,
    points: Vec<(f64, f64)>,
}

impl Chart {
    /// The methods on the Pareto front, from the cheapest on.
    #[must_use]
    pub fn best<'a>(&self, table: &'a Table) -> Vec<&'a str> {
        let lines = self.lines(table);
        let all = lines.iter().flat_map(|line| &line.points).copied();
        let mut best = Vec::new();
        for point in front(all.collect()) {
            let on_it = lines.iter().filter(|line| line.points.contains(&point));
            for line in on_it {
                if !best.contains(&line.method) {
                    best.push(line.method);
                }
            }
        }
        best
    }

    fn lines<'a>(&self, table: &'a Table) -> Vec<Line<'a>> {
        let mut lines: Vec<Line> = Vec::new();
        for row in table.rows.iter().filter(|row| row.scene == self.scene) {
            let (Some(x), Some(y)) = (self.x.quantity.of(row), self.y.quantity.of(row))
            else {
                continue;
            };
            match lines.iter_mut().find(|line| line.method == row.method) {
                Some(line) => line.points.push((x, y)),
                None => lines.push(Line {
                    method: &row.method,
                    points: vec![(x, y)],
                }),
            }
        }
        lines
    }

    fn draw<B: DrawingBackend>(
        &self,
        area: &Area<B>,
        table: &Table,
        palette: &Palette,
        scale: f64,
    ) -> Result<(), DrawingAreaErrorKind<B::ErrorType>> {
        let lines = self.lines(table);
        let points = lines.iter().flat_map(|line| &line.points);
        let x = Logarithmic::of(points.clone().map(|point| point.0), palette.minus);
        let y = Logarithmic::of(points.map(|point| point.1), palette.minus);
        let scaled = |length: f64| (length * scale) as i32;
        let font = |colour: RGBColor| (FONT, LETTERS * scale).into_font().color(&colour);

        let mut chart = ChartBuilder::on(area)
            .caption(self.title, font(palette.ink))
            .margin(scaled(8.0))
            .margin_right(scaled(f64::from(NAMES)))
            .x_label_area_size(scaled(48.0))
            .y_label_area_size(scaled(76.0))
            .build_cartesian_2d(x, y)?;
        chart
            .configure_mesh()
            .x_desc(self.x.label)
            .y_desc(self.y.label)
            .axis_desc_style(font(palette.ink))
            .label_style(font(palette.ink))
            .axis_style(palette.ink)
            .bold_line_style(palette.faint)
            .light_line_style(TRANSPARENT)
            // Longer than a mark at the axis is wide.
            .set_all_tick_mark_size(scaled(8.0))
            .draw()?;

        if self.front {
            let all = lines.iter().flat_map(|line| &line.points).copied();
            let steps = staircase(&front(all.collect()));
            let dashes = DashedLineSeries::new(
                steps,
                scaled(6.0),
                scaled(4.0),
                palette.ink.stroke_width(scaled(1.0) as u32),
            );
            chart.draw_series(dashes)?;
        }
        let mut names = Vec::new();
        for (i, line) in lines.iter().enumerate() {
            let colour = palette.methods[i % palette.methods.len()];
            let stroke = colour.stroke_width(scaled(2.0) as u32);
            // One by one: in one piece, a sharp bend would grow a spike in pixels.
            let segments = line.points.windows(2);
            chart.draw_series(segments.map(|ends| PathElement::new(ends, stroke)))?;
            for point in &line.points {
                let place = chart.backend_coord(point);
                mark(area, i, place, scaled(4.0), colour)?;
            }
            let rightmost = line
                .points
                .iter()
                .copied()
                .reduce(|a, b| if b.0 >= a.0 { b } else { a });
            let last = rightmost.expect("a line has points");
            names.push((chart.backend_coord(&last), line.method, colour));
        }

        // The names, as near to their lines' ends as they find room.
        names.sort_by_key(|&((_, y), ..)| y);
        let (_, plot) = chart.plotting_area().get_pixel_range();
        let line_height = LINE * scaled(1.0);
        let mut heights: Vec<i32> = names.iter().map(|&((_, y), ..)| y).collect();
        spread(&mut heights, line_height, plot.start, plot.end);
        let (columns, _) = chart.plotting_area().get_pixel_range();
        let left = columns.end + scaled(26.0);
        let (origin_x, origin_y) = area.get_base_pixel();
        for (&((x, y), name, colour), &height) in names.iter().zip(&heights) {
            let [from, to] = [(x + scaled(6.0), y), (left - scaled(4.0), height)]
                .map(|(x, y)| (x - origin_x, y - origin_y));
            area.draw(&PathElement::new([from, to], colour.mix(0.8)))?;
            let style = font(colour).pos(Pos::new(HPos::Left, VPos::Center));
            area.draw(&Text::new(
                name,
                (left - origin_x, height - origin_y),
                style,
            ))?;
        }
        Ok(())
    }
}

/// A mark of its own for each method: colours alone are lost in print, and on some eyes.
fn mark<B: DrawingBackend>(
    area: &Area<B>,
    method: usize,
    (x, y): (i32, i32),
    radius: i32,
    colour: RGBColor,
) -> Result<(), DrawingAreaErrorKind<B::ErrorType>> {
    let (left, top) = area.get_base_pixel();
    let centre = (x - left, y - top);
    let corner = |x: i32, y: i32| (centre.0 + x * radius / 4, centre.1 + y * radius / 4);
    let fill = colour.filled();
    let polygon = |corners: &[(i32, i32)]| {
        area.draw(&Polygon::new(
            corners
                .iter()
                .map(|&(x, y)| corner(x, y))
                .collect::<Vec<_>>(),
            fill,
        ))
    };
    match method % 6 {
        0 => area.draw(&Circle::new(centre, radius, fill)),
        1 => polygon(&[(-4, -4), (4, -4), (4, 4), (-4, 4)]),
        2 => polygon(&[(0, -5), (5, 4), (-5, 4)]),
        3 => polygon(&[(0, -6), (6, 0), (0, 6), (-6, 0)]),
        4 => polygon(&[(-5, -4), (5, -4), (0, 5)]),
        _ => polygon(&[(-2, -6), (2, -6), (2, 6), (-2, 6)]),
    }
}

/// The points that no other beats in both x and y, from the left.
fn front(mut points: Vec<(f64, f64)>) -> Vec<(f64, f64)> {
    points.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.total_cmp(&b.1)));
    let mut front: Vec<(f64, f64)> = Vec::new();
    for point in points {
        if front.last().is_none_or(|last| point.1 < last.1) {
            front.push(point);
        }
    }
    front
}

/// The border of all that the points of a front beat: from each to the right, then down
/// to the next.
fn staircase(front: &[(f64, f64)]) -> Vec<(f64, f64)> {
    let mut steps = Vec::new();
    for (i, &point) in front.iter().enumerate() {
        if i > 0 {
            steps.push((point.0, front[i - 1].1));
        }
        steps.push(point);
    }
    steps
}

/// Moves heights, in ascending order, apart by at least `line`, within `top` and `bottom`
/// if they fit.
fn spread(heights: &mut [i32], line: i32, top: i32, bottom: i32) {
    let mut least = top;
    for height in heights.iter_mut() {
        *height = (*height).max(least);
        least = *height + line;
    }
    let mut most = bottom;
    for height in heights.iter_mut().rev() {
        *height = (*height).min(most);
        most = *height - line;
    }
}
