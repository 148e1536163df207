//! The book, as mdBook builds it.

use std::env;
use std::io::{self, ErrorKind, Write};
use std::path::Path;
use std::process::Command;

/// Builds the book into a folder. Returns whether it is there: without mdBook it is not, but in
/// the gate that is an error.
///
/// # Panics
/// If mdBook fails or warns.
pub fn book(folder: &Path) -> bool {
    let preprocessor = concat!("'", env!("CARGO_BIN_EXE_preprocessor"), "'");
    let built = Command::new("mdbook")
        .args(["build", "..", "--dest-dir"])
        .arg(folder)
        .current_dir(env!("CARGO_MANIFEST_DIR"))
        // The preprocessor is built already: no second cargo within this test.
        .env("MDBOOK_PREPROCESSOR__PAGES__COMMAND", preprocessor)
        .env_remove("RUST_LOG")
        .output();
    let built = match built {
        Err(problem)
            if problem.kind() == ErrorKind::NotFound && env::var_os("CI").is_none() =>
        {
            // Not `eprintln!`: the test harness would keep it to itself.
            let _ = writeln!(
                io::stderr(),
                "skipped: there is no mdbook to build the book with (cargo install mdbook)"
            );
            return false;
        }
        built => built.expect("mdbook runs"),
    };
    let said =
        String::from_utf8_lossy(&[built.stdout, built.stderr].concat()).into_owned();
    assert!(
        built.status.success() && !said.contains("WARN") && !said.contains("ERROR"),
        "`mdbook build book` is not content:\n{said}"
    );
    true
}
