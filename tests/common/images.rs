//! Pictures that tests read back and compare.
#![allow(dead_code, reason = "each test uses its share")]

use sightline::{
    camera::Viewport,
    image::{Image, Rgb},
};
use std::path::Path;

/// The picture in a PNG file of 8-bit colours.
pub fn read(path: &Path) -> Image<Rgb> {
    let file = std::fs::File::open(path).unwrap_or_else(|error| {
        panic!(
            "{}: {error}; SIGHTLINE_GOLDENS=write makes it",
            path.display()
        )
    });
    let mut reader = png::Decoder::new(std::io::BufReader::new(file))
        .read_info()
        .expect("a PNG");
    let mut bytes = vec![0; reader.output_buffer_size().expect("a small picture")];
    let info = reader.next_frame(&mut bytes).expect("pixels");
    let size = Viewport::new(info.width, info.height).expect("a size");
    Image::new(size, bytes.as_chunks().0.to_vec())
}

/// Whether two colours are more than `most` of 255 apart in a channel. A driver's shading differs by a level between
/// processors, so pictures are never compared byte for byte.
pub fn apart(a: Rgb, b: Rgb, most: u8) -> bool {
    a.iter().zip(b).any(|(&a, b)| a.abs_diff(b) > most)
}
