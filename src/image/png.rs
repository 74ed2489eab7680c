//! Pictures as PNG files, 8 and 16 bit.

use super::{Id, Image, Rgb};
use crate::{
    camera::Viewport,
    replace::{Written, write_beside},
};
use std::{
    io,
    path::{Path, PathBuf},
};

/// Why a PNG was not written.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum ImageError {
    /// The file cannot be written.
    #[error("cannot write {path}: {source}")]
    Write {
        /// Which file.
        path: String,
        /// The file system's error.
        source: std::io::Error,
    },
    /// An object's number does not fit into the 16 bits of an id picture's pixel.
    #[error("{0} objects do not fit into a 16-bit id picture (at most 65535)")]
    TooManyObjects(u32),
}

impl Image<Rgb> {
    /// Writes an 8-bit sRGB PNG, whole or not at all.
    ///
    /// # Errors
    /// When the file cannot be written.
    pub fn write_png(&self, path: &Path) -> Result<(), ImageError> {
        let picture = write(
            path,
            self.size,
            png::ColorType::Rgb,
            png::BitDepth::Eight,
            self.pixels.as_flattened(),
        )?;
        picture.put_in_place()
    }
}

impl Image<Id> {
    /// Writes the object ids as a 16-bit grey PNG: 0 where there is nothing, n for object n.
    ///
    /// # Errors
    /// When the file cannot be written or an id does not fit.
    pub fn write_png(&self, path: &Path) -> Result<(), ImageError> {
        self.write_png_beside(path)?.put_in_place()
    }

    /// The first half of [`Image::write_png`]: the file is written, but not yet in its place.
    ///
    /// # Errors
    /// As [`Image::write_png`].
    pub(crate) fn write_png_beside(&self, path: &Path) -> Result<WrittenPng, ImageError> {
        let mut bytes = Vec::new();
        (bytes.try_reserve_exact(self.pixels.len() * 2))
            .map_err(|source| failed(path, source.into()))?;
        for id in &self.pixels {
            let id = u16::try_from(id.object).map_err(|_| ImageError::TooManyObjects(id.object))?;
            bytes.extend(id.to_be_bytes());
        }
        write(
            path,
            self.size,
            png::ColorType::Grayscale,
            png::BitDepth::Sixteen,
            &bytes,
        )
    }
}

/// A PNG that is written, but not yet in its place. Dropped, it leaves what was there.
pub(crate) struct WrittenPng {
    path: PathBuf,
    file: Written,
}

impl WrittenPng {
    /// Moves the file into its place.
    ///
    /// # Errors
    /// The system's error.
    pub fn put_in_place(self) -> Result<(), ImageError> {
        let placed = self.file.put_in_place();
        placed.map_err(|source| failed(&self.path, source))
    }
}

fn failed(path: &Path, source: io::Error) -> ImageError {
    ImageError::Write {
        path: path.display().to_string(),
        source,
    }
}

fn write(
    path: &Path,
    size: Viewport,
    colour: png::ColorType,
    depth: png::BitDepth,
    bytes: &[u8],
) -> Result<WrittenPng, ImageError> {
    let written = write_beside(path, |out| {
        // The encoder keeps all that it has compressed, so memory for that must be there.
        Vec::<u8>::new().try_reserve_exact(bytes.len())?;
        let mut encoder = png::Encoder::new(out, size.width(), size.height());
        encoder.set_color(colour);
        encoder.set_depth(depth);
        // The default takes several times as long, for files a quarter smaller.
        encoder.set_compression(png::Compression::Fast);
        if colour == png::ColorType::Rgb {
            encoder.set_source_srgb(png::SrgbRenderingIntent::Perceptual);
        }
        let mut writer = encoder.write_header()?;
        writer.write_image_data(bytes)?;
        Ok(writer.finish()?)
    });
    let path = path.to_owned();
    match written {
        Ok(file) => Ok(WrittenPng { path, file }),
        Err(source) => Err(failed(&path, source)),
    }
}
