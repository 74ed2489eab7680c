//! Draws a scene's colours and ids: the render passes, and the draw calls in them.

use super::{
    Onto, Renderer,
    batches::Draw,
    bindings,
    gpu::{Gpu, GpuError},
    lines::{Line, LineBuffer},
    mesh_buffers::SOFTWARE_CALL,
    pipelines::{BATCHES, Drawn, Pass, World},
    resolve::Resolve,
    scene_buffers::SceneBuffers,
    shader_structs,
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
    /// Draws colours and ids of the scene as `view` shows it, with as many samples per pixel as the targets have. Lines
    /// are in the colours only. Needed when scene, view or lines changed.
    ///
    /// # Errors
    /// When memory runs out.
    ///
    /// # Panics
    /// When `targets` have another size than the view, or other samples than this renderer.
    pub fn draw(&mut self, onto: Onto<'_>, lines: &[Line]) -> Result<(), GpuError> {
        let passes: &[Pass] = match onto.1.samples {
            1 => &[Pass::ColourAndIds],
            _ => &[Pass::Colour, Pass::Ids],
        };
        self.draw_passes(onto, passes, lines)
    }

    /// The same with one sample per pixel, whatever the targets have, in one pass.
    ///
    /// # Errors
    /// As [`Renderer::draw`].
    ///
    /// # Panics
    /// As [`Renderer::draw`].
    pub fn draw_rough(&mut self, onto: Onto<'_>, lines: &[Line]) -> Result<(), GpuError> {
        self.draw_passes(onto, &[Pass::ColourAndIds], lines)
    }

    /// Draws smooth colours alone, for targets of several samples that have the ids already.
    ///
    /// # Errors
    /// As [`Renderer::draw`].
    ///
    /// # Panics
    /// As [`Renderer::draw`].
    pub fn draw_colours(&mut self, onto: Onto<'_>, lines: &[Line]) -> Result<(), GpuError> {
        self.draw_passes(onto, &[Pass::Colour], lines)
    }

    fn draw_passes(
        &mut self,
        (scene, targets, view): Onto<'_>,
        passes: &[Pass],
        lines: &[Line],
    ) -> Result<(), GpuError> {
        self.check(targets, view);
        let gpu = &self.gpu;
        let (seen, world) = (scene.seen_in(view), World::of(scene.ndc.as_ref(), view));
        let edged = match self.wireframe {
            None => Vec::new(),
            Some(Wireframe::OfAll) => seen.draws.clone(),
            Some(Wireframe::Of(object)) => scene.alone(view, object),
        };
        self.write_frame(scene, view);
        let bindings = self.bind(scene, &scene.tables.spheres);
        let lines = LineBuffer::new(gpu, view, lines, self.background)?;
        for &pass in passes {
            let edges = edged.iter().filter(|draw| draw.buffers.is_some());
            let edges = edges.map(|draw| (Drawn::Edges, draw));
            let draws = seen.draws.iter().map(|draw| (surface(draw, view), draw));
            let draws: Vec<_> = draws.chain(edges.filter(|_| pass.has_colours())).collect();
            let shares = shares(gpu, &draws);
            let mut pipeline = |drawn| self.pipelines.get(gpu, pass, drawn, view, world);
            for (at, share) in shares.iter().enumerate() {
                let [is_first, is_last] = [at == 0, at + 1 == shares.len()];
                gpu.submit(|encoder| {
                    let mut render_pass =
                        begin(gpu, encoder, targets, view, pass, [is_first, is_last]);
                    render_pass.set_bind_group(0, &bindings, &[]);
                    render_pass.set_vertex_buffer(BATCHES, scene.tables.triangles.slice(..));
                    for (drawn, draw) in *share {
                        render_pass.set_pipeline(&pipeline(*drawn));
                        draw.record(&mut render_pass);
                    }
                    if !is_last || !pass.has_colours() {
                        return;
                    }
                    // After all surfaces, where none is.
                    render_pass.set_pipeline(&pipeline(Drawn::Background));
                    render_pass.draw(0..3, 0..1);
                    if lines.count > 0 {
                        render_pass.set_pipeline(&pipeline(Drawn::Lines));
                        lines.record(&mut render_pass);
                    }
                    drop(render_pass);
                    if pass == Pass::Colour && !gpu.resolves() {
                        let resolve = self.resolve.get_or_init(|| Resolve::new(gpu));
                        resolve.encode(gpu, encoder, targets);
                    }
                });
                if !is_last {
                    gpu.wait()?;
                }
            }
        }
        Ok(())
    }

    pub(super) fn check(&self, targets: &Targets, view: &View) {
        assert_eq!(targets.viewport, view.viewport, "targets fit the view");
        let samples = self.pipelines.samples;
        assert_eq!(targets.samples, samples, "targets fit the renderer");
    }

    /// Writes the numbers that all of a frame shares to the GPU.
    pub(super) fn write_frame(&self, scene: &SceneBuffers, view: &View) {
        let bytes = match &scene.ndc {
            Some(ndc) => transform::frame_in_ndc(ndc, view, self.background),
            None => transform::frame(view, self.background),
        };
        let bytes = shader_structs::Frame {
            line_half_px: 0.5 * self.scale_factor.max(1.0),
            ..bytes
        };
        let bytes = bytemuck::bytes_of(&bytes);
        self.gpu.queue.write_buffer(&self.frame, 0, bytes);
    }

    /// The bind group of frame, objects and a table: spheres, or pixels' depths.
    pub(super) fn bind(&self, scene: &SceneBuffers, table: &wgpu::Buffer) -> wgpu::BindGroup {
        let resources = [&self.frame, &scene.objects, table].map(wgpu::Buffer::as_entire_binding);
        let layout = &self.pipelines.bind_group_layout;
        bindings::bind(&self.gpu, "scene", layout, resources)
    }
}

/// The calls that are submitted together: all, but on a software adapter about [`SOFTWARE_CALL`] triangles at a time.
/// There is at least one share, which may be empty.
fn shares<'a, 'd>(gpu: &Gpu, draws: &'a [(Drawn, &'d Draw)]) -> Vec<&'a [(Drawn, &'d Draw)]> {
    let mut shares = vec![draws];
    let mut work = 0;
    let mut first = 0;
    for (at, (_, draw)) in draws.iter().enumerate().filter(|_| gpu.is_software()) {
        if work + draw.triangle_count() > SOFTWARE_CALL && work > 0 {
            shares.pop();
            shares.extend([&draws[first..at], &draws[at..]]);
            (first, work) = (at, 0);
        }
        work += draw.triangle_count();
    }
    shares
}

/// The kind of surfaces that a call draws.
fn surface(draw: &Draw, view: &View) -> Drawn {
    match draw.buffers {
        Some(_) => Drawn::Triangles {
            culled_mirrored: (view.sides == Sides::Front).then_some(draw.mirrors),
        },
        None => Drawn::Spheres,
    }
}

/// Begins a pass over the whole picture, or one of several. The first clears to "nothing there". In the last, samples
/// are resolved, if the adapter does that ([`Gpu::resolves`]).
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
                store: match resolve_target {
                    Some(_) => Discard,
                    None => Store,
                },
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
                store: if is_last { Discard } else { Store },
            }),
            stencil_ops: None,
        }),
        ..Default::default()
    })
}
