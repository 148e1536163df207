//! `cargo run --bin 09-anti-aliasing`

fn main() -> std::process::ExitCode {
    preview::run(&anti_aliasing::STAGE)
}
