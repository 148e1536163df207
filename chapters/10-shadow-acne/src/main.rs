//! `cargo run --bin 10-shadow-acne`

fn main() -> std::process::ExitCode {
    canvas::run(&shadow_acne::STAGE)
}
