//! Files, written whole or not at all.

use crate::error::Error;
use canvas::Canvas;
use std::fs;
use std::io::{self, Write};
use std::path::Path;

/// Checks that a file can be saved at `path`, as far as can be known before it is made.
///
/// # Errors
/// If the folder does not exist, or if `path` is a folder, a device or pipe, or a read-only
/// file.
pub fn check_destination(path: &Path) -> Result<(), Error> {
    let folder = folder_of(path);
    if !folder.is_dir() {
        let (path, folder) = (path.to_owned(), folder.to_owned());
        return Err(Error::NoFolder { path, folder });
    }
    match fs::metadata(path) {
        Ok(found) if found.is_dir() => Err(Error::IsFolder(path.to_owned())),
        Ok(found) if !found.is_file() => Err(Error::NotAFile(path.to_owned())),
        Ok(found) if found.permissions().readonly() => {
            Err(Error::ReadOnly(path.to_owned()))
        }
        _ => Ok(()),
    }
}

fn folder_of(path: &Path) -> &Path {
    match path.parent() {
        Some(folder) if folder != Path::new("") => folder,
        _ => Path::new("."),
    }
}

/// Saves a picture at `path` as a PNG, as [`write_file`] does.
///
/// # Errors
/// Those of [`write_file`].
pub fn save(canvas: &Canvas, path: &Path) -> Result<(), Error> {
    save_with_text(canvas, path, &[])
}

/// Saves a picture at `path` as a PNG that also holds `texts`: pairs of a keyword and a text.
///
/// # Errors
/// Those of [`write_file`], and if a keyword is not 1 to 79 characters of Latin-1.
pub fn save_with_text(
    canvas: &Canvas,
    path: &Path,
    texts: &[(&str, &str)],
) -> Result<(), Error> {
    let png = encode_png(canvas, texts).map_err(|error| Error::Write {
        path: path.to_owned(),
        source: error.into(),
    })?;
    write_file(path, &png)
}

fn encode_png(
    canvas: &Canvas,
    texts: &[(&str, &str)],
) -> Result<Vec<u8>, png::EncodingError> {
    let mut bytes = Vec::new();
    let mut encoder = png::Encoder::new(&mut bytes, canvas.size.x, canvas.size.y);
    encoder.set_color(png::ColorType::Rgb);
    for (keyword, text) in texts {
        let (keyword, text) = (keyword.to_string(), text.to_string());
        // Every program shows tEXt, but it cannot hold every text.
        if text.is_ascii() {
            encoder.add_text_chunk(keyword, text)?;
        } else {
            encoder.add_itxt_chunk(keyword, text)?;
        }
    }
    let mut writer = encoder.write_header()?;
    writer.write_image_data(canvas.levels.as_flattened())?;
    writer.finish()?;
    Ok(bytes)
}

/// Writes a file at `path`, through a temporary file in the same folder.
///
/// A file that is already there is replaced whole, and only once all of the new one is
/// written.
///
/// # Errors
/// Those of [`check_destination`], and [`Error::Write`]. Nothing is then left behind.
pub fn write_file(path: &Path, bytes: &[u8]) -> Result<(), Error> {
    check_destination(path)?;
    // A link stays a link: what it points to is replaced.
    let target = fs::canonicalize(path).unwrap_or_else(|_| path.to_owned());
    write_and_rename(&target, bytes).map_err(|source| Error::Write {
        path: path.to_owned(),
        source,
    })
}

fn write_and_rename(target: &Path, bytes: &[u8]) -> io::Result<()> {
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
