//! The formats of the textures that a picture is drawn into.

use wgpu::TextureFormat;

/// Colours: sRGB in memory, linear in shaders.
pub(super) const COLOUR: TextureFormat = TextureFormat::Rgba8UnormSrgb;
/// The same values, without conversion.
pub(super) const COLOUR_VALUES: TextureFormat = TextureFormat::Rgba8Unorm;
/// Object and triangle, each plus 1.
pub(super) const IDS: TextureFormat = TextureFormat::Rg32Uint;
/// Floating point, which reversed depth needs.
pub(super) const DEPTH: TextureFormat = TextureFormat::Depth32Float;
/// How much of a pixel is outline.
pub(super) const MARKS: TextureFormat = TextureFormat::R8Unorm;

/// Changes between red, green, blue, alpha and the order in which a format with four 8-bit channels stores them, in
/// either direction: many windows want blue first.
pub(super) fn reordered(format: TextureFormat) -> impl Fn([u8; 4]) -> [u8; 4] {
    let blue_first = format.remove_srgb_suffix() == TextureFormat::Bgra8Unorm;
    move |[a, b, c, d]| {
        if blue_first {
            [c, b, a, d]
        } else {
            [a, b, c, d]
        }
    }
}
