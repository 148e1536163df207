//! Files, written whole or not at all.

use crate::error::Error;
use crate::memory::make_room;
use glam::UVec2;
use std::collections::BTreeSet;
use std::fs;
use std::io::{self, BufWriter, ErrorKind, Write};
use std::path::{Path, PathBuf};
use std::sync::{Mutex, MutexGuard, PoisonError};
use tempfile::NamedTempFile;

/// Checks that a file can be saved at `path`, as far as can be known before it is made.
///
/// # Errors
/// If the folder does not exist, or if `path` is a folder, a device or pipe, a read-only
/// file, or a link that leads nowhere but to itself.
pub fn check_destination(path: &Path) -> Result<(), Error> {
    check_folder(path, path)?;
    match fs::metadata(path) {
        Ok(found) if found.is_dir() => Err(Error::IsFolder(path.to_owned())),
        Ok(found) if !found.is_file() => Err(Error::NotAFile(path.to_owned())),
        Ok(found) if found.permissions().readonly() => {
            Err(Error::ReadOnly(path.to_owned()))
        }
        Ok(_) => Ok(()),
        // A link may lead to a file that does not exist yet.
        Err(error) if error.kind() == ErrorKind::NotFound => {
            check_folder(path, &followed(path))
        }
        Err(source) => Err(Error::Write {
            path: path.to_owned(),
            source,
        }),
    }
}

/// Checks that the folder of `target` exists, where `path` leads.
fn check_folder(path: &Path, target: &Path) -> Result<(), Error> {
    let folder = folder_of(target);
    if folder.is_dir() {
        return Ok(());
    }
    let (path, folder) = (path.to_owned(), folder.to_owned());
    Err(Error::NoFolder { path, folder })
}

fn folder_of(path: &Path) -> &Path {
    match path.parent() {
        Some(folder) if folder != Path::new("") => folder,
        _ => Path::new("."),
    }
}

/// Returns the file that `path` leads to through links, whether it exists or not.
fn followed(path: &Path) -> PathBuf {
    let mut target = path.to_owned();
    // No system follows more.
    for _ in 0..64 {
        let Ok(link) = fs::read_link(&target) else {
            break;
        };
        target = folder_of(&target).join(link);
    }
    target
}

/// Saves a PNG of `size` pixels at `path`, as [`write_file`] does. It says that its colours
/// are sRGB, and holds `texts`: pairs of a keyword and a text.
///
/// `rows` is given a function, and calls it with the levels of the picture, any number of
/// whole rows at a time, from the top.
///
/// # Errors
/// Those of [`write_file`]; if a keyword is not 1 to 79 characters of Latin-1, if `rows` are
/// not as many as there should be, or if memory is short.
pub fn save_png(
    path: &Path,
    size: UVec2,
    texts: &[(&str, &str)],
    rows: impl FnOnce(&mut dyn FnMut(&[[u8; 3]]) -> io::Result<()>) -> io::Result<()>,
) -> Result<(), Error> {
    write_file(path, |file| {
        // For a row on every thread, and those that wait to be written.
        if !make_room(u64::from(size.x) << 10) {
            return Err(ErrorKind::OutOfMemory.into());
        }
        let mut encoder = png::Encoder::new(file, size.x, size.y);
        encoder.set_color(png::ColorType::Rgb);
        encoder.set_source_srgb(png::SrgbRenderingIntent::Perceptual);
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
        let mut stream = writer.stream_writer()?;
        rows(&mut |levels| stream.write_all(levels.as_flattened()))?;
        stream.finish()?;
        Ok(writer.finish()?)
    })
}

/// Writes a file at `path` by `write`, through a temporary file in the same folder.
///
/// A file that is already there is replaced whole, and only once all of the new one is
/// written. Its permissions stay, and a link stays a link: what it leads to is replaced, or
/// made if it does not exist. (Another hard link keeps the old file.)
///
/// # Errors
/// Those of [`check_destination`], and [`Error::Write`]. Nothing is then left behind, and
/// under Unix neither if the program is interrupted by Ctrl-C or terminated.
pub fn write_file(
    path: &Path,
    write: impl FnOnce(&mut dyn Write) -> io::Result<()>,
) -> Result<(), Error> {
    check_destination(path)?;
    write_and_rename(&followed(path), write).map_err(|source| Error::Write {
        path: path.to_owned(),
        source,
    })
}

fn write_and_rename(
    target: &Path,
    write: impl FnOnce(&mut dyn Write) -> io::Result<()>,
) -> io::Result<()> {
    #[cfg(unix)]
    interrupt::remove_unfinished()?;
    let old = fs::metadata(target).ok().map(|old| old.permissions());
    let file = new_file(folder_of(target))?;
    let path = file.path().to_owned();
    let written = finish(file, old, target, write);
    unfinished().remove(&path);
    written
}

/// Makes an unfinished file, one of [`unfinished`].
fn new_file(folder: &Path) -> io::Result<NamedTempFile> {
    let mut builder = tempfile::Builder::new();
    builder.prefix(".unfinished-");
    #[cfg(unix)]
    {
        // As for any new file: the umask takes away what it should.
        use std::os::unix::fs::PermissionsExt;
        builder.permissions(fs::Permissions::from_mode(0o666));
    }
    let mut unfinished = unfinished();
    let file = builder.tempfile_in(folder)?;
    unfinished.insert(file.path().to_owned());
    Ok(file)
}

fn finish(
    mut file: NamedTempFile,
    permissions: Option<fs::Permissions>,
    target: &Path,
    write: impl FnOnce(&mut dyn Write) -> io::Result<()>,
) -> io::Result<()> {
    // First of all: what is secret shall be so while it is written.
    if let Some(permissions) = permissions {
        file.as_file().set_permissions(permissions)?;
    }
    let mut buffer = BufWriter::new(&mut file);
    write(&mut buffer)?;
    buffer.flush()?;
    drop(buffer);
    file.as_file().sync_all()?;
    file.persist(target)?;
    Ok(())
}

/// Locks the paths of the files that are being written.
fn unfinished() -> MutexGuard<'static, BTreeSet<PathBuf>> {
    static UNFINISHED: Mutex<BTreeSet<PathBuf>> = Mutex::new(BTreeSet::new());
    UNFINISHED.lock().unwrap_or_else(PoisonError::into_inner)
}

#[cfg(unix)]
mod interrupt {
    use super::unfinished;
    use signal_hook::consts::{SIGINT, SIGTERM};
    use signal_hook::iterator::Signals;
    use signal_hook::low_level::emulate_default_handler;
    use std::sync::Mutex;
    use std::{fs, io, thread};

    /// From now on Ctrl-C and `kill` remove unfinished files before they end the program.
    pub fn remove_unfinished() -> io::Result<()> {
        static IS_STARTED: Mutex<bool> = Mutex::new(false);
        let Ok(mut is_started) = IS_STARTED.lock() else {
            return Ok(());
        };
        if !*is_started {
            let mut signals = Signals::new([SIGINT, SIGTERM])?;
            thread::Builder::new().spawn(move || {
                for signal in signals.forever() {
                    // Locked to the end, so that no other is made.
                    let unfinished = unfinished();
                    for path in unfinished.iter() {
                        let _ = fs::remove_file(path);
                    }
                    let _ = emulate_default_handler(signal);
                }
            })?;
            *is_started = true;
        }
        Ok(())
    }
}
