//! `cargo run --release --bin 14-interactive`

fn main() -> std::process::ExitCode {
    canvas::end_with(interactive::obey())
}
