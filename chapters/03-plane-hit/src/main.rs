//! `cargo run --bin 03-plane-hit`

fn main() -> std::process::ExitCode {
    preview::run(&plane_hit::STAGE)
}
