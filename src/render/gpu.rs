//! A graphics device: what it can do, its memory, and its errors.

use super::{
    abilities::{self, Numbers, Restraint},
    rasteriser::Rasteriser,
};
use crate::camera::Viewport;
use std::sync::{
    Arc, Mutex,
    atomic::{AtomicBool, AtomicU64, Ordering},
};

pub use super::gpu_error::GpuError;

/// Bytes that are copied to the adapter at a time: what waits in memory for a submission is not a whole mesh.
const PIECE_BYTES: usize = 1 << 23;

/// A graphics device that can draw ids.
#[derive(Clone, Debug)]
pub struct Gpu {
    /// The adapter that the device was made from: a window asks it what its surface can do.
    pub adapter: wgpu::Adapter,
    /// Makes buffers, textures and pipelines.
    pub device: wgpu::Device,
    /// Takes commands.
    pub queue: wgpu::Queue,
    info: wgpu::AdapterInfo,
    reports: Arc<Reports>,
    /// How many triangles of meshes were uploaded.
    triangles: Arc<AtomicU64>,
    /// How ids name triangles.
    pub numbers: Numbers,
    pub(super) rasteriser: Rasteriser,
}

/// Errors that the driver reports outside of any call that could return them.
#[derive(Debug, Default)]
struct Reports {
    lost: AtomicBool,
    /// The first error since the last [`Gpu::check`].
    error: Mutex<Option<String>>,
}

impl Gpu {
    /// A device whose rasteriser counts as the common one until it is measured.
    pub(super) fn unmeasured(
        adapter: wgpu::Adapter,
        restraint: &Restraint,
    ) -> Result<Self, GpuError> {
        abilities::check(&adapter)?;
        let info = adapter.get_info();
        let numbers = restraint.numbers_of(&adapter);
        let index = match numbers {
            Numbers::Primitives => wgpu::Features::PRIMITIVE_INDEX,
            Numbers::Corners => wgpu::Features::empty(),
        };
        let descriptor = wgpu::DeviceDescriptor {
            label: Some("sightline"),
            required_features: index | wgpu::Features::POLYGON_MODE_LINE,
            // All that the adapter has: the user decides how large meshes and pictures are.
            required_limits: (restraint.limits.clone()).unwrap_or_else(|| adapter.limits()),
            ..Default::default()
        };
        let made = pollster::block_on(adapter.request_device(&descriptor));
        let (device, queue) = made.map_err(|error| refused(&info, &error))?;
        let reports = Arc::default();
        report_to(&reports, &device);
        Ok(Self {
            info,
            adapter,
            device,
            queue,
            reports,
            triangles: Arc::default(),
            numbers,
            rasteriser: Rasteriser::COMMON,
        })
    }

    /// What the adapter calls itself.
    pub fn adapter_name(&self) -> &str {
        &self.info.name
    }

    /// Whether the adapter is a program on the CPU, such as lavapipe: every pass costs milliseconds.
    pub fn is_software(&self) -> bool {
        self.info.device_type == wgpu::DeviceType::Cpu
    }

    /// Whether render passes resolve samples at their end. On software adapters a shader does it instead
    /// ([`Resolve`](super::resolve::Resolve)).
    pub(super) fn resolves(&self) -> bool {
        !self.is_software()
    }

    /// The rasteriser, as measured when the device was made.
    pub fn rasteriser(&self) -> Rasteriser {
        self.rasteriser
    }

    /// Whether a picture of this size can be drawn: it lies in one texture.
    ///
    /// Tiles would not give the same picture to the bit, so there are none. wgpu refuses a viewport larger than a
    /// texture, so each tile would need a projection of its own. Corners would be rounded anew, in `f32` and then to
    /// the rasteriser's grid, and some would come to lie a grid step away.
    ///
    /// # Errors
    /// When a side is longer than the adapter's textures.
    pub(crate) fn check_picture(&self, viewport: Viewport) -> Result<(), GpuError> {
        let (width, height) = (viewport.width(), viewport.height());
        let limit = self.device.limits().max_texture_dimension_2d;
        if width.max(height) > limit {
            let adapter = self.info.name.clone();
            return Err(GpuError::PictureTooLarge {
                adapter,
                width,
                height,
                limit,
            });
        }
        Ok(())
    }

    /// A buffer that holds these elements. It is never empty, so that it can be bound.
    pub(super) fn buffer<T: bytemuck::Pod>(
        &self,
        what: &'static str,
        usage: wgpu::BufferUsages,
        elements: &[T],
    ) -> Result<wgpu::Buffer, GpuError> {
        self.buffer_of(what, usage, elements.iter().copied())
    }

