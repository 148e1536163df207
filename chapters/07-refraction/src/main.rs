//! `cargo run --bin 07-refraction`

fn main() -> std::process::ExitCode {
    canvas::run(&refraction::STAGE)
}
