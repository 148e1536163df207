//! A picture on disk that knows where it was taken from.

use crate::{STAGE, Walker};
use canvas::{Canvas, write_file};
use std::path::{Path, PathBuf};

/// A finished picture, and all that it takes to draw it again.
pub struct Shot<'a> {
    /// From where.
    pub walker: Walker,
    /// The view's index.
    pub view: usize,
    /// The setting of its knob.
    pub setting: f32,
    /// The picture.
    pub canvas: &'a Canvas,
}

impl Shot<'_> {
    /// Saves it as a PNG at `path`, whose text chunks `Camera` and `Command` hold the camera's numbers
    /// and the command that draws it again.
    ///
    /// # Errors
    /// One line that says what is wrong. Nothing is then left behind.
    pub fn save(&self, path: &Path) -> Result<(), String> {
        let bytes = self
            .png(path)
            .map_err(|error| format!("cannot save {}: {error}", path.display()))?;
        write_file(path, &bytes)
    }

    fn png(&self, path: &Path) -> Result<Vec<u8>, png::EncodingError> {
        let mut bytes = Vec::new();
        let size = self.canvas.size;
        let mut encoder = png::Encoder::new(&mut bytes, size.x, size.y);
        encoder.set_color(png::ColorType::Rgb);
        encoder.add_text_chunk("Camera".to_string(), self.walker.to_string())?;
        encoder.add_itxt_chunk("Command".to_string(), self.command(path))?;
        let mut writer = encoder.write_header()?;
        writer.write_image_data(self.canvas.levels.as_flattened())?;
        writer.finish()?;
        Ok(bytes)
    }

    /// The command that draws it again, into a file of the same name.
    pub fn command(&self, path: &Path) -> String {
        let Self {
            walker,
            view,
            setting,
            canvas,
        } = self;
        let view = &STAGE.views[*view];
        let knob = match view.knob {
            Some(_) => format!(" --knob {setting}"),
            None => String::new(),
        };
        let file = path.file_name().unwrap_or_default().display();
        format!(
            "cargo run --release --bin {} -- --view {}{knob} --size {}x{} --camera={walker} --png {file}",
            STAGE.name, view.name, canvas.size.x, canvas.size.y
        )
    }

    /// Where to save it: the view's name, and a number that is not taken yet.
    pub fn path(&self) -> PathBuf {
        let name = STAGE.picture_name(&STAGE.views[self.view], self.setting);
        let path = (1..)
            .map(|number| PathBuf::from(format!("{name}--shot-{number}.png")))
            .find(|path| !path.exists())
            .expect("a number that is not taken");
        std::path::absolute(&path).unwrap_or(path)
    }
}
