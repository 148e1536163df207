//! `cargo run --bin 09-anti-aliasing`

fn main() -> std::process::ExitCode {
    canvas::run(&anti_aliasing::STAGE)
}
