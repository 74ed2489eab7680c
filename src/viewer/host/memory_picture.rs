//! A picture in memory that frames are drawn onto, as a window draws them onto its surface.

use crate::{
    camera::Viewport,
    render::{Gpu, GpuError, Restraint},
    viewer::screen::{Canvas, Laid, Screen},
};

const FORMAT: wgpu::TextureFormat = wgpu::TextureFormat::Rgba8Unorm;

/// A picture in memory that frames are drawn onto.
pub(super) struct MemoryPicture {
    /// The device, once there was something to draw.
    pub canvas: Option<Canvas>,
    /// What the device may do.
    pub restraint: Restraint,
    pub size: Viewport,
    /// The last frame.
    pub page: Option<wgpu::Texture>,
}

impl Screen for MemoryPicture {
    fn restore(&mut self) -> Result<bool, GpuError> {
        let works = |canvas: &Canvas| !canvas.gpu().is_lost();
        if self.canvas.as_ref().is_some_and(works) {
            return Ok(false);
        }
        let gpu = Gpu::headless_within(&self.restraint)?;
        (self.canvas, self.page) = (Some(Canvas::new(gpu, FORMAT)), None);
        Ok(true)
    }

    fn canvas(&mut self) -> Option<&mut Canvas> {
        self.canvas.as_mut()
    }

    fn size(&self) -> Option<Viewport> {
        Some(self.size)
    }

    fn paint(&mut self, laid: &Laid) -> Result<(), GpuError> {
        let Some(canvas) = &mut self.canvas else {
            return Ok(());
        };
        let fits = |page: &wgpu::Texture| {
            [page.width(), page.height()] == [self.size.width(), self.size.height()]
        };
        let page = match self.page.take().filter(fits) {
            Some(page) => page,
            None => canvas.page(self.size)?,
        };
        canvas.paint(laid, self.page.insert(page))
    }
}
