//! `cargo run`: what there is to run.

use std::io::Write;

fn main() {
    let mut terminal = std::io::stdout();
    // A terminal that has gone away is no reason to panic, as `println!` would.
    for stage in light_backwards::STAGES {
        let _ = writeln!(
            terminal,
            "cargo run --bin {:<21} {}",
            stage.name, stage.title
        );
    }
}
