//! `cargo run`: lists the chapters, as the book's table of contents has them.

// By its path, for this program builds no chapter.
#[path = "preview/src/processor.rs"]
mod processor;

use std::io::{ErrorKind, Result, Write, stderr, stdout};
use std::process::ExitCode;

fn main() -> ExitCode {
    processor::check();
    match list() {
        // A closed pipe is no error: its reader has seen enough.
        Err(error) if error.kind() != ErrorKind::BrokenPipe => {
            let _ = writeln!(stderr(), "error: cannot print: {error}");
            ExitCode::FAILURE
        }
        _ => ExitCode::SUCCESS,
    }
}

fn list() -> Result<()> {
    let chapters = include_str!("../book/src/SUMMARY.md").lines();
    // `- [2. Where a ray hits a sphere](02-sphere-hit.md)`
    let links =
        chapters.filter_map(|line| line.strip_prefix("- [")?.strip_suffix(".md)"));
    for (title, name) in links.filter_map(|link| link.split_once("](")) {
        writeln!(stdout(), "cargo run --bin {name:<21} {title}")?;
    }
    stdout().flush()
}
