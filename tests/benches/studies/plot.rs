//! A study's charts as one SVG, in the colours of the page that shows it.

#[path = "axis.rs"]
pub mod axis;

use axis::Axis;
use speed_and_accuracy::chart::{Chart, Line, Point, Quantity, pareto_front, styles};
use speed_and_accuracy::study::{Choice, Study};
use speed_and_accuracy::table::{Table, for_readers};
use std::iter::repeat_n;

/// The size of one chart; those of a study stand above each other.
const WIDTH: f64 = 800.0;
const HEIGHT: f64 = 300.0;
/// The plot within the chart, from left to right and from bottom to top.
const COLUMNS: [f64; 2] = [96.0, 634.0];
const ROWS: [f64; 2] = [244.0, 32.0];
/// The x of the methods' names, to the right of the plot, and the distance of their lines.
const NAMES: f64 = 674.0;
const LINE: f64 = 17.0;

/// The colours of text and axes, and of the grid: the page's, or those of a light page.
const INK: &str = "var(--chart-ink, #222222)";
const FAINT: &str = "var(--chart-faint, #cccccc)";
const PAPER: &str = "var(--bg, #ffffff)";

/// The methods' colours, and outlines of their marks about a point: colours alone are lost
/// in print, and on some eyes. After the last one they begin again, with hollow marks and
/// dashed lines.
const STYLES: [(&str, &str); 6] = [
    (
        "var(--chart-1, #1d64b4)",
        "m-4 0a4 4 0 1 0 8 0a4 4 0 1 0-8 0z",
    ),
    ("var(--chart-2, #c2570c)", "m-4-4h8v8h-8z"),
    ("var(--chart-3, #047857)", "m0-5l5 9h-10z"),
    ("var(--chart-4, #8b2fa0)", "m0-6l6 6-6 6-6-6z"),
    ("var(--chart-5, #8a6100)", "m-5-4h10l-5 9z"),
    ("var(--chart-6, #555555)", "m-2-6h4v12h-4z"),
];

/// Returns the charts above each other as an SVG. A method keeps its colour and its mark
/// in all of them.
#[must_use]
pub fn svg(study: &Study, table: &Table) -> String {
    let (charts, height) = (study.charts, HEIGHT * study.charts.len() as f64);
    let styles = styles(charts, table);
    let mut svg = vec![format!(
        "<svg class=\"chart\" role=\"img\" aria-label=\"{}\" width=\"{WIDTH}\" \
         height=\"{height}\" viewBox=\"0 0 {WIDTH} {height}\" fill=\"{INK}\" \
         font-family=\"sans-serif\" font-size=\"14\" xmlns=\"http://www.w3.org/2000/svg\">",
        escape(study.title)
    )];
    for (i, chart) in charts.iter().enumerate() {
        let top = HEIGHT * i as f64;
        svg.push(format!("<g transform=\"translate(0 {top})\">"));
        draw(
            &mut svg,
            chart,
            &chart.lines(table),
            study.chosen,
            |method| Style::of(styles[method]),
        );
        svg.push("</g>".to_string());
    }
    svg.push("</svg>\n".to_string());
    svg.join("\n")
}

/// How a method is drawn.
#[derive(Clone, Copy)]
struct Style {
    colour: &'static str,
    mark: &'static str,
    is_hollow: bool,
}

impl Style {
    fn of(number: usize) -> Self {
        let (colour, mark) = STYLES[number % STYLES.len()];
        Self {
            colour,
            mark,
            is_hollow: number >= STYLES.len(),
        }
    }

    /// Returns the marks about some points.
    fn marks(&self, points: &[Point], is_hollow: bool) -> String {
        let Self { colour, mark, .. } = self;
        let marks = points
            .iter()
            .map(|(x, y)| format!("M{x:.1} {y:.1}{mark}"))
            .collect::<String>();
        // What lies under a hollow mark does not show through.
        let fill = if is_hollow { PAPER } else { colour };
        format!("<path d=\"{marks}\" fill=\"{fill}\" stroke=\"{colour}\"/>")
    }
}

/// Returns a ring about a point, for what is chosen.
fn ring((x, y): Point) -> String {
    format!(
        "<circle cx=\"{x:.1}\" cy=\"{y:.1}\" r=\"9\" fill=\"none\" stroke=\"{INK}\"/>"
    )
}

