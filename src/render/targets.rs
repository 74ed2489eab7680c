//! The textures that a picture is drawn into.

use super::{
    formats::{COLOUR, COLOUR_VALUES, DEPTH, IDS, MARKS},
    gpu::{Gpu, GpuError},
    without_depth,
};
use crate::camera::Viewport;
use wgpu::TextureUsages;

/// Colours, ids and selection of one picture. Made anew when the picture's size changes.
#[derive(Debug)]
pub struct Targets {
    /// Width and height.
    pub viewport: Viewport,
    /// Colour samples per pixel.
    pub samples: u32,
    pub(super) colour_view: wgpu::TextureView,
    /// The colours with their marks.
    pub(super) marked_view: wgpu::TextureView,
    /// The same without conversion: sRGB values as they are.
    pub(crate) shown_view: wgpu::TextureView,
    pub(super) ids_view: wgpu::TextureView,
    pub(super) depth_view: wgpu::TextureView,
    pub(super) outline_view: wgpu::TextureView,
    /// Colour and depth with all their samples, where there are several.
    pub(super) multisampled: Option<[wgpu::TextureView; 2]>,
}

impl Targets {
    /// Textures for a picture of this size, with 1 or [`SMOOTH_SAMPLES`](super::SMOOTH_SAMPLES) colour samples per
    /// pixel.
    ///
    /// # Errors
    /// When the adapter draws no pictures that large, or memory runs out.
    pub fn new(gpu: &Gpu, viewport: Viewport, samples: u32) -> Result<Self, GpuError> {
        gpu.check_picture(viewport)?;
        let size = [viewport.width(), viewport.height()];
        let texture = |label, format, samples, usage| {
            let view_formats: &[_] = match label {
                "marked" => &[COLOUR_VALUES],
                _ => &[],
            };
            without_depth::texture(gpu, label, size, format, samples, usage, view_formats)
        };
        let view =
            |texture: &wgpu::Texture| texture.create_view(&wgpu::TextureViewDescriptor::default());
        let copied = TextureUsages::COPY_SRC | TextureUsages::COPY_DST;
        let read = TextureUsages::TEXTURE_BINDING | copied;
        let none = TextureUsages::empty();
        gpu.within_memory(|| {
            let marked = texture("marked", COLOUR, 1, read);
            let multisampled = (samples > 1).then(|| {
                let sampled = TextureUsages::TEXTURE_BINDING;
                [
                    view(&texture("colour samples", COLOUR, samples, sampled)),
                    view(&texture("depth samples", DEPTH, samples, none)),
                ]
            });
            Self {
                viewport,
                samples,
                colour_view: view(&texture("colour", COLOUR, 1, read)),
                marked_view: view(&marked),
                shown_view: marked.create_view(&wgpu::TextureViewDescriptor {
                    format: Some(COLOUR_VALUES),
                    ..Default::default()
                }),
                ids_view: view(&texture("ids", IDS, 1, read)),
                depth_view: view(&texture("depth", DEPTH, 1, none)),
                outline_view: view(&texture("outline", MARKS, 1, read)),
                multisampled,
            }
        })
    }
}
