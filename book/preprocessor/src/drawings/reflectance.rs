//! The reflectance of glass against the angle of incidence, from both sides.

use super::{Panel, number, scale};
use fresnel::fresnel;

const SIZE: [f64; 2] = [380.0, 300.0];
/// The plot in the panel: from left to right and from bottom to top.
const COLUMNS: [f64; 2] = [40.0, 366.0];
const ROWS: [f64; 2] = [250.0, 20.0];
const AIR: f64 = 1.0;
const GLASS: f64 = 1.5;

pub fn panels() -> Vec<Panel> {
    vec![
        panel("Into glass", [AIR, GLASS]),
        panel("Out of glass", [GLASS, AIR]),
    ]
}

fn panel(title: &str, [eta_i, eta_t]: [f64; 2]) -> Panel {
    let x = scale([0.0, 90.0], COLUMNS);
    let y = scale([0.0, 1.0], ROWS);
    let mut panel = Panel::new(SIZE);
    for degrees in [0.0, 30.0, 60.0, 90.0] {
        panel.line("faint", ROWS.map(|y| [x(degrees), y]));
        let text = format!("{}°", number(degrees, 0));
        panel.text("small", "middle", [x(degrees), ROWS[0] + 18.0], &text);
    }
    for part in [0.0, 0.5, 1.0] {
        panel.line("faint", COLUMNS.map(|x| [x, y(part)]));
        panel.text(
            "small",
            "end",
            [COLUMNS[0] - 6.0, y(part) + 4.0],
            &number(part, 1),
        );
    }
    panel.line(
        "ink",
        [
            [COLUMNS[0], ROWS[1]],
            [COLUMNS[0], ROWS[0]],
            [COLUMNS[1], ROWS[0]],
        ],
    );
    panel.text(
        "small",
        "middle",
        [x(45.0), ROWS[0] + 38.0],
        "angle of incidence θᵢ",
    );

    let brewster = brewster(eta_i, eta_t);
    let critical = critical(eta_i, eta_t);
    let mut mark = |degrees: f64, anchor: &str, height: f64, name: [&str; 2]| {
        panel.line("ink dashed", ROWS.map(|y| [x(degrees), y]));
        let away = if anchor == "end" { -8.0 } else { 8.0 };
        let angle = format!("{} {}°", name[1], number(degrees, 1));
        for (line, text) in [(0.0, name[0]), (18.0, angle.as_str())] {
            panel.text("small", anchor, [x(degrees) + away, y(height) + line], text);
        }
    };
    mark(brewster, "end", 0.45, ["Brewster’s", "angle"]);
    if let Some(critical) = critical {
        mark(critical, "start", 0.45, ["critical", "angle"]);
    }

    let curve = |value: &dyn Fn(f64) -> f64| {
        angles(critical)
            .map(|degrees| [x(degrees), y(value(degrees))])
            .collect::<Vec<_>>()
    };
    let curves = [
        (
            "ray",
            "r⊥²",
            curve(&|degrees| polarised(degrees, eta_i, eta_t)[1]),
        ),
        (
            "normal",
            "r∥²",
            curve(&|degrees| polarised(degrees, eta_i, eta_t)[0]),
        ),
        (
            "ink",
            "F, their mean",
            curve(&|degrees| reflectance(degrees, eta_i, eta_t)),
        ),
    ];
    for (row, (class, name, points)) in (0..).zip(curves) {
        panel.line(class, points);
        // Where no curve is.
        let left = COLUMNS[0] + 10.0;
        let left = critical.map_or(left, |critical| x(critical) + 16.0);
        let y = ROWS[1] + 22.0 * f64::from(row) + 18.0;
        panel.line(class, [[left, y - 5.0], [left + 24.0, y - 5.0]]);
        let colour = if class == "ink" { "" } else { class };
        panel.text(colour, "start", [left + 32.0, y], name);
    }

    let indices = format!(
        "{title}: ηᵢ = {}, ηₜ = {}",
        number(eta_i, 1),
        number(eta_t, 1)
    );
    let at_zero = number(reflectance(0.0, eta_i, eta_t), 2);
    let beyond = match critical {
        Some(critical) => {
            format!("From {}° on everything is reflected.", number(critical, 1))
        }
        None => "Only at 90° everything is reflected.".to_string(),
    };
    panel.caption =
        format!("{indices}. Straight on, {at_zero} of the light is reflected.");
    panel.description = format!(
        "{indices}. The reflected fraction of light of both polarisations, and their mean, against the angle of \
         incidence. All begin at {at_zero}. That for light in the plane of incidence falls to 0 at Brewster’s angle, \
         {}°, and then rises. {beyond}",
        number(brewster, 1),
    );
    panel
}

