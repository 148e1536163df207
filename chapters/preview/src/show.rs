// ANCHOR: ours
//! A window in a few lines of minifb, without a command line, for a reader to write.
// ANCHOR_END: ours
// ANCHOR: show
pub use image::{ImageResult, RgbImage};
use minifb::{Key, Window, WindowOptions};

/// Saves a picture as `NAME.png`, and shows it until Escape. Without a display, says so.
pub fn save_and_show(picture: &RgbImage, name: &str) -> ImageResult<()> {
    picture.save(format!("{name}.png"))?;
    let [width, height] = [picture.width(), picture.height()].map(|side| side as usize);
    let Ok(mut window) = Window::new(name, width, height, WindowOptions::default())
    else {
        eprintln!("no window: there is no display; the picture is in {name}.png");
        return Ok(());
    };
    window.set_target_fps(30);
    let levels = picture
        .pixels()
        .map(|p| u32::from_be_bytes([0, p[0], p[1], p[2]]));
    let screen: Vec<u32> = levels.collect();
    while window.is_open()
        && !window.is_key_down(Key::Escape)
        && window.update_with_buffer(&screen, width, height).is_ok()
    {}
    Ok(())
}
// ANCHOR_END: show
