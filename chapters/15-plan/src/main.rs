//! `cargo run --bin 15-plan`

fn main() -> std::process::ExitCode {
    preview::run(&plan::STAGE)
}
