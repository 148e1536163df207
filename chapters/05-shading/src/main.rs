//! `cargo run --bin 05-shading`

fn main() -> std::process::ExitCode {
    preview::run(&shading::STAGE)
}
