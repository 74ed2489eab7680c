//! Makes bind groups, their layouts, and the layouts of pipelines with one bind group.

use super::gpu::Gpu;
use wgpu::{BindGroupEntry, BindGroupLayoutEntry, BindingResource, BindingType};

/// The layout of bind groups with bindings of these types, numbered from 0, and that of pipelines with one such group.
pub(super) fn layouts(
    gpu: &Gpu,
    label: &str,
    visibility: wgpu::ShaderStages,
    types: &[BindingType],
) -> (wgpu::BindGroupLayout, wgpu::PipelineLayout) {
    let entry = |(binding, ty): (u32, &BindingType)| BindGroupLayoutEntry {
        binding,
        visibility,
        ty: *ty,
        count: None,
    };
    let entries: Vec<_> = (0..).zip(types).map(entry).collect();
    let group = (gpu.device).create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor {
        label: Some(label),
        entries: &entries,
    });
    let pipeline = (gpu.device).create_pipeline_layout(&wgpu::PipelineLayoutDescriptor {
        label: Some(label),
        bind_group_layouts: &[Some(&group)],
        immediate_size: 0,
    });
    (group, pipeline)
}

/// The binding type of a whole buffer.
pub(super) fn buffer(ty: wgpu::BufferBindingType) -> BindingType {
    BindingType::Buffer {
        ty,
        has_dynamic_offset: false,
        min_binding_size: None,
    }
}

/// A bind group of these resources, numbered from 0.
pub(crate) fn bind<'a>(
    gpu: &Gpu,
    label: &str,
    layout: &wgpu::BindGroupLayout,
    resources: impl IntoIterator<Item = BindingResource<'a>>,
) -> wgpu::BindGroup {
    let entry = |(binding, resource)| BindGroupEntry { binding, resource };
    let entries: Vec<_> = (0..).zip(resources).map(entry).collect();
    gpu.device.create_bind_group(&wgpu::BindGroupDescriptor {
        label: Some(label),
        layout,
        entries: &entries,
    })
}
