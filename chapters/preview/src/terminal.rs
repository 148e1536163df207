//! Lines on the terminal, which may have gone away.

use crate::error::Error;
use std::fmt::Display;
use std::io::{self, ErrorKind, Write, stderr, stdout};

/// Prints a line to stdout.
///
/// # Errors
/// If it is lost, as on a full disk. A closed pipe is no error: its reader has seen enough.
pub fn print_line(line: impl Display) -> Result<(), Error> {
    printed(writeln!(stdout(), "{line}"))
}

/// Returns whether what was written to stdout has arrived, as [`print_line`] does.
pub(crate) fn printed(written: io::Result<()>) -> Result<(), Error> {
    match written.and_then(|()| stdout().flush()) {
        Err(error) if error.kind() != ErrorKind::BrokenPipe => Err(Error::Print(error)),
        _ => Ok(()),
    }
}

/// Prints an error to stderr, in one line even if it quotes an argument with line breaks.
pub fn print_error(error: impl Display) {
    let line = error.to_string().replace(char::is_control, " ");
    let _ = writeln!(stderr(), "error: {line}");
}
