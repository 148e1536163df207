//! The chapters' programs, for the tests that run them.

use std::env::{self, consts::EXE_SUFFIX};
use std::fs::File;
use std::io::{BufReader, Write, stderr};
use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::LazyLock;

/// Returns the path of a program. Before the first, all are built, in the test's own profile.
pub fn path(name: &str) -> PathBuf {
    static FOLDER: LazyLock<PathBuf> = LazyLock::new(build);
    FOLDER.join(format!("{name}{EXE_SUFFIX}"))
}

/// Builds the programs of all packages, and returns their folder.
///
/// Cargo tells a test where the programs of its own package are, and no others.
fn build() -> PathBuf {
    // The programs are in target/debug, this test in target/debug/deps.
    let test = env::current_exe().expect("the test's own path");
    let folder = test.ancestors().nth(2).expect("a folder of programs");
    let target = folder.parent().expect("a target folder");
    let profile = match folder.file_name().and_then(|name| name.to_str()) {
        Some("debug") => "dev",
        Some(profile) => profile,
        None => panic!("{} is named after no profile", folder.display()),
    };
    let status = Command::new(env!("CARGO"))
        .args(["build", "--quiet", "--bins", "--profile", profile])
        .arg("--target-dir")
        .arg(target)
        .current_dir(env!("CARGO_MANIFEST_DIR"))
        .status();
    assert!(status.expect("cargo runs").success(), "the programs build");
    folder.to_owned()
}

/// Returns what a PNG says before its pixels.
pub fn png_info(path: &Path) -> png::Info<'static> {
    let file = BufReader::new(File::open(path).expect("a file"));
    let reader = png::Decoder::new(file).read_info().expect("a PNG");
    reader.info().clone()
}

/// Says in one line that a test is skipped, for want of a tool; panics in CI.
pub fn skip(tool: &str, package: &str) {
    assert!(env::var_os("CI").is_none(), "CI needs {tool}");
    // Not `eprintln!`, whose output a passing test hides.
    let test = std::thread::current();
    let test = test.name().unwrap_or_default();
    let line = format!("skipped: {test} (no {tool}; Debian has it in `{package}`)");
    writeln!(stderr(), "{line}").expect("stderr");
}
