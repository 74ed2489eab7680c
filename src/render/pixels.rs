//! Puts pixels that were found by other means than drawing, such as rays, into a picture's targets.

use super::{
    Onto, Renderer,
    drawing::begin,
    gpu::{Gpu, GpuError},
    lines::{Line, LineBuffer},
    pipelines::{Drawn, Pass, World},
};
use crate::image::{Image, Pixel};
use bytemuck::Pod;
use wgpu::BufferUsages;

impl Renderer {
    /// Takes pixels in place of drawn ones: colours and ids. Draws lines over the colours where nothing is
    /// in front of them.
    ///
    /// # Errors
    /// When memory runs out.
    ///
    /// # Panics
    /// When `targets` or `pixels` have another size than the view, or `targets` other samples than this renderer.
    pub fn take_pixels(
        &mut self,
        onto: Onto<'_>,
        pixels: &Image<Pixel>,
        lines: &[Line],
    ) -> Result<(), GpuError> {
        let (_, targets, view) = onto;
        let gpu = &self.gpu;
        self.check(targets, view);
        assert_eq!(pixels.size(), view.viewport, "pixels fit the view");
        write(gpu, targets.colour_view.texture(), pixels, |pixel| {
            let [r, g, b] = pixel.colour;
            [r, g, b, u8::MAX]
        });
        write(gpu, targets.ids_view.texture(), pixels, |pixel| {
            [pixel.id.object, pixel.id.triangle]
        });
        if !lines.is_empty() {
            self.draw_lines(onto, pixels, lines)?;
        }
        Ok(())
    }

    /// Draws lines where no pixel is in front of them.
    fn draw_lines(
        &mut self,
        (scene, targets, view): Onto<'_>,
        pixels: &Image<Pixel>,
        lines: &[Line],
    ) -> Result<(), GpuError> {
        let gpu = &self.gpu;
        let depths: Vec<f32> = pixels.pixels().iter().map(|pixel| pixel.depth).collect();
        let depths = gpu.buffer("depths", BufferUsages::STORAGE, &depths)?;
        let lines = LineBuffer::new(gpu, view, lines, self.background)?;
        self.write_frame(scene, view);
        let bind_group = self.bind(scene, &depths);
        let pass = Pass::ColourAndIds;
        let [of_depths, of_lines] = [Drawn::Depths, Drawn::Lines]
            .map(|drawn| self.pipelines.get(gpu, pass, drawn, view, World::Whole));
        gpu.submit(|encoder| {
            let mut pass = begin(gpu, encoder, targets, view, pass, [false, true]);
            pass.set_bind_group(0, &bind_group, &[]);
            pass.set_pipeline(&of_depths);
            pass.draw(0..3, 0..1);
            pass.set_pipeline(&of_lines);
            lines.record(&mut pass);
        });
        Ok(())
    }
}

/// Writes a value of each pixel into a texture.
fn write<P: Copy, T: Pod>(
    gpu: &Gpu,
    texture: &wgpu::Texture,
    pixels: &Image<P>,
    value: impl Fn(&P) -> T,
) {
    let values: Vec<T> = pixels.pixels().iter().map(value).collect();
    let row = u32::try_from(size_of::<T>()).ok();
    let layout = wgpu::TexelCopyBufferLayout {
        offset: 0,
        bytes_per_row: row.map(|pixel| pixel * pixels.size().width()),
        rows_per_image: None,
    };
    let (onto, bytes) = (texture.as_image_copy(), bytemuck::cast_slice(&values));
    (gpu.queue).write_texture(onto, bytes, layout, texture.size());
}
