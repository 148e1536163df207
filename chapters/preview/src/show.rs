//! A window in a few lines of minifb, without a command line, for a reader to write.

use canvas::Canvas;
use minifb::{Key, Window, WindowOptions};

// ANCHOR: show
/// Shows a rendered picture in a window until Escape is pressed or the window is closed.
///
/// # Errors
/// If no window can be opened, for example without a display.
pub fn show(canvas: &Canvas, title: &str) -> minifb::Result<()> {
    let [width, height] = canvas.size.to_array().map(|side| side as usize);
    let mut window = Window::new(title, width, height, WindowOptions::default())?;
    window.set_target_fps(30);
    let levels = canvas.levels.iter();
    let screen: Vec<u32> = levels
        .map(|&[red, green, blue]| u32::from_be_bytes([0, red, green, blue]))
        .collect();
    while window.is_open() && !window.is_key_down(Key::Escape) {
        window.update_with_buffer(&screen, width, height)?;
    }
    Ok(())
}
// ANCHOR_END: show
