//! `cargo run --bin 03-plane-hit`

fn main() -> std::process::ExitCode {
    canvas::run(&plane_hit::STAGE)
}
