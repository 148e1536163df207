//! Helpers of the benches that write into the book.

use std::fmt;
use std::process::ExitCode;

/// An error of a bench.
#[derive(Debug)]
pub enum Error {
    /// The arguments make no sense, for this reason.
    Usage(String),
    /// Something else cannot be done.
    Failed(String),
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        match self {
            Self::Usage(line) | Self::Failed(line) => f.write_str(line),
        }
    }
}

impl From<preview::Error> for Error {
    fn from(error: preview::Error) -> Self {
        Self::Failed(error.to_string())
    }
}

/// Runs a bench with the arguments after `--`, and returns the exit code: 0 for success, 2
/// for arguments that make no sense, 1 for other errors.
///
/// If it is `cargo test` that runs it, there is nothing to be done.
pub fn run(bench: impl FnOnce(&[String]) -> Result<(), Error>) -> ExitCode {
    let arguments = std::env::args_os().skip(1);
    let arguments = arguments.map(|argument| argument.to_string_lossy().into_owned());
    // Only `cargo bench` adds this one.
    let (added, arguments): (Vec<_>, Vec<_>) = arguments.partition(|a| a == "--bench");
    let result = if added.is_empty() {
        Ok(())
    } else {
        bench(&arguments)
    };
    let Err(error) = result else {
        return ExitCode::SUCCESS;
    };
    preview::print_error(&error);
    match error {
        Error::Usage(_) => ExitCode::from(2),
        Error::Failed(_) => ExitCode::FAILURE,
    }
}

/// Refuses to measure in a debug build.
pub fn check_release() -> Result<(), Error> {
    if cfg!(debug_assertions) {
        let line = "the times of a debug build mean nothing; measure with cargo bench";
        return Err(Error::Usage(line.to_string()));
    }
    Ok(())
}

/// Returns the machine that measures: its processor, and what the compiler builds for.
pub fn machine() -> String {
    let system = format!("{} {}", std::env::consts::ARCH, std::env::consts::OS);
    let cpus = std::fs::read_to_string("/proc/cpuinfo").unwrap_or_default();
    let mut lines = cpus.lines();
    let model = lines.find_map(|line| line.strip_prefix("model name")?.split_once(": "));
    match model {
        Some((_, model)) => format!("{}, {system}", model.trim()),
        None => system,
    }
}
