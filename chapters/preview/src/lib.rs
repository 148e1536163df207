//! The window, the command line and the files of a chapter's program.

mod command_line;
mod error;
mod file;
mod keyboard;
mod memory;
mod processor;
mod run;
mod show;
mod terminal;
mod window;

pub use command_line::{RenderArgs, command};
pub use error::{Error, exit_code};
pub use file::{check_destination, save_png, write_file};
pub use keyboard::{KeyEvent, Keyboard, digit};
pub use run::{matches, run, show_or_save};
pub use show::{ImageResult, RgbImage, save_and_show};
pub use terminal::{print_error, print_line};
pub use window::{check_memory, size_on_screen};
