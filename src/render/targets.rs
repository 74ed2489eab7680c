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
    viewport: Viewport,
    samples: u32,
    pub(super) colour: wgpu::Texture,
    pub(super) ids: wgpu::Texture,
    pub(super) colour_view: wgpu::TextureView,
    /// The colours, without conversion.
    pub(super) values_view: wgpu::TextureView,
    pub(super) ids_view: wgpu::TextureView,
    pub(super) depth_view: wgpu::TextureView,
    pub(super) mask_view: wgpu::TextureView,
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
            let is_viewed_twice = format == COLOUR && samples == 1;
            let view_formats: &[_] = if is_viewed_twice {
                &[COLOUR_VALUES]
            } else {
                &[]
            };
            without_depth::texture(gpu, label, size, format, samples, usage, view_formats)
        };
        let view =
            |texture: &wgpu::Texture| texture.create_view(&wgpu::TextureViewDescriptor::default());
        let copied = TextureUsages::COPY_SRC | TextureUsages::COPY_DST;
        let read = TextureUsages::TEXTURE_BINDING | copied;
        let none = TextureUsages::empty();
        gpu.within_memory(|| {
            let colour = texture("colour", COLOUR, 1, read);
            let ids = texture("ids", IDS, 1, read);
            let multisampled = (samples > 1).then(|| {
                let sampled = TextureUsages::TEXTURE_BINDING;
                [
                    ("colour samples", COLOUR, sampled),
                    ("depth samples", DEPTH, none),
                ]
                .map(|(label, format, usage)| view(&texture(label, format, samples, usage)))
            });
            Self {
                viewport,
                samples,
                colour_view: view(&colour),
                values_view: colour.create_view(&wgpu::TextureViewDescriptor {
                    format: Some(COLOUR_VALUES),
                    ..Default::default()
                }),
                ids_view: view(&ids),
                depth_view: view(&texture("depth", DEPTH, 1, none)),
                mask_view: view(&texture("mask", MARKS, 1, read)),
                outline_view: view(&texture("outline", MARKS, 1, read)),
                multisampled,
                colour,
                ids,
            }
        })
    }

    /// Width and height.
    #[must_use]
    pub fn viewport(&self) -> Viewport {
        self.viewport
    }

    /// Colour samples per pixel.
    #[must_use]
    pub fn samples(&self) -> u32 {
        self.samples
    }
}
