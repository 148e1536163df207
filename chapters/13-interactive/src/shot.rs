//! Saved pictures, and the command that renders one again.

use canvas::Canvas;
use interactive::{RenderRequest, STAGE};
use preview::{Error, save_with_text};
use std::path::{Path, PathBuf};

/// Saves a picture as a PNG that holds its [`command`] as the text `Command`.
///
/// # Errors
/// If it cannot be saved. Nothing is then left behind.
pub fn save(request: &RenderRequest, canvas: &Canvas, path: &Path) -> Result<(), Error> {
    save_with_text(canvas, path, &[("Command", &command(request, path))])
}

/// Returns the command that renders a picture into a file of the same name.
pub fn command(request: &RenderRequest, path: &Path) -> String {
    let view = &request.view.view;
    let knob = match view.knob {
        Some(_) => format!(" --knob {}", request.setting),
        None => String::new(),
    };
    let [width, height] = request.size.to_array();
    format!(
        "cargo run --release --bin {} -- --view {}{knob} --size {width}x{height} --camera={} --png {}",
        STAGE.name,
        view.name,
        request.pose,
        path.file_name().unwrap_or_default().display()
    )
}

/// Returns where to save a picture: the view's name and the first number that is not taken.
pub fn free_path(request: &RenderRequest) -> PathBuf {
    let name = STAGE.picture_name(&request.view.view, request.setting);
    let path = (1..)
        .map(|number| PathBuf::from(format!("{name}--shot-{number}.png")))
        .find(|path| !path.exists())
        .expect("a number that is not taken");
    std::path::absolute(&path).unwrap_or(path)
}
