//! Saved pictures, and the command that renders one again.

use interactive::{RenderRequest, STAGE};
use preview::{Error, save_png};
use std::io;
use std::path::{Path, PathBuf};

/// Saves a picture as a PNG that holds its [`command`] as the text `Command`; its `rows` are
/// those of [`save_png`].
///
/// # Errors
/// If it cannot be saved. Nothing is then left behind.
pub fn save(
    request: &RenderRequest,
    path: &Path,
    rows: impl FnOnce(&mut dyn FnMut(&[[u8; 3]]) -> io::Result<()>) -> io::Result<()>,
) -> Result<(), Error> {
    let command = command(request, path);
    save_png(path, request.size, &[("Command", &command)], rows)
}

/// Returns the command that renders a picture into a file of the same name in the current
/// folder, quoted for a shell. (What is not UTF-8 in the name is replaced.)
pub fn command(request: &RenderRequest, path: &Path) -> String {
    let view = &request.view.view;
    let knob = match view.knob {
        Some(_) => format!(" --knob {}", request.setting),
        None => String::new(),
    };
    let [width, height] = request.size.to_array();
    let name = path.file_name().unwrap_or_default().to_string_lossy();
    // An option begins with a hyphen, and a name in the current folder need not.
    let name = match name.strip_prefix('-') {
        Some(_) => format!("./{name}"),
        None => name.into_owned(),
    };
    let name = shlex::try_quote(&name).expect("no name of a file holds a NUL");
    format!(
        "cargo run --release --bin {} -- --view {}{knob} --size {width}x{height} --camera={} --png {name}",
        STAGE.name, view.name, request.pose,
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
