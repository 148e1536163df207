//! The contents of charts, and their positions.

use crate::plot::axis::Axis;
use crate::plot::{spread, svg};
use harness::cases;
use proptest::prelude::*;
use speed_and_accuracy::STUDIES;
use speed_and_accuracy::chart::{Chart, Point, Quantity, pareto_front, styles};
use speed_and_accuracy::study::{Choice, Study};
use speed_and_accuracy::table::{Measurement, Table};

/// A chart of RMS errors against nanoseconds.
const fn chart(scene: &'static str) -> Chart {
    Chart::new(scene, (Quantity::Ns, "ns"), (Quantity::Rms, "RMS, < 1"))
        .titled("Fast & exact")
}

/// A row for each scene, method, time and error.
fn table(rows: &[(&str, &str, f64, f64)]) -> Table {
    let row = |&(scene, method, ns, rms): &(&str, &str, f64, f64)| Measurement {
        ns: Some(ns),
        rms: Some(rms),
        ..Measurement::of(scene, method, 0.0)
    };
    Table {
        rows: rows.iter().map(row).collect(),
        ..Table::default()
    }
}

/// The page's own example: D costs more than B and is less exact, E than C.
#[test]
fn the_front_is_what_no_other_beats() {
    let [a, b, c, d, e] = [(16, 15), (28, 8), (43, 2), (34, 13), (51, 6)]
        .map(|(x, y)| (f64::from(x), f64::from(y)));
    assert_eq!(pareto_front([d, c, e, a, b]), [a, b, c]);
    assert_eq!(pareto_front([]), []);
    // As exact for more, or less exact for as much, is beaten.
    assert_eq!(
        pareto_front([(2.0, 1.0), (1.0, 1.0), (1.0, 3.0)]),
        [(1.0, 1.0)]
    );
    let lost = (1.0, f64::INFINITY);
    assert_eq!(pareto_front([(2.0, f64::INFINITY), lost]), [lost]);
}

proptest! {
    #![proptest_config(cases(256))]

    /// A point is on the front if and only if no other is at least as good in both.
    #[test]
    fn the_front_is_that_of_comparing_all_pairs(
        points in prop::collection::btree_set((0..20_u8, 0..20_u8), 0..30)
    ) {
        let points: Vec<Point> =
            points.into_iter().map(|(x, y)| (f64::from(x), f64::from(y))).collect();
        let is_beaten =
            |a: &Point| points.iter().any(|b| b != a && b.0 <= a.0 && b.1 <= a.1);
        let best: Vec<Point> = points.iter().copied().filter(|p| !is_beaten(p)).collect();
        prop_assert_eq!(pareto_front(points.clone()), best);
    }

    /// Names never overlap, stay within the plot, keep their order, and no pair that is far
    /// enough apart is moved for nothing.
    #[test]
    fn names_are_spread(heights in prop::collection::vec(30.0..240.0_f64, 0..7)) {
        let mut heights = heights;
        heights.sort_by(f64::total_cmp);
        let mut moved = heights.clone();
        spread(&mut moved, 17.0, 30.0, 240.0);
        for pair in moved.windows(2) {
            prop_assert!(pair[1] - pair[0] >= 17.0 - 1e-9, "{:?} to {:?}", heights, moved);
        }
        prop_assert!(moved.iter().all(|height| (30.0..=240.0).contains(height)));
        if heights.windows(2).all(|pair| pair[1] - pair[0] >= 17.0) {
            let within = |(a, b): (&f64, &f64)| (a - b).abs() < 1e-9;
            prop_assert!(heights.iter().zip(&moved).all(within));
        }
    }
}

/// Three at one position: the one in the middle stays.
#[test]
fn names_are_moved_as_little_as_can_be() {
    let mut heights = [50.0, 100.0, 100.0, 100.0, 200.0];
    spread(&mut heights, 10.0, 0.0, 210.0);
    assert_eq!(heights, [50.0, 90.0, 100.0, 110.0, 200.0]);
    // At the edge they go as far as it lets them.
    let mut heights = [200.0, 200.0];
    spread(&mut heights, 10.0, 0.0, 200.0);
    assert_eq!(heights, [190.0, 200.0]);
}

/// Also "d", which is in the second chart alone, and "a", which is not there.
#[test]
fn a_method_looks_the_same_in_all_charts_and_like_no_other() {
    let charts = [chart("first"), chart("second")];
    let of_first = ["a", "b", "c"].map(|method| ("first", method, 1.0, 1.0));
    let of_second = ["d", "c", "b"].map(|method| ("second", method, 1.0, 1.0));
    let table = table(&[of_first, of_second].concat());
    let styles = styles(&charts, &table);
    let expected = [("a", 0), ("b", 1), ("c", 2), ("d", 3)];
    assert!(styles.into_iter().eq(expected));
}

/// Six colours and six marks, and after these as many with hollow marks.
#[test]
fn no_study_has_more_methods_than_there_are_styles() {
    for study in STUDIES {
        let table = study.table().expect("a table");
        let styles = styles(study.charts, &table).len();
        assert!(styles <= 12, "{}: {styles} methods", study.name);
    }
}

