//! `cargo run --release --bin 12-packets`

fn main() -> std::process::ExitCode {
    preview::run(&packets::STAGE)
}
