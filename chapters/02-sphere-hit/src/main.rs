//! `cargo run --bin 02-sphere-hit`

fn main() -> std::process::ExitCode {
    preview::run(&sphere_hit::STAGE)
}