#[test]
fn zero_and_infinity_are_apart_from_the_numbers() {
    let values = [0.0, 1e-3, 10.0, f64::INFINITY];
    for (ends, sign) in [([100.0, 300.0], 1.0), ([300.0, 100.0], -1.0)] {
        let axis = Axis::new(&values, ends);
        let [zero, least, most, infinity] = values.map(|x| sign * axis.position(x));
        assert!(least - zero >= 35.9, "0 at {zero}, 0.001 at {least}");
        assert!(infinity - most >= 35.9, "∞ at {infinity}, 10 at {most}");
        let breaks: Vec<f64> = axis.breaks().map(|x| sign * x).collect();
        assert!(zero < breaks[0] && breaks[0] < least, "{breaks:?}");
        assert!(most < breaks[1] && breaks[1] < infinity, "{breaks:?}");
        let ticks = axis.ticks();
        let labels: Vec<&str> = ticks.iter().map(|(label, _)| label.as_str()).collect();
        assert_eq!(labels, ["0", "∞", "0.001", "0.01", "0.1", "1", "10"]);
        // Each power of ten as far from the last as that from the one before.
        let step = ticks[3].1 - ticks[2].1;
        for pair in ticks[2..].windows(2) {
            assert!((pair[1].1 - pair[0].1 - step).abs() < 1e-9);
        }
    }
    assert_eq!(Axis::new(&[1.0, 5.0], [100.0, 300.0]).breaks().count(), 0);
}

#[test]
fn ticks_are_many_where_the_axis_is_short_and_few_where_it_is_long() {
    let labels = |values: &[f64]| -> String {
        let ticks = Axis::new(values, [0.0, 1.0]).ticks();
        ticks
            .into_iter()
            .map(|(label, _)| label)
            .collect::<Vec<_>>()
            .join(" ")
    };
    assert_eq!(labels(&[9.0, 15.0]), "8 9 10 15");
    assert_eq!(labels(&[3e-5, 2e-4]), "5·10⁻⁵ 10⁻⁴ 2·10⁻⁴");
    assert_eq!(labels(&[1.0, 16.0]), "1 2 5 10 20");
    assert_eq!(labels(&[0.6, 8.0]), "0.5 1 2 5 10");
    assert_eq!(labels(&[1.0, 300.0]), "1 10 100 1,000");
    assert_eq!(labels(&[1e-12, 1e6]), "10⁻¹² 10⁻⁹ 10⁻⁶ 0.001 1 1,000 10⁶");
    assert_eq!(labels(&[0.0]), "0 1 2 5 10");
    assert_eq!(labels(&[]), "1 2 5 10");
}

/// Returns a study of one chart, that of the scene "s".
fn study(charts: &'static [Chart]) -> Study {
    Study {
        name: "",
        title: "“x” \"y\" & z",
        measure: |_| Vec::new(),
        chosen: &CHOSEN,
        charts,
    }
}

static CHARTS: [Chart; 1] = [chart("s")];
static CHOSEN: [Choice; 1] = [Choice::at("c", 0.5)];

/// The browser's parser is not asked: what would end a tag or a text is not there.
#[test]
fn words_are_escaped_and_nothing_is_infinite() {
    let rows = [("s", "a<b", 1.0, 0.0), ("s", "c", 3.0, f64::INFINITY)];
    let svg = svg(&study(&CHARTS), &table(&rows));
    assert!(
        svg.contains("aria-label=\"“x” &quot;y&quot; &amp; z\""),
        "{svg}"
    );
    for text in [
        ">a&lt;b<",
        ">Fast &amp; exact<",
        ">RMS, &lt; 1<",
        ">∞<",
        ">0<",
    ] {
        assert!(svg.contains(text), "no {text} in {svg}");
    }
    assert!(!svg.contains("inf") && !svg.contains("NaN"), "{svg}");
    let dashed = svg.matches("stroke-dasharray=\"6 4\"").count();
    assert_eq!(dashed, 1, "the front, once");
}

/// Two methods of three settings each: the second setting of the second method is chosen.
#[test]
fn the_chosen_method_and_setting_are_marked() {
    let row = |method, setting, ns| Measurement {
        ns: Some(ns),
        rms: Some(1.0 / ns),
        ..Measurement::of("s", method, setting)
    };
    let settings = [0.25, 0.5, 1.0];
    let of =
        |method, factor| settings.map(|setting| row(method, setting, factor * setting));
    let rows = [of("a", 10.0), of("c", 1000.0)].concat();
    let table = Table {
        rows,
        ..Table::default()
    };
    let svg = svg(&study(&CHARTS), &table);
    // Around the point, and around the mark beside the name.
    assert_eq!(svg.matches("<circle").count(), 2, "{svg}");
    let bold = svg.split("font-weight=\"bold\"").skip(1);
    let bold: Vec<&str> = bold.filter_map(|rest| rest.split("</g>").next()).collect();
    assert!(bold.iter().any(|text| text.contains(">c<")), "{bold:?}");
    assert!(!bold.iter().any(|text| text.contains(">a<")), "{bold:?}");
    for setting in ["0.25", "0.5", "1"] {
        let labels = svg.matches(&format!(">{setting}</text>")).count();
        assert!(labels >= 2, "{labels} labels of {setting}");
    }
}

/// The middle point is 0: no line leads to it, and its mark is hollow.
#[test]
fn no_line_leads_across_a_break() {
    let points = [
        ("s", "a", 1.0, 2.0),
        ("s", "a", 10.0, 0.0),
        ("s", "a", 99.0, 3.0),
    ];
    let svg = svg(&study(&CHARTS), &table(&points));
    let line = svg.lines().find(|line| line.contains("stroke-width=\"2\""));
    let line = line.expect("a line");
    assert_eq!(line.matches('M').count(), 3, "{line}");
    assert!(!line.contains('L'), "{line}");
    let hollow = svg.matches("fill=\"var(--bg, #ffffff)\"").count();
    assert_eq!(hollow, 1, "{svg}");
}
