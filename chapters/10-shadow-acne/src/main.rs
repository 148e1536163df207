//! `cargo run --bin 10-shadow-acne`

fn main() -> std::process::ExitCode {
    preview::run(&shadow_acne::STAGE)
}
