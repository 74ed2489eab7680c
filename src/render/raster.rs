//! Draws the scene's colours and ids: the render passes, and the draw calls in them.

use super::{
    Renderer,
    batches::DrawnShape,
    bindings,
    composing::Draw,
    gpu::Gpu,
    pipelines::{Drawn, Pass},
    scene_buffers::SceneBuffers,
    shader_structs::Frame,
    slices::Slice,
    targets::Targets,
    transform,
};
use crate::{
    camera::{DepthMapping, View},
    geometry::Sides,
};

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
        assert_eq!(targets.viewport(), view.viewport, "targets fit the view");
        assert_eq!(
            targets.samples(),
            self.pipelines.samples(),
            "targets fit the renderer"
        );
    }

    /// Writes the numbers that all of a frame shares to the GPU.
    pub(super) fn write_frame(&self, gpu: &Gpu, view: &View) {
        let frame: Frame = transform::frame(view);
        gpu.queue
            .write_buffer(&self.frame, 0, bytemuck::bytes_of(&frame));
    }

    /// The bind group of frame, objects and spheres.
    pub(super) fn bind(&self, gpu: &Gpu, scene: &SceneBuffers) -> wgpu::BindGroup {
        let buffers = [&self.frame, &scene.objects, &scene.tables().spheres];
        let resources = buffers.map(wgpu::Buffer::as_entire_binding);
        bindings::bind(gpu, "scene", &self.pipelines.bind_group_layout, resources)
    }

    /// Draws the edges of some triangles of some instances where their faces are seen.
    pub(super) fn draw_edges(
        &mut self,
        gpu: &Gpu,
        pass: &mut wgpu::RenderPass<'_>,
        writes: Pass,
        view: &View,
        draw: &Draw,
        slice: &Slice,
    ) {
        if let DrawnShape::Triangles { buffers, .. } = &draw.shape {
            pass.set_pipeline(&self.pipelines.get(gpu, writes, Drawn::Edges, view));
            buffers.draw(pass, &slice.triangles, slice.instances.clone());
        }
    }

    /// Draws some triangles, or spheres, of some instances of a draw.
    pub(super) fn draw_slice(
        &mut self,
        gpu: &Gpu,
        pass: &mut wgpu::RenderPass<'_>,
        writes: Pass,
        view: &View,
        draws: &[Draw],
        slice: &Slice,
    ) {
        let draw = &draws[slice.draw];
        let instances = slice.instances.clone();
        match &draw.shape {
            DrawnShape::Triangles { buffers, .. } => {
                let culled_mirrored = (view.sides == Sides::Front).then_some(draw.mirrors);
                let drawn = Drawn::Triangles { culled_mirrored };
                pass.set_pipeline(&self.pipelines.get(gpu, writes, drawn, view));
                buffers.draw(pass, &slice.triangles, instances);
            }
            DrawnShape::Spheres => {
                pass.set_pipeline(&self.pipelines.get(gpu, writes, Drawn::Spheres, view));
                pass.draw(0..4, instances);
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
                store: if resolve_target.is_some() {
                    wgpu::StoreOp::Discard
                } else {
                    wgpu::StoreOp::Store
                },
            },
        })
    };
    let (colours, depth_view) = match (&targets.multisampled, writes) {
        (Some([colour, depth]), Pass::Colour) => {
            (vec![attach(colour, Some(&targets.colour_view))], depth)
        }
        (_, Pass::Ids) => (vec![attach(&targets.ids_view, None)], &targets.depth_view),
        _ => (
            vec![
                attach(&targets.colour_view, None),
                attach(&targets.ids_view, None),
            ],
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
                store: if is_last {
                    wgpu::StoreOp::Discard
                } else {
                    wgpu::StoreOp::Store
                },
            }),
            stencil_ops: None,
        }),
        ..Default::default()
    })
}
