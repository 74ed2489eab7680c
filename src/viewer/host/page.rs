//! A picture in memory that frames are drawn onto, as a window draws them onto its surface.

use crate::{
    camera::Viewport,
    render::{Gpu, GpuError},
    viewer::{
        model::State,
        screen::{Canvas, Laid, Progress, Screen},
    },
};

const FORMAT: wgpu::TextureFormat = wgpu::TextureFormat::Rgba8Unorm;

/// A picture in memory that frames are drawn onto.
pub(super) struct Page {
    /// The device once there was something to draw, and the picture.
    pub drawing: Option<(Canvas, wgpu::Texture)>,
    pub size: Viewport,
}

impl Screen for Page {
    fn restore(&mut self) -> Result<bool, GpuError> {
        let works = |(canvas, _): &(Canvas, wgpu::Texture)| !canvas.gpu.is_lost();
        if self.drawing.as_ref().is_some_and(works) {
            return Ok(false);
        }
        let canvas = Canvas::new(Gpu::headless()?, FORMAT);
        let texture = canvas.texture(self.size);
        self.drawing = Some((canvas, texture));
        Ok(true)
    }

    fn canvas(&mut self) -> Option<&mut Canvas> {
        self.drawing.as_mut().map(|(canvas, _)| canvas)
    }

    fn draw(&mut self, state: &State, laid: &Laid) -> Result<Progress, GpuError> {
        let Some((canvas, texture)) = &mut self.drawing else {
            return Ok(Progress::default());
        };
        if [texture.width(), texture.height()] != [self.size.width(), self.size.height()] {
            *texture = canvas.texture(self.size);
        }
        canvas.draw(texture, state, laid, laid.at_rest)
    }
}
