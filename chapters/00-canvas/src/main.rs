//! `cargo run --bin 00-canvas`

fn main() -> std::process::ExitCode {
    canvas::run(&canvas::STAGE)
}
