//! Reading a reader's PNG, and writing a heat map.

use std::fmt;
use std::fs::{self, File};
use std::io::{self, BufReader, BufWriter, Read};
use std::path::Path;

/// A picture of sRGB levels, row by row from the top.
#[derive(Clone, Debug, PartialEq)]
pub struct Image {
    /// Width and height.
    pub size: [u32; 2],
    /// The levels.
    pub levels: Vec<[u8; 3]>,
}

impl Image {
    /// Returns the levels of a pixel.
    #[must_use]
    pub fn pixel(&self, [x, y]: [u32; 2]) -> [u8; 3] {
        self.levels[(y * self.size[0] + x) as usize]
    }
}

/// The sides of a picture that is compared.
const MIN_SIDE: u32 = 32;
/// A larger one is refused before its pixels are read.
const MAX_SIDE: u32 = 4096;

/// Why a picture cannot be compared. Its `Display` is one line: what is wrong, and what would be
/// right.
#[derive(Debug)]
#[expect(missing_docs, reason = "the message says it")]
pub enum Unreadable {
    Missing,
    Folder,
    NotPng(&'static str),
    Broken(String),
    Size([u32; 2]),
    Io(io::Error),
}

impl fmt::Display for Unreadable {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        match self {
            Self::Missing => write!(
                f,
                "there is no such file; save your picture as a PNG and give its path, or give a chapter's number, like 06"
            ),
            Self::Folder => write!(f, "it is a folder; name one PNG in it"),
            Self::NotPng(what) => write!(
                f,
                "it is {what}no PNG; save the picture as a PNG, which keeps every level as it is"
            ),
            Self::Broken(reason) => {
                write!(
                    f,
                    "this PNG is damaged ({reason}); save it once more, and close the file"
                )
            }
            Self::Size([w, h]) => write!(
                f,
                "{w}x{h} pixels cannot be compared; each side must be from {MIN_SIDE} to {MAX_SIDE}, and the book's figures are 320x240 or 800x600"
            ),
            Self::Io(error) => write!(f, "it cannot be read: {error}"),
        }
    }
}

/// Reads a PNG. Also returns what is unusual in how it is stored, each in one line.
///
/// # Errors
/// If it is no PNG, is damaged, or has a size that cannot be compared.
pub fn read(path: &Path) -> Result<(Image, Vec<String>), Unreadable> {
    let metadata = fs::metadata(path).map_err(|error| match error.kind() {
        io::ErrorKind::NotFound => Unreadable::Missing,
        _ => Unreadable::Io(error),
    })?;
    if metadata.is_dir() {
        return Err(Unreadable::Folder);
    }
    if !metadata.is_file() {
        return Err(Unreadable::NotPng("a device or a pipe and "));
    }
    let mut start = Vec::new();
    let file = File::open(path).map_err(Unreadable::Io)?;
    let read = file.take(12).read_to_end(&mut start);
    read.map_err(Unreadable::Io)?;
    if !start.starts_with(b"\x89PNG\r\n\x1a\n") {
        return Err(Unreadable::NotPng(match start[..] {
            [] => "empty and ",
            [0xff, 0xd8, ..] => "a JPEG, which changes the levels, and ",
            [b'G', b'I', b'F', ..] => "a GIF and ",
            [b'B', b'M', ..] => "a BMP and ",
            [b'P', b'1'..=b'7', b'\n' | b' ' | b'\r', ..] => "a PPM and ",
            [b'R', b'I', b'F', b'F', ..] => "a WebP and ",
            _ => "",
        }));
    }
    decode(path)
}

