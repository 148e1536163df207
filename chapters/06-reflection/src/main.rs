//! `cargo run --bin 06-reflection`

fn main() -> std::process::ExitCode {
    canvas::run(&reflection::STAGE)
}
