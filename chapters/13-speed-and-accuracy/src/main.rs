//! `cargo run --bin 13-speed-and-accuracy`

fn main() -> std::process::ExitCode {
    // Times mean something in a release build only: that, by itself, measures.
    let is_bare = std::env::args_os().len() == 1;
    if is_bare && !cfg!(debug_assertions) {
        return canvas::end_with(speed_and_accuracy::measure("all"));
    }
    canvas::run_with(&speed_and_accuracy::STAGE, &speed_and_accuracy::TASKS)
}
