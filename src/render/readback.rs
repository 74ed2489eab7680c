//! Textures back to pictures on the CPU.

use super::{
    Destination, Marks, Renderer, SceneBuffers,
    gpu::{Gpu, GpuError},
    targets::{COLOUR, Targets, extent},
};
use crate::{
    camera::{View, Viewport},
    image::{Id, Image, Rgb},
};
use std::sync::mpsc;

impl Targets {
    /// The colours as drawn, without marks.
    ///
    /// # Errors
    /// When memory runs out or the device is lost.
    pub fn read_colours(&self, gpu: &Gpu) -> Result<Image<Rgb>, GpuError> {
        read_rgb(gpu, &self.colour, self.viewport())
    }

    /// The object and triangle that each pixel shows.
    ///
    /// # Errors
    /// When memory runs out or the device is lost.
    pub fn read_ids(&self, gpu: &Gpu) -> Result<Image<Id>, GpuError> {
        let pixels = read(
            gpu,
            &self.ids,
            self.viewport(),
            |[object, triangle]: [u32; 2]| Id { object, triangle },
        )?;
        Ok(Image::new(self.viewport(), pixels))
    }
}

impl Renderer {
    /// The finished picture with its marks: [`Renderer::composite`] without a window.
    ///
    /// # Errors
    /// When memory runs out or the device is lost.
    pub fn composite_to_image(
        &mut self,
        gpu: &Gpu,
        scene: &SceneBuffers,
        targets: &Targets,
        view: &View,
        marks: &Marks,
    ) -> Result<Image<Rgb>, GpuError> {
        let viewport = targets.viewport();
        let texture = gpu.within_memory(|| {
            gpu.device.create_texture(&wgpu::TextureDescriptor {
                label: Some("picture"),
                size: extent(viewport),
                mip_level_count: 1,
                sample_count: 1,
                dimension: wgpu::TextureDimension::D2,
                format: COLOUR,
                usage: wgpu::TextureUsages::RENDER_ATTACHMENT | wgpu::TextureUsages::COPY_SRC,
                view_formats: &[],
            })
        })?;
        let destination = Destination {
            view: &texture.create_view(&wgpu::TextureViewDescriptor::default()),
            format: COLOUR,
            size_px: [viewport.width(), viewport.height()],
            origin_px: [0, 0],
        };
        self.composite(gpu, scene, targets, view, marks, &destination);
        read_rgb(gpu, &texture, viewport)
    }
}

fn read_rgb(
    gpu: &Gpu,
    texture: &wgpu::Texture,
    viewport: Viewport,
) -> Result<Image<Rgb>, GpuError> {
    // Opaque.
    let pixels = read(gpu, texture, viewport, |[r, g, b, _]: [u8; 4]| [r, g, b])?;
    Ok(Image::new(viewport, pixels))
}

/// Pixels of a texture, row by row from the top.
fn read<T: bytemuck::Pod, P>(
    gpu: &Gpu,
    texture: &wgpu::Texture,
    viewport: Viewport,
    pixel: impl Fn(T) -> P,
) -> Result<Vec<P>, GpuError> {
    let row = viewport.width() as usize * size_of::<T>();
    let padded = row.next_multiple_of(wgpu::COPY_BYTES_PER_ROW_ALIGNMENT as usize);
    let buffer = gpu.within_memory(|| {
        gpu.device.create_buffer(&wgpu::BufferDescriptor {
            label: Some("readback"),
            size: padded as u64 * u64::from(viewport.height()),
            usage: wgpu::BufferUsages::COPY_DST | wgpu::BufferUsages::MAP_READ,
            mapped_at_creation: false,
        })
    })?;
    let mut encoder = gpu
        .device
        .create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
    encoder.copy_texture_to_buffer(
        texture.as_image_copy(),
        wgpu::TexelCopyBufferInfo {
            buffer: &buffer,
            layout: wgpu::TexelCopyBufferLayout {
                offset: 0,
                bytes_per_row: u32::try_from(padded).ok(),
                rows_per_image: None,
            },
        },
        extent(viewport),
    );
    gpu.queue.submit([encoder.finish()]);
    let (sender, receiver) = mpsc::channel();
    buffer.map_async(wgpu::MapMode::Read, .., move |mapped| {
        // Nobody listens any more when waiting has failed.
        let _ = sender.send(mapped);
    });
    gpu.wait()?;
    let mapped = receiver.recv().map_err(|error| gpu.failed(&error))?;
    mapped.map_err(|error| gpu.failed(&error))?;
    let bytes = buffer
        .get_mapped_range(..)
        .map_err(|error| gpu.failed(&error))?;
    Ok(bytes
        .chunks_exact(padded)
        .flat_map(|line| line[..row].chunks_exact(size_of::<T>()))
        .map(|bytes| pixel(bytemuck::pod_read_unaligned(bytes)))
        .collect())
}
