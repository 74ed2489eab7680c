//! Assembles the shaders' sources, and makes modules of them.

use super::gpu::Gpu;

/// The text of files in `shaders/`, one after the other.
macro_rules! wgsl {
    ($($name:literal),*) => {
        concat!($(include_str!(concat!("../../shaders/", $name, ".wgsl"))),*)
    };
}

/// Allows a shader to number triangles by the adapter's index.
macro_rules! indexed {
    ($($name:literal),*) => { concat!("enable primitive_index;\n", wgsl!($($name),*)) };
}

/// WGSL of each shader by name. Shared parts come first.
pub const SHADERS: [(&str, &str); 8] = [
    (
        "mesh by primitive",
        indexed!("head", "luminance", "mesh", "mesh_by_primitive"),
    ),
    (
        "mesh by corner",
        wgsl!("head", "luminance", "mesh", "mesh_by_corner"),
    ),
    ("sphere", wgsl!("head", "sphere")),
    (
        "background and lines",
        wgsl!("head", "cover", "background_and_lines"),
    ),
    ("marks", wgsl!("cover", "luminance", "marks")),
    ("resolve", wgsl!("cover", "resolve")),
    (
        "probe by primitive",
        indexed!("probe", "probe_by_primitive"),
    ),
    ("probe by corner", wgsl!("probe", "probe_by_corner")),
];

/// A shader by its name.
pub(crate) fn shader_module(gpu: &Gpu, name: &str) -> wgpu::ShaderModule {
    let found = SHADERS.iter().find(|(other, _)| *other == name);
    let source = found.map_or("", |(_, text)| text);
    gpu.device
        .create_shader_module(wgpu::ShaderModuleDescriptor {
            label: Some(name),
            source: wgpu::ShaderSource::Wgsl(source.into()),
        })
}
