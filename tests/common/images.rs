//! Pictures that tests read back and compare.
#![allow(dead_code, reason = "each test uses its share")]

use sightline::{
    camera::Viewport,
    image::{Image, Rgb},
};
use std::path::Path;

/// The picture in a PNG file of 8-bit colours.
pub fn read(path: &Path) -> Image<Rgb> {
    read_channels(path)
}

/// The picture in a PNG file of 8 bits for each of so many channels.
pub fn read_channels<const N: usize>(path: &Path) -> Image<[u8; N]> {
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
    assert_eq!(info.color_type.samples(), N, "{}", path.display());
    let size = Viewport::new(info.width, info.height).expect("a size");
    Image::new(size, bytes.as_chunks().0.to_vec())
}

/// How many pixels two pictures of one size show differently.
#[track_caller]
pub fn differing<T: Copy + PartialEq>(a: &Image<T>, b: &Image<T>) -> usize {
    differing_where(a, b, |a, b, _| a != b)
}

/// How many pixels of two pictures of one size differ by a rule, which is given both pixels and their column and row.
#[track_caller]
pub fn differing_where<T: Copy>(
    a: &Image<T>,
    b: &Image<T>,
    differ: impl Fn(T, T, [u32; 2]) -> bool,
) -> usize {
    assert_eq!(a.size(), b.size(), "pictures of one size");
    let differ = a
        .positions()
        .filter(|&(x, y)| differ(a.at(x, y), b.at(x, y), [x, y]));
    differ.count()
}

/// Whether two colours are more than `most` of 255 apart in a channel. A driver's shading differs by a level between
/// processors, so pictures are never compared byte for byte.
pub fn apart(a: Rgb, b: Rgb, most: u8) -> bool {
    a.iter().zip(b).any(|(&a, b)| a.abs_diff(b) > most)
}
