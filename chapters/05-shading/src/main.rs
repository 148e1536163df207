//! `cargo run --bin 05-shading`

fn main() -> std::process::ExitCode {
    canvas::run(&shading::STAGE)
}
