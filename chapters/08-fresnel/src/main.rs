//! `cargo run --bin 08-fresnel`

fn main() -> std::process::ExitCode {
    preview::run(&fresnel::STAGE)
}
