//! Opens the graphics device, with or without a window, and measures what it can do.

use super::{
    abilities::Restraint,
    gpu::{Gpu, GpuError},
    probe::probe,
};
use std::time::Instant;

impl Gpu {
    /// A device that draws into textures only. `WGPU_BACKEND` narrows the choice, as everywhere in wgpu.
    ///
    /// # Errors
    /// When there is no driver, or it cannot do what drawing needs.
    pub fn headless() -> Result<Self, GpuError> {
        Self::headless_within(&Restraint::default())
    }

    /// [`Gpu::headless`] for colours alone: the rasteriser is not measured, which takes milliseconds, and counts as the
    /// common one.
    ///
    /// # Errors
    /// As [`Gpu::headless`].
    pub fn headless_for_colours() -> Result<Self, GpuError> {
        let adapter = pollster::block_on(best_adapter(&instance(), None))?;
        Self::unmeasured(adapter, &Restraint::default())
    }

    /// [`Gpu::headless`], restricted to what a lesser adapter can do.
    ///
    /// # Errors
    /// As [`Gpu::headless`].
    pub fn headless_within(restraint: &Restraint) -> Result<Self, GpuError> {
        let adapter = pollster::block_on(best_adapter(&instance(), None))?;
        Self::of(adapter, restraint)
    }

    /// A device that can draw on a window's surface.
    ///
    /// # Errors
    /// When no driver can draw on it, or the driver cannot do what drawing needs.
    pub fn for_surface(
        instance: &wgpu::Instance,
        surface: &wgpu::Surface<'_>,
    ) -> Result<Self, GpuError> {
        let adapter = pollster::block_on(best_adapter(instance, Some(surface)));
        let adapter = adapter.map_err(|_| Self::no_window(instance))?;
        Self::of(adapter, &Restraint::default())
    }

    /// Why a window's surface cannot be drawn on: there is no adapter, or it only draws into pictures.
    pub fn no_window(instance: &wgpu::Instance) -> GpuError {
        match pollster::block_on(best_adapter(instance, None)) {
            Err(error) => error,
            Ok(adapter) => GpuError::Lacks {
                adapter: adapter.get_info().name,
                what: "support for windows (`sightline render` and `verify` work with it)".into(),
            },
        }
    }

    /// A device of an adapter.
    pub(super) fn of(adapter: wgpu::Adapter, restraint: &Restraint) -> Result<Self, GpuError> {
        let mut gpu = Self::unmeasured(adapter, restraint)?;
        let start = Instant::now();
        gpu.rasteriser = probe(&gpu)?;
        log::info!(
            "{} has {} sub-pixel bits and numbers triangles by {:?}: found in {:.1?}",
            gpu.adapter_name(),
            gpu.rasteriser.sub_pixel_bits(),
            gpu.numbers,
            start.elapsed()
        );
        Ok(gpu)
    }
}

/// The instance that finds adapters, without a window. `WGPU_BACKEND` narrows the choice, as everywhere in wgpu.
pub(super) fn instance() -> wgpu::Instance {
    wgpu::Instance::new(wgpu::InstanceDescriptor::new_without_display_handle_from_env())
}

/// The adapter to draw with, on a window's surface if one is given.
pub(super) async fn best_adapter(
    instance: &wgpu::Instance,
    compatible_surface: Option<&wgpu::Surface<'_>>,
) -> Result<wgpu::Adapter, GpuError> {
    let options = wgpu::RequestAdapterOptions {
        power_preference: wgpu::PowerPreference::HighPerformance,
        compatible_surface,
        ..Default::default()
    };
    let adapter = instance.request_adapter(&options).await;
    adapter.map_err(|_| GpuError::NoAdapter)
}