fn draw(
    svg: &mut Vec<String>,
    chart: &Chart,
    lines: &[Line],
    chosen: &[Choice],
    style: impl Fn(&str) -> Style,
) {
    let points: Vec<Point> = lines.iter().flat_map(|line| line.points.clone()).collect();
    let (xs, ys): (Vec<f64>, Vec<f64>) = points.iter().copied().unzip();
    let (x, y) = (Axis::new(&xs, COLUMNS), Axis::new(&ys, ROWS));
    draw_frame(svg, chart, &x, &y);
    let position = |(right, up): Point| (x.position(right), y.position(up));
    if chart.show_pareto_front() {
        let front: Vec<Point> = pareto_front(points).into_iter().map(position).collect();
        // To the right until the next point is as cheap, then down to it.
        let corners = front
            .windows(2)
            .flat_map(|ends| [(ends[1].0, ends[0].1), ends[1]]);
        let steps = path(front.iter().copied().take(1).chain(corners));
        svg.push(format!(
            "<path d=\"{steps}\" fill=\"none\" stroke=\"{INK}\" stroke-dasharray=\"6 4\"/>"
        ));
    }
    let (mut names, mut labels, mut marks) = (Vec::new(), Vec::new(), Vec::new());
    for line in lines {
        let style = style(line.method);
        let is_number =
            |point: &Point| [point.0, point.1].iter().all(|x| *x > 0.0 && x.is_finite());
        // No line leads across a break.
        let runs = line.points.chunk_by(|a, b| is_number(a) && is_number(b));
        let runs = runs.map(|run| path(run.iter().copied().map(position)));
        let dashes = if style.is_hollow { "3 4" } else { "none" };
        svg.push(format!(
            "<path d=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"2\" \
             stroke-dasharray=\"{dashes}\"/>",
            runs.collect::<String>(),
            style.colour,
        ));
        let (numbers, others): (Vec<Point>, Vec<Point>) =
            line.points.iter().partition(|point| is_number(point));
        for (points, is_hollow) in [(numbers, style.is_hollow), (others, true)] {
            let positions: Vec<Point> = points.into_iter().map(position).collect();
            if !positions.is_empty() {
                svg.push(style.marks(&positions, is_hollow));
            }
        }
        let choice = chosen.iter().find(|choice| choice.method == line.method);
        let points = line.points.iter().copied().map(position);
        for (&setting, point) in line.settings.iter().zip(points) {
            if choice.is_some_and(|choice| choice.setting == Some(setting)) {
                svg.push(ring(point));
            }
            // Where an axis is the setting, it has its numbers there.
            if line.points.len() > 1 && chart.x.0 != Quantity::Setting {
                labels.push((point, setting));
            }
            marks.push(point);
        }
        let positions = line.points.iter().copied().map(position);
        let rightmost = positions.max_by(|a, b| a.0.total_cmp(&b.0));
        names.extend(rightmost.map(|end| (end, line.method, choice.is_some())));
    }
    draw_labels(svg, labels, &marks);
    names.sort_by(|((_, a), ..), ((_, b), ..)| a.total_cmp(b));
    let mut heights: Vec<f64> = names.iter().map(|((_, y), ..)| *y).collect();
    spread(&mut heights, LINE, ROWS[1], ROWS[0]);
    for (((x, y), method, is_chosen), height) in names.into_iter().zip(heights) {
        let style = style(method);
        let colour = style.colour;
        let lead = path([(x + 7.0, y), (NAMES - 20.0, height)]);
        let mark = (NAMES - 10.0, height);
        svg.push(format!(
            "<path d=\"{lead}\" fill=\"none\" stroke=\"{colour}\" stroke-opacity=\"0.6\"/>\n{}",
            style.marks(&[mark], style.is_hollow),
        ));
        let weight = if is_chosen { "bold" } else { "normal" };
        svg.extend(is_chosen.then(|| ring(mark)));
        svg.push(format!(
            "<g fill=\"{colour}\" font-weight=\"{weight}\">{}</g>",
            text((NAMES + 2.0, height), "start", method)
        ));
    }
}

