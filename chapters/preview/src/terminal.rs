//! Lines on the terminal, which may have gone away.

use std::fmt::Display;
use std::io::{Write, stderr, stdout};

/// Prints a line to stdout. A closed stdout is ignored, where `println!` would panic.
pub fn print_line(line: impl Display) {
    let _ = writeln!(stdout(), "{line}");
}

/// Prints an error to stderr, in one line even if it quotes an argument with line breaks.
pub fn print_error(error: impl Display) {
    let line = error.to_string().replace(char::is_control, " ");
    let _ = writeln!(stderr(), "error: {line}");
}
