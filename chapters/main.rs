//! `cargo run`: lists the chapters, as the book's table of contents has them.

use std::io::Write;

fn main() {
    let mut terminal = std::io::stdout();
    let chapters = include_str!("../book/src/SUMMARY.md").lines();
    // `- [2. Where a ray hits a sphere](02-sphere-hit.md)`
    let links =
        chapters.filter_map(|line| line.strip_prefix("- [")?.strip_suffix(".md)"));
    for (title, name) in links.filter_map(|link| link.split_once("](")) {
        // Not `println!`, which panics if the terminal has gone away.
        let _ = writeln!(terminal, "cargo run --bin {name:<21} {title}");
    }
}
