//! Assembles the shaders' sources, and makes modules of them.

use super::gpu::Gpu;

/// WGSL of each shader by name. Shared parts come first.
pub const SHADERS: [(&str, &str); 9] = [
    (
        "mesh by primitive",
        concat!(
            "enable primitive_index;\n",
            include_str!("../../shaders/head.wgsl"),
            include_str!("../../shaders/mesh.wgsl"),
            include_str!("../../shaders/mesh_by_primitive.wgsl")
        ),
    ),
    (
        "mesh by corner",
        concat!(
            include_str!("../../shaders/head.wgsl"),
            include_str!("../../shaders/mesh.wgsl"),
            include_str!("../../shaders/mesh_by_corner.wgsl")
        ),
    ),
    (
        "sphere",
        concat!(
            include_str!("../../shaders/head.wgsl"),
            include_str!("../../shaders/sphere.wgsl")
        ),
    ),
    (
        "overlay",
        concat!(
            include_str!("../../shaders/head.wgsl"),
            include_str!("../../shaders/cover.wgsl"),
            include_str!("../../shaders/overlay.wgsl")
        ),
    ),
    (
        "composite",
        concat!(
            include_str!("../../shaders/cover.wgsl"),
            include_str!("../../shaders/composite.wgsl")
        ),
    ),
    (
        "resolve",
        concat!(
            include_str!("../../shaders/cover.wgsl"),
            include_str!("../../shaders/resolve.wgsl")
        ),
    ),
    (
        "panels",
        concat!(
            include_str!("../../shaders/cover.wgsl"),
            include_str!("../../shaders/panels.wgsl")
        ),
    ),
    (
        "probe by primitive",
        concat!(
            "enable primitive_index;\n",
            include_str!("../../shaders/probe.wgsl"),
            include_str!("../../shaders/probe_by_primitive.wgsl")
        ),
    ),
    (
        "probe by corner",
        concat!(
            include_str!("../../shaders/probe.wgsl"),
            include_str!("../../shaders/probe_by_corner.wgsl")
        ),
    ),
];

/// The parameter that makes a fragment shader run once per sample.
const EACH_SAMPLE: &str = ", @builtin(sample_index) sample: u32";

/// A shader by its name.
pub(crate) fn shader_module(gpu: &Gpu, name: &str) -> wgpu::ShaderModule {
    let found = SHADERS.iter().find(|(other, _)| *other == name);
    let source = found.map_or("", |(_, text)| text);
    let source = if gpu.smooth_samples() > 1 {
        source.into()
    } else {
        // An adapter without multisampling refuses this parameter.
        source.replace(EACH_SAMPLE, "").into()
    };
    gpu.device
        .create_shader_module(wgpu::ShaderModuleDescriptor {
            label: Some(name),
            source: wgpu::ShaderSource::Wgsl(source),
        })
}
