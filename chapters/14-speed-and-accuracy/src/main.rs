//! The program of the chapter: its window and its command line.

fn main() -> std::process::ExitCode {
    preview::run(&speed_and_accuracy::STAGE)
}
