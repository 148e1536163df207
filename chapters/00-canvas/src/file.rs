//! To a file, whole or not at all; and from a canvas to a PNG.

use crate::Canvas;
use image::codecs::png::PngEncoder;
use image::{ExtendedColorType, ImageEncoder};
use std::fs;
use std::io::Write;
use std::path::Path;

/// Says in one line why no picture could be saved at `path`, as far as can be told before it is painted.
pub fn check_destination(path: &Path) -> Result<(), String> {
    let name = path.display();
    let folder = folder_of(path);
    if !folder.is_dir() {
        return Err(format!(
            "cannot save {name}: there is no folder {}; create it first",
            folder.display()
        ));
    }
    match fs::metadata(path) {
        Ok(found) if found.is_dir() => Err(format!(
            "cannot save {name}: it is a folder; name a file in it"
        )),
        Ok(found) if !found.is_file() => Err(format!(
            "cannot save {name}: it is not a regular file; name one that ends in .png"
        )),
        Ok(found) if found.permissions().readonly() => Err(format!(
            "cannot save {name}: it is read-only; make it writable or choose another name"
        )),
        _ => Ok(()),
    }
}

fn folder_of(path: &Path) -> &Path {
    match path.parent() {
        Some(folder) if folder != Path::new("") => folder,
        _ => Path::new("."),
    }
}

impl Canvas {
    /// Saves the picture at `path` as a PNG, through a temporary file in the same folder.
    ///
    /// A picture already there is replaced whole, and only if all of the new one could be written.
    ///
    /// # Errors
    /// One line that says what is wrong, and what would be right. Nothing is then left behind.
    pub fn save(&self, path: &Path) -> Result<(), String> {
        let mut png = Vec::new();
        let encoded = PngEncoder::new(&mut png).write_image(
            self.levels.as_flattened(),
            self.size.x,
            self.size.y,
            ExtendedColorType::Rgb8,
        );
        encoded.map_err(|error| format!("cannot save {}: {error}", path.display()))?;
        write_file(path, &png)
    }
}

/// Writes a file at `path`, through a temporary file in the same folder.
///
/// What is already there is replaced whole, and only if all of the new could be written.
///
/// # Errors
/// One line that says what is wrong, and what would be right. Nothing is then left behind.
pub fn write_file(path: &Path, bytes: &[u8]) -> Result<(), String> {
    check_destination(path)?;
    // A link stays a link: what it points to is replaced.
    let target = fs::canonicalize(path).unwrap_or_else(|_| path.to_path_buf());
    write_and_rename(&target, bytes)
        .map_err(|error| format!("cannot save {}: {error}", path.display()))
}

fn write_and_rename(
    target: &Path,
    bytes: &[u8],
) -> Result<(), Box<dyn std::error::Error>> {
    let mut builder = tempfile::Builder::new();
    builder.prefix(".unfinished-");
    #[cfg(unix)]
    {
        // As for any new file: the umask takes away what it should.
        use std::os::unix::fs::PermissionsExt;
        builder.permissions(fs::Permissions::from_mode(0o666));
    }
    let mut file = builder.tempfile_in(folder_of(target))?;
    file.write_all(bytes)?;
    file.as_file().sync_all()?;
    file.persist(target)?;
    Ok(())
}
