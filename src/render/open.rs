//! Opens the graphics device, with or without a window, and measures what it can do.

use super::{
    abilities::Restraint,
    gpu::{Gpu, GpuError},
    probe::probe,
};
use std::time::Instant;
use wgpu::TextureFormat;

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
        first_that_draws(&instance(), None, |adapter| {
            Self::unmeasured(adapter, &Restraint::default())
        })
    }

    /// [`Gpu::headless`], restricted to what a lesser adapter can do.
    ///
    /// # Errors
    /// As [`Gpu::headless`].
    pub fn headless_within(restraint: &Restraint) -> Result<Self, GpuError> {
        first_that_draws(&instance(), None, |adapter| Self::of(adapter, restraint))
    }

    /// A device that can draw on a window's surface, and the format of what it draws: colours of 8 bits as they are.
    ///
    /// # Errors
    /// When no driver can draw on it, or the driver cannot do what drawing needs.
    pub fn for_surface(
        instance: &wgpu::Instance,
        surface: &wgpu::Surface<'_>,
    ) -> Result<(Self, TextureFormat), GpuError> {
        let made = first_that_draws(instance, Some(surface), |adapter| {
            let can = surface.get_capabilities(&adapter).formats;
            let gpu = Self::of(adapter, &Restraint::default())?;
            let mut plain = [TextureFormat::Bgra8Unorm, TextureFormat::Rgba8Unorm].into_iter();
            match plain.find(|format| can.contains(format)) {
                Some(format) => Ok((gpu, format)),
                None => Err(gpu.failed(&"the screen takes no 8-bit colours")),
            }
        });
        made.map_err(|error| match error {
            GpuError::NoAdapter => Self::no_window(instance),
            error => error,
        })
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

/// The device of the best adapter; where that fails, of another that draws.
fn first_that_draws<T>(
    instance: &wgpu::Instance,
    surface: Option<&wgpu::Surface<'_>>,
    open: impl Fn(wgpu::Adapter) -> Result<T, GpuError>,
) -> Result<T, GpuError> {
    let best = pollster::block_on(best_adapter(instance, surface))?;
    let info = best.get_info();
    let others = || {
        let all = pollster::block_on(instance.enumerate_adapters(wgpu::Backends::all()));
        let shows = move |other: &wgpu::Adapter| {
            other.get_info() != info && surface.is_none_or(|on| other.is_surface_supported(on))
        };
        let mut others: Vec<_> = all.into_iter().filter(shows).collect();
        others.sort_by_key(|other| other.get_info().device_type == wgpu::DeviceType::Cpu);
        others.into_iter()
    };
    first_that_works(best, others, open)
}

/// What `work` makes of the first item, or else of the first other of which it makes anything. The error is that of the
/// first item.
fn first_that_works<T, R, E: std::fmt::Display, I: Iterator<Item = T>>(
    first: T,
    others: impl FnOnce() -> I,
    work: impl Fn(T) -> Result<R, E>,
) -> Result<R, E> {
    let failed = match work(first) {
        Ok(made) => return Ok(made),
        Err(error) => error,
    };
    log::warn!("{failed}; others are tried");
    others().find_map(|other| work(other).ok()).ok_or(failed)
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

#[cfg(test)]
mod tests {
    use super::first_that_works;
    use std::cell::RefCell;

    /// Adapters are tried in turn until one draws. If none does, the best one's error is told.
    #[test]
    fn the_first_that_works_is_taken() {
        let tried = RefCell::new(Vec::new());
        let first = |works: [bool; 3]| {
            tried.borrow_mut().clear();
            let work = |at: usize| {
                tried.borrow_mut().push(at);
                if works[at] { Ok(at) } else { Err(at) }
            };
            first_that_works(0, || 1..3, work)
        };
        for (works, made, asked) in [
            ([true, true, true], Ok(0), 1),
            ([false, true, true], Ok(1), 2),
            ([false, false, true], Ok(2), 3),
            ([false, false, false], Err(0), 3),
        ] {
            assert_eq!(
                (first(works), tried.borrow().len()),
                (made, asked),
                "{works:?}"
            );
        }
    }
}
