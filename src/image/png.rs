//! Pictures as PNG files, 8 and 16 bit.

use super::{Id, Image, Picture, Rgb};
use crate::{
    camera::Viewport,
    replace::{Written, write_beside},
};
use png::{BitDepth, ColorType};
use std::{io, path::Path};

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

impl Picture {
    /// Writes an 8-bit sRGB PNG, whole or not at all.
    ///
    /// # Errors
    /// When the file cannot be written.
    pub fn write_png(&self, path: &Path) -> Result<(), ImageError> {
        match self {
            Self::Opaque(image) => image.write_png(path),
            Self::Matte(image) => write_colours(
                path,
                image.size,
                ColorType::Rgba,
                image.pixels.as_flattened(),
            ),
        }
    }
}

impl Image<Rgb> {
    /// Writes an 8-bit sRGB PNG, whole or not at all.
    ///
    /// # Errors
    /// When the file cannot be written.
    pub fn write_png(&self, path: &Path) -> Result<(), ImageError> {
        write_colours(path, self.size, ColorType::Rgb, self.pixels.as_flattened())
    }
}

impl Image<Id> {
    /// Writes the object ids as a 16-bit grey PNG: 0 where there is nothing, n for object n.
    ///
    /// # Errors
    /// When the file cannot be written or an id does not fit.
    pub fn write_png(&self, path: &Path) -> Result<(), ImageError> {
        let placed = self.write_png_beside(path)?.put_in_place();
        placed.map_err(|source| failed(path, source))
    }

    /// The first half of [`Image::write_png`]: the file is written, but not yet in its place.
    ///
    /// # Errors
    /// As [`Image::write_png`].
    pub(crate) fn write_png_beside(&self, path: &Path) -> Result<Written, ImageError> {
        let mut bytes = Vec::new();
        (bytes.try_reserve_exact(self.pixels.len() * 2))
            .map_err(|source| failed(path, source.into()))?;
        for id in &self.pixels {
            let id = u16::try_from(id.object).map_err(|_| ImageError::TooManyObjects(id.object))?;
            bytes.extend(id.to_be_bytes());
        }
        let kind = (ColorType::Grayscale, BitDepth::Sixteen);
        write(path, self.size, kind, &bytes).map_err(|source| failed(path, source))
    }
}

fn write_colours(
    path: &Path,
    size: Viewport,
    colour: ColorType,
    bytes: &[u8],
) -> Result<(), ImageError> {
    let written = write(path, size, (colour, BitDepth::Eight), bytes);
    let placed = written.and_then(Written::put_in_place);
    placed.map_err(|source| failed(path, source))
}

fn failed(path: &Path, source: io::Error) -> ImageError {
    let path = path.display().to_string();
    ImageError::Write { path, source }
}

fn write(
    path: &Path,
    size: Viewport,
    (colour, depth): (ColorType, BitDepth),
    bytes: &[u8],
) -> io::Result<Written> {
    write_beside(path, |out| {
        // The encoder keeps all that it has compressed, so memory for that must be there.
        Vec::<u8>::new().try_reserve_exact(bytes.len())?;
        let mut encoder = png::Encoder::new(out, size.width(), size.height());
        encoder.set_color(colour);
        encoder.set_depth(depth);
        // The default takes several times as long, for files a quarter smaller.
        encoder.set_compression(png::Compression::Fast);
        if colour != ColorType::Grayscale {
            encoder.set_source_srgb(png::SrgbRenderingIntent::Perceptual);
        }
        let mut writer = encoder.write_header()?;
        writer.write_image_data(bytes)?;
        Ok(writer.finish()?)
    })
}
