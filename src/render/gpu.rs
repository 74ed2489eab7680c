//! The graphics device, with or without a window, and what can go wrong with it.

use crate::camera::Viewport;
use std::sync::{
    Arc, Mutex,
    atomic::{AtomicBool, Ordering},
};

/// How much is copied to the adapter at a time: a millisecond or two.
const PIECE_BYTES: usize = 1 << 23;

/// A graphics device that can draw triangle ids.
#[derive(Clone, Debug)]
pub struct Gpu {
    /// What the device was made from: a window asks it what its surface can do.
    pub adapter: wgpu::Adapter,
    /// Makes buffers, textures and pipelines.
    pub device: wgpu::Device,
    /// Takes commands.
    pub queue: wgpu::Queue,
    info: wgpu::AdapterInfo,
    reports: Arc<Reports>,
}

/// What the driver said outside of any call that could return it.
#[derive(Debug, Default)]
struct Reports {
    lost: AtomicBool,
    /// The first error since somebody asked.
    error: Mutex<Option<String>>,
}

/// Why nothing can be drawn. Each says in one line what to do about it.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum GpuError {
    /// No driver, or none that can show on this window.
    #[error(
        "no graphics driver found: install one (Debian, Ubuntu: apt-get install mesa-vulkan-drivers); \
         `sightline render --by raycast` draws without"
    )]
    NoAdapter,
    /// The driver cannot tell which triangle a pixel shows.
    #[error(
        "{0} cannot number triangles (no primitive index): use another driver; \
         `sightline render --by raycast` draws without"
    )]
    NoPrimitiveIndex(String),
    /// The driver is there but does not work.
    #[error(
        "{adapter} refuses to work ({reason}): use another driver; `sightline render --by raycast` draws without"
    )]
    Device {
        /// The adapter's name.
        adapter: String,
        /// What the driver said.
        reason: String,
    },
    /// More pixels than a texture may have.
    #[error(
        "a picture of {width}x{height} is too large: {adapter} draws at most {limit} pixels each way"
    )]
    PictureTooLarge {
        /// The adapter's name.
        adapter: String,
        /// Asked width.
        width: u32,
        /// Asked height.
        height: u32,
        /// The most the adapter does.
        limit: u32,
    },
    /// More vertices, triangles or objects than a buffer may hold.
    #[error(
        "the scene's {what} need {bytes} bytes, {adapter} takes at most {limit}; \
         `sightline render --by raycast` draws without"
    )]
    SceneTooLarge {
        /// The adapter's name.
        adapter: String,
        /// What does not fit.
        what: &'static str,
        /// How much it needs.
        bytes: u64,
        /// The most the adapter takes.
        limit: u64,
    },
    /// The driver gave the device up: it was reset, updated or unplugged.
    #[error(
        "{0} was lost, as when a driver restarts: try again; `sightline render --by raycast` draws without"
    )]
    Lost(String),
    /// Graphics memory is used up.
    #[error(
        "{0} is out of memory: draw a smaller picture or scene; `sightline render --by raycast` draws without"
    )]
    OutOfMemory(String),
}

impl Gpu {
    /// A device that draws into textures only. `WGPU_BACKEND` narrows the choice, as everywhere in wgpu.
    ///
    /// # Errors
    /// When there is no driver, or it cannot do what drawing needs.
    pub fn headless() -> Result<Self, GpuError> {
        let instance =
            wgpu::Instance::new(wgpu::InstanceDescriptor::new_without_display_handle_from_env());
        pollster::block_on(Self::request(&instance, None))
    }

    /// A device that can draw on a window's surface.
    ///
    /// # Errors
    /// When there is no driver that can, or it cannot do what drawing needs.
    pub fn for_surface(
        instance: &wgpu::Instance,
        surface: &wgpu::Surface<'_>,
    ) -> Result<Self, GpuError> {
        pollster::block_on(Self::request(instance, Some(surface)))
    }

    async fn request(
        instance: &wgpu::Instance,
        compatible_surface: Option<&wgpu::Surface<'_>>,
    ) -> Result<Self, GpuError> {
        let options = wgpu::RequestAdapterOptions {
            power_preference: wgpu::PowerPreference::HighPerformance,
            compatible_surface,
            ..Default::default()
        };
        let adapter = instance.request_adapter(&options).await;
        let adapter = adapter.map_err(|_| GpuError::NoAdapter)?;
        let info = adapter.get_info();
        if !adapter.features().contains(wgpu::Features::PRIMITIVE_INDEX) {
            return Err(GpuError::NoPrimitiveIndex(info.name));
        }
        let descriptor = wgpu::DeviceDescriptor {
            label: Some("sightline"),
            required_features: wgpu::Features::PRIMITIVE_INDEX
                | (adapter.features() & wgpu::Features::POLYGON_MODE_LINE),
            // All there is: meshes and pictures are as large as the user says.
            required_limits: adapter.limits(),
            ..Default::default()
        };
        let (device, queue) =
            (adapter.request_device(&descriptor).await).map_err(|error| GpuError::Device {
                adapter: info.name.clone(),
                reason: one_line(&error),
            })?;
        let reports = Arc::default();
        report_to(&reports, &device);
        Ok(Self {
            adapter,
            device,
            queue,
            info,
            reports,
        })
    }

