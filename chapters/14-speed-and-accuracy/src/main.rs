//! `cargo run --bin 14-speed-and-accuracy`

fn main() -> std::process::ExitCode {
    preview::run(&speed_and_accuracy::STAGE)
}
