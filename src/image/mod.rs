//! Pictures in memory, and as PNG files.

mod matte;
#[cfg(feature = "files")]
mod png;

pub use matte::Picture;

#[cfg(feature = "files")]
pub use self::png::ImageError;

use crate::camera::Viewport;

/// Refuses, in a line, a picture that does not fit into memory with this many bytes per pixel.
///
/// # Errors
/// When there is less memory.
pub fn check_memory(size: Viewport, bytes_per_pixel: usize) -> Result<(), String> {
    let pixels = size.width() as usize * size.height() as usize;
    let bytes = pixels.saturating_mul(bytes_per_pixel);
    Vec::<u8>::new().try_reserve_exact(bytes).map_err(|_| {
        format!(
            "a picture of {}x{} needs {} MB, more memory than is available: draw a smaller one",
            size.width(),
            size.height(),
            bytes / 1_000_000
        )
    })
}

/// A picture: one value per pixel, rows from the top.
#[derive(Clone, Debug, PartialEq)]
pub struct Image<T> {
    size: Viewport,
    pixels: Vec<T>,
}

/// An opaque sRGB pixel.
pub type Rgb = [u8; 3];

/// An sRGB pixel and its opacity, which its colour is not multiplied by: 255 is opaque.
pub type Rgba = [u8; 4];

/// What a pixel shows: an object and, on a mesh, a triangle of it.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct Id {
    /// The object's id, its index plus 1; 0 for the background.
    pub object: u32,
    /// The index of its triangle among that object's, plus 1; 0 for analytic shapes and the background.
    pub triangle: u32,
}

/// A pixel with all that drawing writes for it.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Pixel {
    /// What it shows.
    pub id: Id,
    /// Its colour, without marks.
    pub colour: Rgb,
    /// What the depth buffer stores there.
    pub depth: f32,
}

impl<T: Copy> Image<T> {
    /// Takes pixels row by row from the top.
    ///
    /// # Panics
    /// When their count does not match `size`.
    pub fn new(size: Viewport, pixels: Vec<T>) -> Self {
        assert_eq!(
            pixels.len(),
            size.width() as usize * size.height() as usize,
            "pixels fill the image"
        );
        Self { size, pixels }
    }

    /// Width and height.
    pub fn size(&self) -> Viewport {
        self.size
    }

    /// All pixels, row by row from the top.
    pub fn pixels(&self) -> &[T] {
        &self.pixels
    }

    /// All pixels, mutable, row by row from the top.
    pub fn pixels_mut(&mut self) -> &mut [T] {
        &mut self.pixels
    }

    /// The pixel in column `x` and row `y`.
    ///
    /// # Panics
    /// When that lies outside.
    pub fn at(&self, x: u32, y: u32) -> T {
        assert!(x < self.size.width(), "column within the image");
        self.pixels[y as usize * self.size.width() as usize + x as usize]
    }

    /// The part of this size with its top left pixel at `origin`.
    ///
    /// # Panics
    /// When that lies outside.
    pub fn part(&self, origin: [u32; 2], size: Viewport) -> Self {
        let [left, top] = origin;
        let row = |y: u32| (0..size.width()).map(move |x| self.at(left + x, top + y));
        Self::new(size, (0..size.height()).flat_map(row).collect())
    }

    /// Column and row of each pixel, in the order of [`Image::pixels`].
    pub fn positions(&self) -> impl Iterator<Item = (u32, u32)> + use<T> {
        let size = self.size;
        (0..size.height()).flat_map(move |y| (0..size.width()).map(move |x| (x, y)))
    }
}
