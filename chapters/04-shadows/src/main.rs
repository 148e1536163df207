//! `cargo run --bin 04-shadows`

fn main() -> std::process::ExitCode {
    canvas::run(&shadows::STAGE)
}
