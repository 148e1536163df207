//! The window, the command line and the files of a chapter's program.

mod command_line;
mod error;
mod file;
mod run;
pub mod show;
mod terminal;
mod window;

pub use command_line::{RenderArgs, command};
pub use error::{Error, exit_code};
pub use file::{check_destination, save, save_with_text, write_file};
pub use run::{matches, run, show_or_save};
pub use terminal::{print_error, print_line};
pub use window::{digit, size_on_screen};
