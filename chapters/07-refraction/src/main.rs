//! `cargo run --bin 07-refraction`

fn main() -> std::process::ExitCode {
    preview::run(&refraction::STAGE)
}
