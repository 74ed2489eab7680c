//! Draws the scene's colours and ids: the render passes, and the draw calls in them.

use super::{
    Renderer, bindings,
    gpu::Gpu,
    pipelines::{Drawn, Pass, Pipelines},
    scene_buffers::SceneBuffers,
    shader_structs::Frame,
    steps::{Parts, Step},
    targets::Targets,
    transform,
};
use crate::{
    camera::{DepthMapping, View},
    geometry::Sides,
};
use wgpu::StoreOp::{Discard, Store};

/// The objects whose triangles' edges are drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Wireframe {
    /// All objects that have triangles.
    OfAll,
    /// The object with this index.
    Of(usize),
}

impl Renderer {
    pub(super) fn check(&self, targets: &Targets, view: &View) {
        assert_eq!(targets.viewport, view.viewport, "targets fit the view");
        let samples = self.pipelines.samples;
        assert_eq!(targets.samples, samples, "targets fit the renderer");
    }

    /// Writes the numbers that all of a frame shares to the GPU.
    pub(super) fn write_frame(&self, view: &View) {
        let frame: Frame = transform::frame(view);
        let bytes = bytemuck::bytes_of(&frame);
        self.gpu.queue.write_buffer(&self.frame, 0, bytes);
    }

    /// The bind group of frame, objects and a table: spheres, or pixels' depths.
    pub(super) fn bind(&self, scene: &SceneBuffers, table: &wgpu::Buffer) -> wgpu::BindGroup {
        let resources = [&self.frame, &scene.objects, table].map(wgpu::Buffer::as_entire_binding);
        let layout = &self.pipelines.bind_group_layout;
        bindings::bind(&self.gpu, "scene", layout, resources)
    }
}

impl Pipelines {
    /// Draws the surfaces of a step, and edges of triangles where their faces are seen.
    pub(super) fn draw_step(
        &mut self,
        gpu: &Gpu,
        pass: &mut wgpu::RenderPass<'_>,
        writes: Pass,
        view: &View,
        parts: &Parts<'_>,
        step: &Step,
    ) {
        for slice in &step.surfaces {
            let kind = &parts.surfaces[slice.draw].kind;
            let culled_mirrored = (view.sides == Sides::Front).then_some(kind.mirrors);
            let drawn = match kind.buffers {
                Some(_) => Drawn::Triangles { culled_mirrored },
                None => Drawn::Spheres,
            };
            pass.set_pipeline(&self.get(gpu, writes, drawn, view));
            kind.draw(pass, &slice.triangles, slice.instances.clone());
        }
        for slice in &step.edges {
            let kind = &parts.edged[slice.draw].kind;
            if kind.buffers.is_some() {
                pass.set_pipeline(&self.get(gpu, writes, Drawn::Edges, view));
                kind.draw(pass, &slice.triangles, slice.instances.clone());
            }
        }
    }
}

/// Begins a pass over the whole picture, or a piece of one. The first piece clears to "nothing there". The last piece
/// resolves samples, if the adapter does ([`Gpu::resolves`]).
pub(super) fn begin<'a>(
    gpu: &Gpu,
    encoder: &'a mut wgpu::CommandEncoder,
    targets: &Targets,
    view: &View,
    writes: Pass,
    [is_first, is_last]: [bool; 2],
) -> wgpu::RenderPass<'a> {
    let stored_if = |is_of_use| if is_of_use { Store } else { Discard };
    let attach = |view, resolve_target: Option<_>| {
        let resolve_target = resolve_target.filter(|_| is_last && gpu.resolves());
        Some(wgpu::RenderPassColorAttachment {
            view,
            depth_slice: None,
            resolve_target,
            ops: wgpu::Operations {
                load: if is_first {
                    wgpu::LoadOp::Clear(wgpu::Color::TRANSPARENT)
                } else {
                    wgpu::LoadOp::Load
                },
                // Samples are of no use once they are resolved.
                store: stored_if(resolve_target.is_none()),
            },
        })
    };
    let [colour, ids] = [&targets.colour_view, &targets.ids_view];
    let (colours, depth_view) = match (&targets.multisampled, writes) {
        (Some([samples, depth]), Pass::Colour) => (vec![attach(samples, Some(colour))], depth),
        (_, Pass::Ids) => (vec![attach(ids, None)], &targets.depth_view),
        _ => (
            vec![attach(colour, None), attach(ids, None)],
            &targets.depth_view,
        ),
    };
    encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
        label: Some("scene"),
        color_attachments: &colours,
        depth_stencil_attachment: Some(wgpu::RenderPassDepthStencilAttachment {
            view: depth_view,
            depth_ops: Some(wgpu::Operations {
                load: match view.camera.lens().depth {
                    _ if !is_first => wgpu::LoadOp::Load,
                    DepthMapping::Reversed => wgpu::LoadOp::Clear(0.0),
                    DepthMapping::Standard => wgpu::LoadOp::Clear(1.0),
                },
                store: stored_if(!is_last),
            }),
            stencil_ops: None,
        }),
        ..Default::default()
    })
}