    /// Like [`Gpu::buffer`], for elements that are made as they are copied: they never stand in memory all at once.
    pub(super) fn buffer_of<T: bytemuck::Pod>(
        &self,
        what: &'static str,
        usage: wgpu::BufferUsages,
        mut elements: impl ExactSizeIterator<Item = T>,
    ) -> Result<wgpu::Buffer, GpuError> {
        let size = (elements.len().max(1) * size_of::<T>()) as u64;
        let limits = self.device.limits();
        let limit = if usage.contains(wgpu::BufferUsages::STORAGE) {
            limits.max_storage_buffer_binding_size
        } else {
            limits.max_buffer_size
        };
        if size > limit {
            let adapter = self.info.name.clone();
            return Err(GpuError::SceneTooLarge {
                adapter,
                what,
                bytes: size,
                limit,
            });
        }
        let buffer = self.within_memory(|| {
            self.device.create_buffer(&wgpu::BufferDescriptor {
                label: Some(what),
                size: size.next_multiple_of(wgpu::COPY_BUFFER_ALIGNMENT),
                usage: usage | wgpu::BufferUsages::COPY_DST,
                mapped_at_creation: false,
            })
        })?;
        let mut at = 0;
        let mut piece = Vec::new();
        while elements.len() > 0 {
            if at > 0 {
                self.queue.submit([]);
                self.wait()?;
            }
            piece.clear();
            piece.extend(elements.by_ref().take(PIECE_BYTES / size_of::<T>()));
            let bytes = bytemuck::cast_slice::<T, u8>(&piece);
            self.queue.write_buffer(&buffer, at, bytes);
            at += bytes.len() as u64;
        }
        Ok(buffer)
    }

    /// Counts the triangles of a mesh that was uploaded.
    pub(super) fn note_triangles(&self, count: usize) {
        self.triangles.fetch_add(count as u64, Ordering::Relaxed);
    }

    /// How many triangles of meshes were uploaded so far.
    pub(crate) fn uploaded_triangles(&self) -> u64 {
        self.triangles.load(Ordering::Relaxed)
    }

    /// Submits the commands that `record` records.
    pub(crate) fn submit(&self, record: impl FnOnce(&mut wgpu::CommandEncoder)) {
        let descriptor = wgpu::CommandEncoderDescriptor::default();
        let mut encoder = self.device.create_command_encoder(&descriptor);
        record(&mut encoder);
        self.queue.submit([encoder.finish()]);
    }

    /// Runs an allocation. Running out of memory is an error for the user, not a panic.
    pub(crate) fn within_memory<T>(&self, allocate: impl FnOnce() -> T) -> Result<T, GpuError> {
        let scope = self.device.push_error_scope(wgpu::ErrorFilter::OutOfMemory);
        let made = allocate();
        match pollster::block_on(scope.pop()) {
            None => Ok(made),
            Some(_) => Err(self.out_of_memory()),
        }
    }

    /// The error of an allocation that failed.
    pub(super) fn out_of_memory(&self) -> GpuError {
        GpuError::OutOfMemory(self.info.name.clone())
    }

    /// Waits until all submitted work is done.
    ///
    /// # Errors
    /// When the device is lost or refused something that was submitted.
    pub fn wait(&self) -> Result<(), GpuError> {
        let polled = self.device.poll(wgpu::PollType::wait_indefinitely());
        self.check()?;
        polled.map(|_| ()).map_err(|error| self.failed(&error))
    }

    /// Whether the device is gone for good: another [`Gpu`] is needed.
    pub fn is_lost(&self) -> bool {
        self.reports.lost.load(Ordering::Acquire)
    }

    /// Reports what the device refused since the last call.
    ///
    /// # Errors
    /// When it is lost, or refused something.
    pub fn check(&self) -> Result<(), GpuError> {
        if self.is_lost() {
            return Err(GpuError::Lost(self.info.name.clone()));
        }
        let error = self.reports.error.lock();
        match error.map_or(None, |mut error| error.take()) {
            None => Ok(()),
            Some(error) => Err(self.failed(&error)),
        }
    }

    /// The error of a driver that says this.
    pub(crate) fn failed(&self, error: &impl std::fmt::Display) -> GpuError {
        refused(&self.info, error)
    }
}

fn refused(adapter: &wgpu::AdapterInfo, error: &impl std::fmt::Display) -> GpuError {
    GpuError::Device {
        adapter: adapter.name.clone(),
        reason: one_line(error),
    }
}

/// Keeps the errors that `device` reports. Without these handlers wgpu would panic.
fn report_to(reports: &Arc<Reports>, device: &wgpu::Device) {
    let lost = Arc::clone(reports);
    device.set_device_lost_callback(move |_, _| lost.lost.store(true, Ordering::Release));
    let refused = Arc::clone(reports);
    device.on_uncaptured_error(Arc::new(move |error: wgpu::Error| {
        let text = one_line(&error);
        log::debug!("{text}");
        if let Ok(mut first) = refused.error.lock() {
            first.get_or_insert(text);
        }
    }));
}

/// An error as text of one line.
fn one_line(error: &impl std::fmt::Display) -> String {
    let text = error.to_string();
    text.split_whitespace().collect::<Vec<_>>().join(" ")
}
