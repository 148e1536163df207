//! `cargo run --bin 02-sphere-hit`

fn main() -> std::process::ExitCode {
    canvas::run(&sphere_hit::STAGE)
}
