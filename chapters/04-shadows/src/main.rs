//! `cargo run --bin 04-shadows`

fn main() -> std::process::ExitCode {
    preview::run(&shadows::STAGE)
}