    /// What the adapter calls itself.
    #[must_use]
    pub fn adapter_name(&self) -> &str {
        &self.info.name
    }

    /// Whether the adapter is a program on the CPU, such as lavapipe: every pass costs milliseconds.
    #[must_use]
    pub fn is_software(&self) -> bool {
        self.info.device_type == wgpu::DeviceType::Cpu
    }

    /// Whether triangles can be drawn as their edges.
    #[must_use]
    pub fn draws_wireframes(&self) -> bool {
        let features = self.device.features();
        features.contains(wgpu::Features::POLYGON_MODE_LINE)
    }

    /// Samples a pixel that colours are worth while the picture moves: [`SMOOTH_SAMPLES`](super::SMOOTH_SAMPLES) on
    /// hardware, 1 in software.
    #[must_use]
    pub fn samples_in_motion(&self) -> u32 {
        if self.is_software() {
            1
        } else {
            super::SMOOTH_SAMPLES
        }
    }

    /// Whether a picture of this size can be drawn.
    ///
    /// # Errors
    /// When a side is longer than the adapter's textures.
    pub(super) fn check_picture(&self, viewport: Viewport) -> Result<(), GpuError> {
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

    /// A buffer with these bytes in it. Never empty, so that it can be bound.
    pub(super) fn buffer<T: bytemuck::Pod>(
        &self,
        what: &'static str,
        usage: wgpu::BufferUsages,
        elements: &[T],
    ) -> Result<wgpu::Buffer, GpuError> {
        let size = (elements.len().max(1) * size_of::<T>()) as u64;
        let limits = self.device.limits();
        let limit = if usage.contains(wgpu::BufferUsages::STORAGE) {
            limits.max_storage_buffer_binding_size
        } else {
            limits.max_buffer_size
        };
        if size > limit {
            return Err(GpuError::SceneTooLarge {
                adapter: self.info.name.clone(),
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
        // In pieces, so that what is drawn meanwhile comes between them.
        let mut at = 0;
        for piece in bytemuck::cast_slice::<T, u8>(elements).chunks(PIECE_BYTES) {
            if at > 0 {
                self.queue.submit([]);
            }
            self.queue.write_buffer(&buffer, at, piece);
            at += piece.len() as u64;
        }
        Ok(buffer)
    }

    /// For commands that are submitted together.
    pub(crate) fn encoder(&self) -> wgpu::CommandEncoder {
        self.device
            .create_command_encoder(&wgpu::CommandEncoderDescriptor::default())
    }

    /// Runs what allocates; running out is the user's to know, not a reason to panic.
    pub(super) fn within_memory<T>(&self, allocate: impl FnOnce() -> T) -> Result<T, GpuError> {
        let scope = self.device.push_error_scope(wgpu::ErrorFilter::OutOfMemory);
        let made = allocate();
        match pollster::block_on(scope.pop()) {
            None => Ok(made),
            Some(_) => Err(GpuError::OutOfMemory(self.info.name.clone())),
        }
    }

    /// Waits until all that was submitted is done.
    ///
    /// # Errors
    /// When the device is lost or refused something that was submitted.
    pub fn wait(&self) -> Result<(), GpuError> {
        let polled = self.device.poll(wgpu::PollType::wait_indefinitely());
        self.check()?;
        polled.map(|_| ()).map_err(|error| self.failed(&error))
    }

    /// Whether the device is gone for good: another [`Gpu`] is needed.
    #[must_use]
    pub fn is_lost(&self) -> bool {
        self.reports.lost.load(Ordering::Acquire)
    }

    /// What the device refused since the last time somebody asked.
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

    pub(super) fn failed(&self, error: &impl std::fmt::Display) -> GpuError {
        GpuError::Device {
            adapter: self.info.name.clone(),
            reason: one_line(error),
        }
    }
}

/// Keeps what `device` reports; left alone, wgpu would panic.
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

fn one_line(error: &impl std::fmt::Display) -> String {
    let text = error.to_string();
    text.split_whitespace().collect::<Vec<_>>().join(" ")
}
