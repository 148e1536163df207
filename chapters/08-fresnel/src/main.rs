//! `cargo run --bin 08-fresnel`

fn main() -> std::process::ExitCode {
    canvas::run(&fresnel::STAGE)
}