/// Returns the angles from 0 to 90° at which the curves are drawn, the critical angle, where
/// they have a vertical tangent, among them.
fn angles(critical: Option<f64>) -> impl Iterator<Item = f64> {
    let near = critical.into_iter().flat_map(|critical| {
        // Ever nearer, and there.
        let distances = (0..12).map(|halvings| 0.25 / f64::from(1 << halvings));
        distances
            .chain([0.0])
            .map(move |distance| critical - distance)
    });
    let mut angles: Vec<f64> =
        (0..=360).map(|i| f64::from(i) / 4.0).chain(near).collect();
    angles.sort_by(f64::total_cmp);
    angles.into_iter()
}

#[expect(clippy::disallowed_methods, reason = "no pixel depends on it")]
fn cosine(degrees: f64) -> f64 {
    degrees.to_radians().cos()
}

/// Returns chapter 8's reflectance.
fn reflectance(degrees: f64, eta_i: f64, eta_t: f64) -> f64 {
    fresnel(cosine(degrees) as f32, eta_i as f32, eta_t as f32).into()
}

/// Returns the amplitudes of the reflected light, as a fraction of the incident light's: of
/// light polarised in the plane of incidence, and of light polarised perpendicular to it. `None`
/// beyond the critical angle.
fn amplitudes(degrees: f64, eta_i: f64, eta_t: f64) -> Option<[f64; 2]> {
    let cos_i = cosine(degrees);
    let sin2_t = (eta_i / eta_t) * (eta_i / eta_t) * (1.0 - cos_i * cos_i);
    let cos_t = (sin2_t < 1.0).then(|| (1.0 - sin2_t).sqrt())?;
    let fraction = |a: f64, b: f64| (a - b) / (a + b);
    Some([
        fraction(eta_t * cos_i, eta_i * cos_t),
        fraction(eta_i * cos_i, eta_t * cos_t),
    ])
}

/// Returns the reflectances for the two polarisations.
fn polarised(degrees: f64, eta_i: f64, eta_t: f64) -> [f64; 2] {
    let amplitudes = amplitudes(degrees, eta_i, eta_t);
    amplitudes.map_or([1.0; 2], |amplitudes| amplitudes.map(|r| r * r))
}

/// Returns Brewster's angle: where light polarised in the plane of incidence changes its sign.
fn brewster(eta_i: f64, eta_t: f64) -> f64 {
    let at_zero = amplitudes(0.0, eta_i, eta_t).map(|[r, _]| r);
    bisect(|degrees| {
        let r = amplitudes(degrees, eta_i, eta_t).map(|[r, _]| r);
        // It is that of total reflection, not of 0°.
        r.zip(at_zero).is_some_and(|(r, at_zero)| r * at_zero > 0.0)
    })
}

/// Returns the critical angle: the least at which chapter 8's `fresnel` reflects everything.
/// `None` if only 90° does.
fn critical(eta_i: f64, eta_t: f64) -> Option<f64> {
    let angle = bisect(|degrees| reflectance(degrees, eta_i, eta_t) < 1.0);
    (angle < 89.9).then_some(angle)
}

/// Returns the angle up to which a condition holds.
fn bisect(holds: impl Fn(f64) -> bool) -> f64 {
    let [mut low, mut high] = [0.0, 90.0];
    for _ in 0..50 {
        let middle = (low + high) / 2.0;
        if holds(middle) {
            low = middle;
        } else {
            high = middle;
        }
    }
    low
}

#[cfg(test)]
mod the_reflectance {
    use super::*;

    /// The two polarisations are drawn by formulas of this file, so they are held against
    /// chapter 8's function.
    #[test]
    fn is_the_mean_of_the_polarisations() {
        for [eta_i, eta_t] in [[AIR, GLASS], [GLASS, AIR]] {
            for degrees in angles(None) {
                let [parallel, perpendicular] = polarised(degrees, eta_i, eta_t);
                let mean = (parallel + perpendicular) / 2.0;
                let error = mean - reflectance(degrees, eta_i, eta_t);
                // The curve is steepest before the critical angle.
                assert!(
                    error.abs() < 1e-4,
                    "{error} at {degrees}° from {eta_i} to {eta_t}"
                );
            }
        }
    }

    /// Their tangents are 1.5 and 1/1.5, and the critical angle's sine is 1/1.5.
    #[test]
    fn has_its_marks_where_they_belong() {
        assert!((brewster(AIR, GLASS) - 56.309_932).abs() < 1e-4);
        assert!((brewster(GLASS, AIR) - 33.690_068).abs() < 1e-4);
        assert_eq!(critical(AIR, GLASS), None);
        let critical = critical(GLASS, AIR).expect("total reflection");
        assert!((critical - 41.810_315).abs() < 1e-3, "{critical}");
    }
}
