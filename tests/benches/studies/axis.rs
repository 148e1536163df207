//! Logarithmic axes, their ticks and their labels.

/// A logarithmic axis.
pub struct Axis {
    /// The decimal logarithms of its ends, and where these are drawn.
    logarithms: [f64; 2],
    ends: [f64; 2],
    /// Whether the lower end stands for 0, and the upper one for infinity, which have no
    /// logarithm.
    has_zero: bool,
    has_infinity: bool,
}

impl Axis {
    /// Returns an axis that holds all values; it ends at whole decades, or a little beyond
    /// the values if they span less than one.
    #[must_use]
    pub fn new(values: &[f64], ends: [f64; 2]) -> Self {
        let has_zero = values.contains(&0.0);
        let has_infinity = values.contains(&f64::INFINITY);
        let logarithms = values.iter().copied().map(libm::log10);
        let finite = || logarithms.clone().filter(|logarithm| logarithm.is_finite());
        let (from, to) = (
            finite().fold(f64::INFINITY, f64::min),
            finite().fold(f64::NEG_INFINITY, f64::max),
        );
        let (from, to) = if to - from > 1.0 {
            ((from + 0.01).floor(), (to - 0.01).ceil())
        } else if to >= from {
            (from - 0.1, to + 0.1)
        } else {
            (0.0, 1.0)
        };
        let from = if has_zero { (from - 0.5).floor() } else { from };
        let to = if has_infinity { (to + 0.5).ceil() } else { to };
        Self {
            logarithms: [from, to],
            ends,
            has_zero,
            has_infinity,
        }
    }

    /// Returns where a value is drawn: at an end if it is beyond it, 0 or infinite.
    #[must_use]
    pub fn position(&self, value: f64) -> f64 {
        let ([from, to], [start, end]) = (self.logarithms, self.ends);
        let part = ((libm::log10(value) - from) / (to - from)).clamp(0.0, 1.0);
        start + part * (end - start)
    }

    /// Returns labels and where they stand: powers of ten, no more than nine; in less than
    /// two decades 1, 2 and 5 of each, or more of them.
    #[must_use]
    pub fn ticks(&self) -> Vec<(String, f64)> {
        let [from, to] = self.logarithms;
        let step = ((to - from) / 8.0).ceil() as i32;
        let digits: &[&str] = match to - from {
            decades if decades > 2.0 => &["1"],
            decades if decades > 0.7 => &["1", "2", "5"],
            _ => &["1", "1.5", "2", "3", "4", "5", "6", "7", "8", "9"],
        };
        let from = if self.has_zero {
            from + 0.5
        } else {
            from - 1e-9
        };
        let to = if self.has_infinity {
            to - 0.5
        } else {
            to + 1e-9
        };
        let decades =
            (from.floor() as i32..=to as i32).filter(|decade| decade % step == 0);
        let ticks =
            decades.flat_map(|decade| digits.iter().map(move |digit| (digit, decade)));
        let mut shown = Vec::new();
        if self.has_zero {
            shown.push(("0".to_string(), self.ends[0]));
        }
        if self.has_infinity {
            shown.push(("∞".to_string(), self.ends[1]));
        }
        for (digit, decade) in ticks {
            let value: f64 = format!("{digit}e{decade}").parse().expect("a number");
            if (from..=to).contains(&libm::log10(value)) {
                shown.push((label(value, digit, decade), self.position(value)));
            }
        }
        shown
    }
}

/// `0.001` to `10000`; `10⁵` or `2·10⁵` beyond.
fn label(value: f64, digit: &str, decade: i32) -> String {
    if (9e-4..2e4).contains(&value) {
        return value.to_string();
    }
    let raised = |c: char| match c.to_digit(10) {
        Some(digit) => ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹'][digit as usize],
        None => '⁻',
    };
    let times = if digit == "1" {
        String::new()
    } else {
        format!("{digit}·")
    };
    let power: String = decade.to_string().chars().map(raised).collect();
    format!("{times}10{power}")
}
