//! `cargo bench --bench fuzz [-- SCENES]`: renders this many random scenes, a million unless told
//! otherwise, in every way there is. Fails if one has a pixel that is not finite, takes more rays than
//! there can be, or panics: each of these is named by its seed.

#[allow(dead_code, reason = "the benches that measure need more of it")]
mod common;

use common::Error;
use preview::print_line;
use rayon::prelude::*;
use stages::fuzz::check;
use std::panic::catch_unwind;
use std::process::ExitCode;
use std::time::Instant;

fn main() -> ExitCode {
    common::run(run)
}

fn run(arguments: &[String]) -> Result<(), Error> {
    let scenes: u32 = match arguments {
        [] => 1_000_000,
        [scenes] => scenes.parse().map_err(|_| {
            Error::Usage(format!(
                "'{scenes}' is no number of scenes, 0 to {}",
                u32::MAX
            ))
        })?,
        _ => return Err(Error::Usage("one number of scenes, or none".to_string())),
    };
    let start = Instant::now();
    let mut failed: Vec<u32> = Vec::new();
    for first in (0..scenes).step_by(10_000) {
        let seeds = first..scenes.min(first.saturating_add(10_000));
        let done = seeds.end;
        // What panicked has said so on stderr.
        let fails = |&seed: &u32| catch_unwind(|| check(seed)).is_err();
        failed.par_extend(seeds.into_par_iter().filter(fails));
        let (failed, seconds) = (failed.len(), start.elapsed().as_secs());
        print_line(&format!("{done} scenes, {failed} failed, {seconds} s"));
    }
    if failed.is_empty() {
        Ok(())
    } else {
        Err(Error::Failed(format!("failed: {failed:?}")))
    }
}
