//! Numbers as the tables keep them, and as the pages print them.

/// Returns a number rounded to three digits: `0.123`, `12.3`, `1.23e-7`.
pub fn three_digits(x: f64) -> String {
    let rounded: f64 = format!("{x:.2e}").parse().expect("a number just written");
    if rounded == 0.0 || (1e-3..1e6).contains(&rounded.abs()) || !rounded.is_finite() {
        rounded.to_string()
    } else {
        format!("{rounded:e}")
    }
}

/// Returns a number rounded to three digits, as we write it by hand: `0.123`, `1,230`,
/// `1.23 × 10⁻⁷`.
pub fn for_readers(x: f64) -> String {
    if x.is_infinite() {
        return "∞".to_string();
    }
    if x < 0.0 {
        return format!("−{}", for_readers(-x));
    }
    let digits = three_digits(x);
    if let Some((digits, exponent)) = digits.split_once('e') {
        let raised = |c: char| match c.to_digit(10) {
            Some(digit) => {
                ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹'][digit as usize]
            }
            None => '⁻',
        };
        let exponent: String = exponent.chars().map(raised).collect();
        // No line breaks within it.
        return format!("{digits}\u{a0}×\u{a0}10{exponent}");
    }
    match digits.parse() {
        Ok(whole) => with_separators(whole),
        Err(_) => digits,
    }
}

/// Returns a whole number with its thousands apart: `1,234,567`.
pub fn with_separators(whole: u64) -> String {
    let (thousands, rest) = (whole / 1000, whole % 1000);
    match thousands {
        0 => rest.to_string(),
        _ => format!("{},{rest:03}", with_separators(thousands)),
    }
}
