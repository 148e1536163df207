//! `cargo run --bin 01-ray-casting`

fn main() -> std::process::ExitCode {
    canvas::run(&ray_casting::STAGE)
}
