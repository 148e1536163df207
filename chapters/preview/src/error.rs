//! The errors of a chapter's program.

use crate::processor;
use crate::terminal::print_error;
use glam::UVec2;
use std::fmt::{self, Display};
use std::io;
use std::path::PathBuf;
use std::process::ExitCode;

/// An error of a chapter's program.
///
/// Its `Display` is one line: what is wrong, and what would be right.
#[derive(Debug)]
pub enum Error {
    /// The arguments are invalid.
    Usage(clap::Error),
    /// The folder of the file `path` does not exist.
    NoFolder {
        /// The file to be saved.
        path: PathBuf,
        /// Its folder.
        folder: PathBuf,
    },
    /// The path of the file to be saved is a folder's.
    IsFolder(PathBuf),
    /// The path of the file to be saved is a device's, or a pipe's.
    NotAFile(PathBuf),
    /// The file to be replaced is read-only.
    ReadOnly(PathBuf),
    /// The file `path` could not be written.
    Write {
        /// The file to be saved.
        path: PathBuf,
        /// The reason.
        source: io::Error,
    },
    /// A line could not be printed.
    Print(io::Error),
    /// No window can be opened.
    NoWindow(minifb::Error),
    /// The window cannot show its picture any more.
    Window(minifb::Error),
    /// There is not enough memory for a window of this size in pixels.
    Memory(UVec2),
}

impl Error {
    /// Returns an [`Error::Usage`] with a message of one line.
    pub fn usage(message: impl Display) -> Self {
        clap::Error::raw(clap::error::ErrorKind::ValueValidation, message).into()
    }
}

impl Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        match self {
            Self::Usage(error) => f.write_str(&one_line(error)),
            Self::NoFolder { path, folder } => write!(
                f,
                "cannot save {}: there is no folder {}; create it first",
                path.display(),
                folder.display()
            ),
            Self::IsFolder(path) => write!(
                f,
                "cannot save {}: it is a folder; name a file in it",
                path.display()
            ),
            Self::NotAFile(path) => write!(
                f,
                "cannot save {}: it is not a regular file; name one that ends in .png",
                path.display()
            ),
            Self::ReadOnly(path) => write!(
                f,
                "cannot save {}: it is read-only; make it writable or choose another name",
                path.display()
            ),
            Self::Write { path, source } => {
                write!(f, "cannot save {}: {source}", path.display())
            }
            Self::Print(source) => write!(f, "cannot print: {source}"),
            Self::NoWindow(source) => write!(f, "no window: {source}"),
            Self::Window(source) => write!(f, "the window: {source}"),
            Self::Memory(UVec2 { x, y }) => write!(
                f,
                "not enough memory for a window of {x}x{y} pixels; save a PNG by --png, which needs less"
            ),
        }
    }
}

/// Returns clap's explanation in one line. Of its paragraphs the usage is left out.
fn one_line(error: &clap::Error) -> String {
    let text = error.to_string();
    let text = text.strip_prefix("error: ").unwrap_or(&text).trim_end();
    let paragraphs = text
        .split("\n\n")
        .filter(|part| !part.starts_with("Usage: "));
    let lines: Vec<_> = paragraphs
        .map(|part| part.lines().map(str::trim).collect::<Vec<_>>().join(" "))
        .collect();
    lines.join(". ")
}

impl std::error::Error for Error {}

impl From<clap::Error> for Error {
    fn from(error: clap::Error) -> Self {
        Self::Usage(error)
    }
}

/// Runs a program, prints its error, if there is one, and returns its exit code: 0 for
/// success, 2 for invalid arguments, 1 for other errors.
///
/// A processor that lacks instructions of this program is also an error.
pub fn exit_code(run: impl FnOnce() -> Result<(), Error>) -> ExitCode {
    processor::check();
    let Err(error) = run() else {
        return ExitCode::SUCCESS;
    };
    print_error(&error);
    match error {
        Error::Usage(_) => ExitCode::from(2),
        _ => ExitCode::FAILURE,
    }
}
