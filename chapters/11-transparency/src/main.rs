//! `cargo run --bin 11-transparency`

fn main() -> std::process::ExitCode {
    canvas::run(&transparency::STAGE)
}
