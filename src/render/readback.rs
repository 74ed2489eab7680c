//! Reads textures back as pictures on the CPU, among them the finished picture without a window.

use super::{
    Marks, Onto, Renderer,
    formats::reordered,
    gpu::{Gpu, GpuError},
    targets::Targets,
    without_depth,
};
use crate::{
    camera::Viewport,
    image::{Id, Image, Rgb},
};
use std::sync::mpsc;

/// Bytes that are read at a time, unless a row is more.
const BAND_BYTES: u64 = 1 << 26;

impl Targets {
    /// The colours as drawn, without marks.
    ///
    /// # Errors
    /// When memory runs out or the device is lost.
    pub fn read_colours(&self, gpu: &Gpu) -> Result<Image<Rgb>, GpuError> {
        read_rgb(gpu, self.colour_view.texture(), self.viewport)
    }

    /// The object and triangle that each pixel shows.
    ///
    /// # Errors
    /// When memory runs out or the device is lost.
    pub fn read_ids(&self, gpu: &Gpu) -> Result<Image<Id>, GpuError> {
        let size = [self.viewport.width(), self.viewport.height()];
        let pixels = read(gpu, self.ids_view.texture(), [0, 0], size, id)?;
        Ok(Image::new(self.viewport, pixels))
    }

    /// The object and triangle that one pixel of the picture shows; `None` outside the picture.
    ///
    /// # Errors
    /// When memory runs out or the device is lost.
    pub fn read_id(&self, gpu: &Gpu, at_px: [u32; 2]) -> Result<Option<Id>, GpuError> {
        let size = [self.viewport.width(), self.viewport.height()];
        if at_px[0] >= size[0] || at_px[1] >= size[1] {
            return Ok(None);
        }
        let pixels = read(gpu, self.ids_view.texture(), at_px, [1, 1], id)?;
        Ok(pixels.into_iter().next())
    }
}

impl Renderer {
    /// The picture with its marks: draws these, and reads it.
    ///
    /// # Errors
    /// When memory runs out or the device is lost.
    pub fn read_marked(&mut self, onto: Onto<'_>, marks: &Marks) -> Result<Image<Rgb>, GpuError> {
        self.mark(onto, marks);
        let (_, targets, _) = onto;
        read_rgb(&self.gpu, targets.marked_view.texture(), targets.viewport)
    }
}

fn id([object, triangle]: [u32; 2]) -> Id {
    Id { object, triangle }
}

/// Red, green and blue of a texture with four 8-bit channels, in whichever order it stores them.
pub(crate) fn read_rgb(
    gpu: &Gpu,
    texture: &wgpu::Texture,
    viewport: Viewport,
) -> Result<Image<Rgb>, GpuError> {
    let size = [viewport.width(), viewport.height()];
    let ordered = reordered(texture.format());
    let pixels = read(gpu, texture, [0, 0], size, |pixel| {
        let [r, g, b, _] = ordered(pixel);
        [r, g, b]
    })?;
    Ok(Image::new(viewport, pixels))
}

/// Pixels of a part of a texture, row by row from the top.
pub(super) fn read<T: bytemuck::Pod, P>(
    gpu: &Gpu,
    texture: &wgpu::Texture,
    [left, first]: [u32; 2],
    [width, height]: [u32; 2],
    pixel: impl Fn(T) -> P,
) -> Result<Vec<P>, GpuError> {
    let row = width as usize * size_of::<T>();
    let padded = row.next_multiple_of(wgpu::COPY_BYTES_PER_ROW_ALIGNMENT as usize) as u64;
    // In bands, since a buffer may not hold as much as a texture.
    let band_bytes = BAND_BYTES.min(gpu.device.limits().max_buffer_size);
    let rows = u32::try_from(band_bytes / padded).unwrap_or(u32::MAX);
    let rows = rows.clamp(1, height);
    let buffer = gpu.within_memory(|| {
        gpu.device.create_buffer(&wgpu::BufferDescriptor {
            label: Some("readback"),
            size: padded * u64::from(rows),
            usage: wgpu::BufferUsages::COPY_DST | wgpu::BufferUsages::MAP_READ,
            mapped_at_creation: false,
        })
    })?;
    let mut pixels = Vec::new();
    (pixels.try_reserve_exact(width as usize * height as usize))
        .map_err(|_| gpu.out_of_memory())?;
    for top in (first..first + height).step_by(rows as usize) {
        let height = rows.min(first + height - top);
        let from = without_depth::at(texture, [left, top]);
        let to = wgpu::TexelCopyBufferInfo {
            buffer: &buffer,
            layout: wgpu::TexelCopyBufferLayout {
                offset: 0,
                bytes_per_row: u32::try_from(padded).ok(),
                rows_per_image: None,
            },
        };
        let size = without_depth::extent([width, height]);
        gpu.submit(|encoder| encoder.copy_texture_to_buffer(from, to, size));
        let band = ..padded * u64::from(height);
        let (sender, receiver) = mpsc::channel();
        buffer.map_async(wgpu::MapMode::Read, band, move |mapped| {
            // Nobody listens any more when waiting has failed.
            let _ = sender.send(mapped);
        });
        gpu.wait()?;
        let mapped = receiver.recv().map_err(|error| gpu.failed(&error))?;
        mapped.map_err(|error| gpu.failed(&error))?;
        let bytes = buffer.get_mapped_range(band);
        let bytes = bytes.map_err(|error| gpu.failed(&error))?;
        for line in bytes.chunks_exact(bytes.len() / height as usize) {
            let values = line[..row].chunks_exact(size_of::<T>());
            pixels.extend(values.map(|bytes| pixel(bytemuck::pod_read_unaligned(bytes))));
        }
        drop(bytes);
        buffer.unmap();
    }
    Ok(pixels)
}
