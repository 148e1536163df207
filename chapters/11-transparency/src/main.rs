//! `cargo run --bin 11-transparency`

fn main() -> std::process::ExitCode {
    preview::run(&transparency::STAGE)
}
