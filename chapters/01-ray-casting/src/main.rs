//! `cargo run --bin 01-ray-casting`

fn main() -> std::process::ExitCode {
    preview::run(&ray_casting::STAGE)
}
