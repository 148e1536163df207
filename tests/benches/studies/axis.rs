//! Logarithmic axes, their ticks and their labels.

/// A logarithmic axis. 0 and infinity, which have no logarithm, lie apart from the numbers,
/// beyond a break.
pub struct Axis {
    /// The decimal logarithms of the first and the last number, and where these are drawn.
    logarithms: [f64; 2],
    numbers: [f64; 2],
    /// Where 0 is drawn, and where infinity is, if there are such values.
    zero: Option<f64>,
    infinity: Option<f64>,
}

/// How far 0 and infinity are from the ends of the axis, and the numbers from those of theirs.
const APART: f64 = 12.0;
const BREAK: f64 = 36.0;

impl Axis {
    /// Returns an axis that holds all values; its numbers end at whole decades, at a 1, 2 or 5
    /// if they span less than two, or a little beyond the values if less than one.
    #[must_use]
    pub fn new(values: &[f64], [start, end]: [f64; 2]) -> Self {
        let forward = if end > start { 1.0 } else { -1.0 };
        let apart = |value, end, inwards: f64| {
            values.contains(&value).then_some(end + APART * inwards)
        };
        let zero = apart(0.0, start, forward);
        let infinity = apart(f64::INFINITY, end, -forward);
        let logarithms = values.iter().copied().map(libm::log10);
        let finite = || logarithms.clone().filter(|logarithm| logarithm.is_finite());
        let (from, to) = (
            finite().fold(f64::INFINITY, f64::min),
            finite().fold(f64::NEG_INFINITY, f64::max),
        );
        let (from, to) = if to - from > 2.0 {
            ((from + 0.01).floor(), (to - 0.01).ceil())
        } else if to - from > 1.0 {
            (-outwards(-from), outwards(to))
        } else if to >= from {
            (from - 0.1, to + 0.1)
        } else {
            (0.0, 1.0)
        };
        Self {
            logarithms: [from, to],
            numbers: [
                zero.map_or(start, |zero| zero + BREAK * forward),
                infinity.map_or(end, |infinity| infinity - BREAK * forward),
            ],
            zero,
            infinity,
        }
    }

    /// Returns where a value is drawn: at an end of the numbers if it is beyond it.
    #[must_use]
    pub fn position(&self, value: f64) -> f64 {
        match (self.zero, self.infinity) {
            (Some(zero), _) if value == 0.0 => return zero,
            (_, Some(infinity)) if value == f64::INFINITY => return infinity,
            _ => {}
        }
        let ([from, to], [start, end]) = (self.logarithms, self.numbers);
        let part = ((libm::log10(value) - from) / (to - from)).clamp(0.0, 1.0);
        start + part * (end - start)
    }

    /// Returns where the axis is broken: between 0 and the numbers, and between these and
    /// infinity.
    pub fn breaks(&self) -> impl Iterator<Item = f64> {
        let [start, end] = self.numbers;
        let zero = self.zero.map(|zero| (zero + start) / 2.0);
        let infinity = self.infinity.map(|infinity| (infinity + end) / 2.0);
        zero.into_iter().chain(infinity)
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
        let (from, to) = (from - 1e-9, to + 1e-9);
        let decades =
            (from.floor() as i32..=to.floor() as i32).filter(|decade| decade % step == 0);
        let ticks =
            decades.flat_map(|decade| digits.iter().map(move |digit| (digit, decade)));
        let mut shown = Vec::new();
        shown.extend(self.zero.map(|zero| ("0".to_string(), zero)));
        shown.extend(self.infinity.map(|infinity| ("∞".to_string(), infinity)));
        for (digit, decade) in ticks {
            let value: f64 = format!("{digit}e{decade}").parse().expect("a number");
            if (from..=to).contains(&libm::log10(value)) {
                shown.push((label(value, digit, decade), self.position(value)));
            }
        }
        shown
    }
}

/// Returns the logarithm of the next 1, 2 or 5 of a decade: a number's, or for an axis' other
/// end, that of its reciprocal.
fn outwards(logarithm: f64) -> f64 {
    let decade = logarithm.floor();
    let steps = [0.0, libm::log10(2.0), libm::log10(5.0), 1.0];
    let next = steps
        .into_iter()
        .find(|step| decade + step >= logarithm - 0.01);
    decade + next.unwrap_or(1.0)
}

/// `0.001` to `10,000`; `10⁵` or `2·10⁵` beyond.
fn label(value: f64, digit: &str, decade: i32) -> String {
    if value > 0.9e3 && value < 2e4 {
        return format!("{},{:03}", value as u32 / 1000, value as u32 % 1000);
    }
    if (9e-4..1e3).contains(&value) {
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
