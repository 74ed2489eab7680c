//! The multisample resolve as a shader, for software adapters: others have a circuit for it. Lavapipe (Mesa 22.3)
//! compiles its built-in resolve anew in each process, which takes longer than drawing a small scene. It compiles a
//! shader once and keeps it on disk.

use super::{
    bindings, formats::COLOUR, gpu::Gpu, shaders::shader_module, targets::Targets, without_depth,
};

/// The pass that resolves samples, where the adapter is software.
#[derive(Debug)]
pub(super) struct Resolve {
    bind_group_layout: wgpu::BindGroupLayout,
    pipeline: wgpu::RenderPipeline,
}

impl Resolve {
    pub fn new(gpu: &Gpu) -> Self {
        let samples = wgpu::BindingType::Texture {
            sample_type: wgpu::TextureSampleType::Float { filterable: false },
            view_dimension: wgpu::TextureViewDimension::D2,
            multisampled: true,
        };
        let (bind_group_layout, layout) =
            bindings::layouts(gpu, "resolve", wgpu::ShaderStages::FRAGMENT, &[samples]);
        let module = shader_module(gpu, "resolve");
        let entries = ["cover", "resolve"];
        let pipeline = without_depth::pipeline(gpu, Some(&layout), &module, entries, COLOUR.into());
        Self {
            bind_group_layout,
            pipeline,
        }
    }

    /// Resolves all samples of the colours. Does nothing for targets with one sample per pixel.
    pub fn encode(&self, gpu: &Gpu, encoder: &mut wgpu::CommandEncoder, targets: &Targets) {
        let Some([samples, ..]) = &targets.multisampled else {
            return;
        };
        let samples = wgpu::BindingResource::TextureView(samples);
        let bind_group = bindings::bind(gpu, "resolve", &self.bind_group_layout, [samples]);
        let mut pass = without_depth::begin(encoder, &targets.colour_view, without_depth::CLEAR);
        pass.set_pipeline(&self.pipeline);
        pass.set_bind_group(0, &bind_group, &[]);
        pass.draw(0..3, 0..1);
    }
}
