//! `cargo run --release --bin 13-interactive`

mod command_line;
mod shot;
mod window;

fn main() -> std::process::ExitCode {
    preview::exit_code(command_line::run())
}
