//! `cargo run --bin 00-canvas`

fn main() -> std::process::ExitCode {
    preview::run(&canvas::STAGE)
}
