//! Lists the adapters of this machine and what each can do, for `sightline doctor`.

use super::{
    abilities::{Numbers, Restraint},
    gpu::{Gpu, GpuError},
    open::{best_adapter, instance},
    rasteriser::Rasteriser,
};

/// An adapter that was found.
#[derive(Clone, Debug)]
pub struct AdapterFound {
    /// What it calls itself.
    pub name: String,
    /// Its kind: integrated, discrete, software.
    pub kind: &'static str,
    /// The API that reaches it, such as `vulkan`.
    pub backend: &'static str,
    /// Its driver, with the version.
    pub driver: String,
    /// The ids of vendor and device.
    pub numbers: [u32; 2],
    /// Whether it is the one that draws without a window.
    pub is_used: bool,
    /// What it can do, or why it cannot draw.
    pub can: Result<AdapterCan, GpuError>,
}

/// Abilities in which adapters differ.
#[derive(Clone, Copy, Debug)]
pub struct AdapterCan {
    /// How ids name triangles.
    pub numbers: Numbers,
    /// Its rasteriser, as measured.
    pub rasteriser: Rasteriser,
    /// The largest side of a picture, in pixels.
    pub max_side_px: u32,
    /// The largest part of a mesh, in bytes; larger ones are split.
    pub max_buffer_bytes: u64,
    /// The largest table of objects, in bytes.
    pub max_table_bytes: u64,
}

/// All adapters, in the order in which the system names them. `WGPU_BACKEND` narrows the choice, as everywhere in wgpu.
pub fn adapters() -> Vec<AdapterFound> {
    let instance = instance();
    let used = pollster::block_on(best_adapter(&instance, None));
    let best = used.map(|adapter| adapter.get_info());
    let all = pollster::block_on(instance.enumerate_adapters(wgpu::Backends::all()));
    let mut found: Vec<_> = (all.into_iter())
        .map(|adapter| {
            let info = adapter.get_info();
            let driver = [info.driver.as_str(), info.driver_info.as_str()];
            let driver = driver.map(str::trim).join(" ");
            AdapterFound {
                kind: kind(info.device_type),
                backend: info.backend.to_str(),
                driver: driver.trim().to_owned(),
                numbers: [info.vendor, info.device],
                is_used: best.as_ref().is_ok_and(|best| *best == info),
                name: info.name,
                can: Gpu::of(adapter, &Restraint::default()).map(|gpu| can(&gpu)),
            }
        })
        .collect();
    // Where the best one fails, the first other that draws takes its place, those on the CPU last.
    let fails = |found: &AdapterFound| found.is_used && found.can.is_err();
    let draws = |at: &usize| found[*at].can.is_ok();
    if let (Some(best), Some(other)) = (
        found.iter().position(fails),
        (0..found.len())
            .filter(draws)
            .min_by_key(|at| found[*at].kind == "software"),
    ) {
        (found[best].is_used, found[other].is_used) = (false, true);
    }
    found
}

fn can(gpu: &Gpu) -> AdapterCan {
    let limits = gpu.device.limits();
    AdapterCan {
        numbers: gpu.numbers,
        rasteriser: gpu.rasteriser(),
        max_side_px: limits.max_texture_dimension_2d,
        max_buffer_bytes: limits.max_buffer_size,
        max_table_bytes: limits.max_storage_buffer_binding_size,
    }
}

fn kind(of: wgpu::DeviceType) -> &'static str {
    match of {
        wgpu::DeviceType::IntegratedGpu => "integrated",
        wgpu::DeviceType::DiscreteGpu => "discrete",
        wgpu::DeviceType::VirtualGpu => "virtual",
        wgpu::DeviceType::Cpu => "software",
        wgpu::DeviceType::Other => "of another kind",
    }
}
