//! `cargo run --bin 06-reflection`

fn main() -> std::process::ExitCode {
    preview::run(&reflection::STAGE)
}
