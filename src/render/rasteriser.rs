//! What is known of an adapter's rasteriser.

/// The binary digits of a pixel in the common grid.
pub(super) const MOST_BITS: u32 = 8;

/// What decides which pixels a triangle covers.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rasteriser {
    /// The step, in pixels, of the grid that corners are snapped to: they move by at most half of it along each axis. A
    /// grid finer than the common one counts as the common one.
    pub grid_px: f64,
}

impl Rasteriser {
    /// The grid that Direct3D and Metal require, and most Vulkan devices have.
    pub const COMMON: Self = Self {
        grid_px: 1.0 / 256.0,
    };

    /// Binary digits of a pixel in the grid: 8 in the common one.
    pub fn sub_pixel_bits(&self) -> u32 {
        (1..MOST_BITS)
            .find(|bits| self.grid_px >= grid_px(*bits))
            .unwrap_or(MOST_BITS)
    }
}

/// The step of a grid, in pixels.
pub(super) fn grid_px(sub_pixel_bits: u32) -> f64 {
    1.0 / f64::from(1_u32 << sub_pixel_bits)
}
