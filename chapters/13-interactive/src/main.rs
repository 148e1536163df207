//! The program of the chapter: its window and its command line.

mod command_line;
mod mouse;
mod shot;
mod window;

fn main() -> std::process::ExitCode {
    preview::exit_code(command_line::run)
}