fn decode(path: &Path) -> Result<(Image, Vec<String>), Unreadable> {
    let broken = |error: png::DecodingError| Unreadable::Broken(error.to_string());
    let file = File::open(path).map_err(Unreadable::Io)?;
    let mut decoder = png::Decoder::new(BufReader::new(file));
    decoder.set_transformations(png::Transformations::EXPAND);
    let mut reader = decoder.read_info().map_err(broken)?;
    let info = reader.info();
    let size = [info.width, info.height];
    if !size.iter().all(|side| (MIN_SIDE..=MAX_SIDE).contains(side)) {
        return Err(Unreadable::Size(size));
    }
    let mut notes = Vec::new();
    if info.color_type == png::ColorType::Indexed {
        notes.push(
            "it has a palette: compared by the colours that it stands for".to_string(),
        );
    }
    let gamma = info.gama_chunk.map(|gamma| gamma.into_value());
    if let Some(gamma) = gamma
        && info.srgb.is_none()
        && !(0.44..0.47).contains(&gamma)
    {
        notes.push(format!(
            "its gAMA chunk says {gamma:.3}, the book's pictures are sRGB: compared by its levels"
        ));
    }
    let Some(length) = reader.output_buffer_size() else {
        return Err(Unreadable::Size(size));
    };
    let mut bytes = vec![0; length];
    let frame = reader.next_frame(&mut bytes).map_err(broken)?;
    let bytes: Vec<u8> = if frame.bit_depth == png::BitDepth::Sixteen {
        notes.push(
            "it has 16 bits a channel, the book's pictures have 8: compared as rounded to 8".to_string(),
        );
        let samples = bytes[..frame.buffer_size()].chunks_exact(2);
        let rounded =
            samples.map(|s| (u32::from(u16::from_be_bytes([s[0], s[1]])) + 128) / 257);
        rounded.map(|level| level as u8).collect()
    } else {
        bytes.truncate(frame.buffer_size());
        bytes
    };
    let channels = frame.color_type.samples();
    let pixels = || bytes.chunks_exact(channels);
    if channels % 2 == 0 {
        let clear = pixels().filter(|pixel| pixel[channels - 1] < 255).count();
        notes.push(if clear == 0 {
            "it has an alpha channel, 255 everywhere: ignored".to_string()
        } else {
            format!(
                "{clear} of its pixels are not opaque: the alpha channel is ignored here, but a viewer will not; write 255, or no alpha"
            )
        });
    }
    if channels < 3 {
        notes.push(
            "it is grey, without colours: compared as red = green = blue".to_string(),
        );
    }
    let levels = pixels()
        .map(|pixel| {
            if channels < 3 {
                [pixel[0]; 3]
            } else {
                [pixel[0], pixel[1], pixel[2]]
            }
        })
        .collect();
    Ok((Image { size, levels }, notes))
}

/// Writes a picture.
///
/// # Errors
/// If the file cannot be written.
pub fn write(path: &Path, image: &Image) -> io::Result<()> {
    let file = BufWriter::new(File::create(path)?);
    let mut encoder = png::Encoder::new(file, image.size[0], image.size[1]);
    encoder.set_color(png::ColorType::Rgb);
    encoder.set_depth(png::BitDepth::Eight);
    let mut writer = encoder.write_header()?;
    writer.write_image_data(image.levels.as_flattened())?;
    writer.finish()?;
    Ok(())
}

/// Returns every picture of the book: its name and its pixels.
///
/// # Errors
/// If one cannot be read.
pub fn book() -> Result<Vec<(String, Image)>, String> {
    let folder = crate::figures::folder();
    let complaint = |error: &dyn fmt::Display| {
        format!("the book's pictures, {}: {error}", folder.display())
    };
    let mut pictures = Vec::new();
    for entry in fs::read_dir(&folder).map_err(|error| complaint(&error))? {
        let path = entry.map_err(|error| complaint(&error))?.path();
        let name = path.file_name().unwrap_or_default().to_string_lossy();
        if let Some(name) = name.strip_suffix(".snap.png") {
            let (image, _) = read(&path).map_err(|error| complaint(&error))?;
            pictures.push((name.to_string(), image));
        }
    }
    pictures.sort_by(|a, b| a.0.cmp(&b.0));
    Ok(pictures)
}
