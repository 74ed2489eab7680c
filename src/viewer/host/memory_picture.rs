//! A picture in memory that frames are drawn onto, as a window draws them onto its surface.

use crate::{
    camera::Viewport,
    render::{Gpu, GpuError, Restraint},
    viewer::{
        model::State,
        screen::{Canvas, Laid, PictureProgress, Screen},
    },
};
use std::mem;

const FORMAT: wgpu::TextureFormat = wgpu::TextureFormat::Rgba8Unorm;

/// A picture in memory that frames are drawn onto.
pub(super) struct MemoryPicture {
    /// The device, once there was something to draw.
    pub canvas: Option<Canvas>,
    /// What the device may do.
    pub restraint: Restraint,
    pub size: Viewport,
    /// Whether the last frame looks different from the one before.
    pub is_another: bool,
}

impl Screen for MemoryPicture {
    fn restore(&mut self) -> Result<bool, GpuError> {
        let works = |canvas: &Canvas| !canvas.gpu.is_lost();
        if self.canvas.as_ref().is_some_and(works) {
            return Ok(false);
        }
        let gpu = Gpu::headless_within(&self.restraint)?;
        self.canvas = Some(Canvas::new(gpu, FORMAT));
        Ok(true)
    }

    fn canvas(&mut self) -> Option<&mut Canvas> {
        self.canvas.as_mut()
    }

    fn draw(&mut self, state: &State, laid: &Laid) -> Result<PictureProgress, GpuError> {
        let Some(canvas) = &mut self.canvas else {
            return Ok(PictureProgress::default());
        };
        let progress = canvas.draw(self.size, state, laid);
        self.is_another = mem::take(&mut canvas.unshown);
        progress
    }
}
