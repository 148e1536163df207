//! A study's charts as one SVG, in the colours of the page that shows it.

#[path = "axis.rs"]
pub mod axis;

use axis::Axis;
use speed_and_accuracy::chart::{Chart, Line, Point, pareto_front, styles};
use speed_and_accuracy::table::Table;
use std::iter::repeat_n;

/// The size of one chart; those of a study stand above each other.
const WIDTH: f64 = 800.0;
const HEIGHT: f64 = 300.0;
/// The plot within the chart, from left to right and from bottom to top.
const COLUMNS: [f64; 2] = [84.0, 634.0];
const ROWS: [f64; 2] = [244.0, 32.0];
/// The x of the methods' names, to the right of the plot, and the distance of their lines.
const NAMES: f64 = 674.0;
const LINE: f64 = 17.0;

/// The colours of text and axes, and of the grid: the page's, or those of a light page.
const INK: &str = "var(--chart-ink, #222222)";
const FAINT: &str = "var(--chart-faint, #cccccc)";

/// The methods' colours, and outlines of their marks about a point: colours alone are lost
/// in print, and on some eyes.
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
pub fn svg(title: &str, charts: &[Chart], table: &Table) -> String {
    let (styles, height) = (styles(charts, table), HEIGHT * charts.len() as f64);
    let mut svg = vec![format!(
        "<svg class=\"chart\" role=\"img\" aria-label=\"{}\" width=\"{WIDTH}\" \
         height=\"{height}\" viewBox=\"0 0 {WIDTH} {height}\" fill=\"{INK}\" \
         font-family=\"sans-serif\" font-size=\"14\" xmlns=\"http://www.w3.org/2000/svg\">",
        escape(title)
    )];
    for (i, chart) in charts.iter().enumerate() {
        let top = HEIGHT * i as f64;
        svg.push(format!("<g transform=\"translate(0 {top})\">"));
        draw(&mut svg, chart, &chart.lines(table), |method| {
            STYLES[styles[method] % STYLES.len()]
        });
        svg.push("</g>".to_string());
    }
    svg.push("</svg>\n".to_string());
    svg.join("\n")
}

type Style = (&'static str, &'static str);

fn draw(
    svg: &mut Vec<String>,
    chart: &Chart,
    lines: &[Line],
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
    let mut names = Vec::new();
    for line in lines {
        let (colour, mark) = style(line.method);
        let positions: Vec<Point> = line.points.iter().copied().map(position).collect();
        let marks = positions
            .iter()
            .map(|&(x, y)| format!("M{x:.1} {y:.1}{mark}"));
        svg.push(format!(
            "<path d=\"{}\" fill=\"none\" stroke=\"{colour}\" stroke-width=\"2\"/>\n\
             <path d=\"{}\" fill=\"{colour}\"/>",
            path(positions.iter().copied()),
            marks.collect::<String>(),
        ));
        let rightmost = positions.into_iter().max_by(|a, b| a.0.total_cmp(&b.0));
        names.extend(rightmost.map(|end| (end, line.method)));
    }
    names.sort_by(|((_, a), _), ((_, b), _)| a.total_cmp(b));
    let mut heights: Vec<f64> = names.iter().map(|((_, y), _)| *y).collect();
    spread(&mut heights, LINE, ROWS[1], ROWS[0]);
    for (((x, y), method), height) in names.into_iter().zip(heights) {
        let (colour, mark) = style(method);
        let lead = path([(x + 7.0, y), (NAMES - 18.0, height)]);
        svg.push(format!(
            "<path d=\"{lead}\" fill=\"none\" stroke=\"{colour}\" stroke-opacity=\"0.6\"/>\n\
             <path d=\"M{:.1} {height:.1}{mark}\" fill=\"{colour}\"/>\n\
             <g fill=\"{colour}\">{}</g>",
            NAMES - 10.0,
            text((NAMES, height), "start", method)
        ));
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
