//! The numbers that the book quotes: text snapshots in `book/src/numbers`, which its pages
//! include by anchor.

use crate::snapshots::advice;
use glam::Vec3;
use similar::TextDiff;

// The numbers of tests are written as those of the studies are; no chapter is built for it.
#[path = "../../../chapters/14-speed-and-accuracy/src/digits.rs"]
mod digits;

pub use digits::{for_readers as three_digits, with_separators};
use std::fmt::{Display, Write};
use std::fs;
use std::panic::{AssertUnwindSafe, catch_unwind};

/// One file of numbers.
#[derive(Default)]
pub struct Numbers(String);

impl Numbers {
    /// Adds a number, or the rows of a table, which a page includes by its `anchor`.
    pub fn note(&mut self, anchor: &str, value: impl Display) {
        writeln!(
            self.0,
            "<!-- ANCHOR: {anchor} -->\n{value}\n<!-- ANCHOR_END: {anchor} -->"
        )
        .expect("a String takes everything");
    }

    /// Compares these numbers with the book's file called `name`.
    ///
    /// # Panics
    /// If they differ; the message shows the lines that do.
    pub fn check(&self, name: &str) {
        let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../../book/src/numbers");
        let mut settings = insta::Settings::new();
        settings.set_snapshot_path(folder);
        settings.set_prepend_module_to_snapshot(false);
        settings.set_omit_expression(true);
        let matched = catch_unwind(AssertUnwindSafe(|| {
            settings.bind(|| insta::assert_snapshot!(name, self.0));
        }));
        if matched.is_err() {
            let book = fs::read_to_string(format!("{folder}/{name}.snap"));
            let book = book.unwrap_or_default();
            // Insta's own lines come first, between two rules.
            let book = book.splitn(3, "---\n").nth(2).unwrap_or_default();
            let diff = TextDiff::from_lines(book.trim_end(), self.0.trim_end());
            let diff = diff
                .unified_diff()
                .header("the book's", "yours")
                .to_string();
            panic!(
                "snapshot assertion: the numbers are not those of {name}\n{diff}{}",
                advice("book/src/numbers")
            );
        }
    }
}

/// Returns where `is_lit` begins to hold between 0 and `lit`, to the last bit or so.
#[must_use]
pub fn edge_of_shadow(mut lit: f32, is_lit: impl Fn(f32) -> bool) -> f32 {
    let mut dark = 0.0;
    for _ in 0..30 {
        let middle = (dark + lit) / 2.0;
        if is_lit(middle) {
            lit = middle;
        } else {
            dark = middle;
        }
    }
    lit
}

/// Returns a fraction as a percentage with three digits.
#[must_use]
pub fn percent(part: usize, whole: usize) -> String {
    // The space is one at which no line breaks.
    format!(
        "{}\u{a0}%",
        three_digits(100.0 * part as f64 / whole as f64)
    )
}

/// Returns the rows of a Markdown table.
pub fn table<const N: usize>(rows: impl IntoIterator<Item = [String; N]>) -> String {
    let rows = rows
        .into_iter()
        .map(|row| format!("| {} |", row.join(" | ")));
    rows.collect::<Vec<_>>().join("\n")
}

/// Returns a vector with three decimals: `(0.600, −0.800, 0.000)`.
#[must_use]
pub fn vector(v: &[f32]) -> String {
    let numbers: Vec<_> = v.iter().map(|x| format!("{x:.3}")).collect();
    format!("({})", numbers.join(", ").replace('-', "−"))
}

/// Returns three numbers as they are written in the code: `(0.6, −0.05, 0)`.
#[must_use]
pub fn triple(v: Vec3) -> String {
    // Adding 0 makes a 0 of −0.
    let numbers = (v + 0.0).to_array().map(|x| x.to_string());
    format!("({})", numbers.join(", ").replace('-', "−"))
}