/// Writes the setting above each point, unless a mark or another setting is in the way.
fn draw_labels(svg: &mut Vec<String>, labels: Vec<(Point, f64)>, marks: &[Point]) {
    let mut taken: Vec<[f64; 3]> = marks.iter().map(|&(x, y)| [x, y, 5.0]).collect();
    let mut written = Vec::new();
    for ((x, y), setting) in labels {
        let label = for_readers(setting);
        let (y, half_width) = (y - 13.0, 3.5 * label.chars().count() as f64);
        let is_free = taken.iter().all(|[other_x, other_y, other_half]| {
            (x - other_x).abs() > half_width + other_half || (y - other_y).abs() > 11.0
        });
        if is_free {
            taken.push([x, y, half_width]);
            written.push(text((x, y), "middle", &label));
        }
    }
    if !written.is_empty() {
        let written = written.join("\n");
        svg.push(format!("<g font-size=\"11\">\n{written}\n</g>"));
    }
}

/// The grid, the axes with their ticks and labels, and the title.
fn draw_frame(svg: &mut Vec<String>, chart: &Chart, x: &Axis, y: &Axis) {
    let ([left, right], [bottom, top]) = (COLUMNS, ROWS);
    let (mut grid, mut ticks, mut labels) = (Vec::new(), String::new(), Vec::new());
    let mut line = |x1, y1, x2, y2| {
        grid.push(format!(
            "<line x1=\"{x1:.1}\" y1=\"{y1:.1}\" x2=\"{x2:.1}\" y2=\"{y2:.1}\"/>"
        ));
    };
    for (label, x) in x.ticks() {
        line(x, bottom, x, top);
        ticks += &format!("M{x:.1} {bottom}v8");
        labels.push(text((x, bottom + 20.0), "middle", &label));
    }
    for (label, y) in y.ticks() {
        line(left, y, right, y);
        ticks += &format!("M{left} {y:.1}h-8");
        labels.push(text((left - 13.0, y), "end", &label));
    }
    // Two strokes across the axis.
    for x in x.breaks() {
        ticks += &format!("M{:.1} {}l4-10m4 0l-4 10", x - 4.0, bottom + 5.0);
    }
    for y in y.breaks() {
        ticks += &format!("M{} {:.1}l10-4m0 4l-10 4", left - 5.0, y);
    }
    let middle = (left + right) / 2.0;
    svg.push(format!(
        "<g stroke=\"{FAINT}\" stroke-dasharray=\"1 3\">\n{}\n</g>\n\
         <path d=\"M{left} {top}V{bottom}H{right}{ticks}\" fill=\"none\" stroke=\"{INK}\"/>\n\
         {}\n<g font-weight=\"bold\">{}</g>\n{}\n<g transform=\"rotate(-90)\">{}</g>",
        grid.join("\n"),
        labels.join("\n"),
        text((left, 14.0), "start", chart.title),
        text((middle, bottom + 40.0), "middle", chart.x.1),
        text((-(top + bottom) / 2.0, 14.0), "middle", chart.y.1),
    ));
}

fn text((x, y): Point, anchor: &str, text: &str) -> String {
    let text = escape(text);
    format!(
        "<text x=\"{x:.1}\" y=\"{y:.1}\" dy=\".35em\" text-anchor=\"{anchor}\">{text}</text>"
    )
}

fn path(points: impl IntoIterator<Item = Point>) -> String {
    let points = points
        .into_iter()
        .zip(std::iter::once('M').chain(repeat_n('L', usize::MAX)));
    points
        .map(|((x, y), to)| format!("{to}{x:.1} {y:.1}"))
        .collect()
}

fn escape(text: &str) -> String {
    text.replace('&', "&amp;")
        .replace('<', "&lt;")
        .replace('"', "&quot;")
}

/// Moves heights, in ascending order, apart by at least `gap`, each as little as the
/// others let it, and all of them to between `top` and `bottom` if there is room.
pub fn spread(heights: &mut [f64], gap: f64, top: f64, bottom: f64) {
    // Less their gaps they need only ascend; those that do not are a run, at its mean.
    let mut runs: Vec<(f64, usize)> = Vec::new();
    for (i, &height) in heights.iter().enumerate() {
        let mut run = (height - i as f64 * gap, 1);
        while let Some((mean, count)) = runs.pop_if(|(mean, _)| *mean > run.0) {
            let sum = mean * count as f64 + run.0 * run.1 as f64;
            run = (sum / (count + run.1) as f64, count + run.1);
        }
        runs.push(run);
    }
    let bottom = bottom - heights.len().saturating_sub(1) as f64 * gap;
    let means = runs.iter().flat_map(|&(mean, count)| repeat_n(mean, count));
    for (i, (height, mean)) in heights.iter_mut().zip(means).enumerate() {
        *height = mean.min(bottom).max(top) + i as f64 * gap;
    }
}
