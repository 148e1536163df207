//! Other people's tracers, where they are installed, and what they say.

use std::ffi::OsStr;
use std::fmt;
use std::path::{Path, PathBuf};

/// Names of the tracers in the tables and the lines.
pub const POV_RAY: &str = "POV-Ray";
pub const TINYRAYTRACER: &str = "tinyraytracer";

/// The programs of others that were found.
#[derive(Debug)]
pub struct Peers {
    /// The program.
    pub povray: Option<PathBuf>,
    /// A compiler, and the source.
    pub tinyraytracer: Option<(PathBuf, PathBuf)>,
    /// A line for each that is not there.
    pub missing: Vec<String>,
}

impl Peers {
    /// Looks for programs on a search `path`, and for tinyraytracer's source in `folder`
    /// if that is not `none`.
    ///
    /// # Errors
    /// If the source is not where it is said to be.
    pub fn find(folder: &str, path: &OsStr) -> Result<Self, NoSource> {
        let mut missing = Vec::new();
        let mut find = |program: &str, peer: &str| {
            let mut files =
                std::env::split_paths(path).map(|folder| folder.join(program));
            let found = files.find(|file| file.is_file());
            if found.is_none() {
                missing.push(format!("{peer} is left out: there is no {program}"));
            }
            found
        };
        let povray = find("povray", POV_RAY);
        let mut tinyraytracer = None;
        if folder == "none" {
            missing.push(format!("{TINYRAYTRACER} is left out: no source was given"));
        } else {
            let source = Path::new(folder).join("tinyraytracer.cpp");
            if !source.is_file() {
                return Err(NoSource(source));
            }
            tinyraytracer = find("g++", TINYRAYTRACER).map(|compiler| (compiler, source));
        }
        Ok(Self {
            povray,
            tinyraytracer,
            missing,
        })
    }
}

/// The source of tinyraytracer is not at this path.
#[derive(Debug)]
pub struct NoSource(PathBuf);

impl fmt::Display for NoSource {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        let Self(path) = self;
        let path = path.display();
        write!(
            f,
            "there is no {path}; name the folder of that file, or none"
        )
    }
}

/// Returns the seconds of POV-Ray's last step, which is tracing: “Trace Time: … 5 seconds
/// (5.998 seconds)”. `None` if it does not say them.
#[must_use]
pub fn traced_s(said: &str) -> Option<f64> {
    let (before, _) = said.rsplit_once(" seconds)")?;
    before.rsplit_once('(')?.1.parse().ok()
}
