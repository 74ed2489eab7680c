//! The panels' picture, kept from frame to frame: only what looks different is painted again. Software adapters take
//! forty milliseconds for all panels of a window, and next to nothing for a few digits.

use super::damage::damage;
use crate::render::{Gpu, SHADERS};
use egui::{ClippedPrimitive, Pos2, Rect, TextureId, TexturesDelta, epaint::Primitive};
use egui_wgpu::{Renderer, RendererOptions, ScreenDescriptor};
use std::mem;
use wgpu::{BlendState, CommandEncoder, LoadOp, RenderPass, RenderPipeline, TextureFormat};

/// egui's renderer and what it has painted.
pub(super) struct PanelsPicture {
    renderer: Renderer,
    format: TextureFormat,
    over: RenderPipeline,
    empty: RenderPipeline,
    kept: Option<Kept>,
    /// egui's textures that the last frame may still have shown.
    stale: Vec<TextureId>,
}

/// A picture, premultiplied with its alpha, and what was painted there.
struct Kept {
    view: wgpu::TextureView,
    bindings: wgpu::BindGroup,
    size_px: [u32; 2],
    pixels_per_point: f32,
    primitives: Vec<ClippedPrimitive>,
}

impl PanelsPicture {
    /// For frames of this format, as values are.
    pub fn new(gpu: &Gpu, format: TextureFormat) -> Self {
        let source = SHADERS.iter().find(|(name, _)| *name == "panels");
        let source = source.map_or("", |(_, source)| source);
        let shader = gpu
            .device
            .create_shader_module(wgpu::ShaderModuleDescriptor {
                label: Some("panels"),
                source: wgpu::ShaderSource::Wgsl(source.into()),
            });
        let pipeline = |fragment: &str, blend: Option<BlendState>| {
            gpu.device
                .create_render_pipeline(&wgpu::RenderPipelineDescriptor {
                    label: Some(fragment),
                    layout: None,
                    vertex: wgpu::VertexState {
                        module: &shader,
                        entry_point: Some("vertex"),
                        compilation_options: wgpu::PipelineCompilationOptions::default(),
                        buffers: &[],
                    },
                    fragment: Some(wgpu::FragmentState {
                        module: &shader,
                        entry_point: Some(fragment),
                        compilation_options: wgpu::PipelineCompilationOptions::default(),
                        targets: &[Some(wgpu::ColorTargetState {
                            format,
                            blend,
                            write_mask: wgpu::ColorWrites::ALL,
                        })],
                    }),
                    primitive: wgpu::PrimitiveState::default(),
                    depth_stencil: None,
                    multisample: wgpu::MultisampleState::default(),
                    multiview_mask: None,
                    cache: None,
                })
        };
        Self {
            renderer: Renderer::new(&gpu.device, format, RendererOptions::default()),
            format,
            over: pipeline("over", Some(BlendState::PREMULTIPLIED_ALPHA_BLENDING)),
            empty: pipeline("empty", None),
            kept: None,
            stale: Vec::new(),
        }
    }

    /// Takes what came and went among egui's textures. What goes may still be in the next frame, and is freed after it.
    pub fn take_textures(&mut self, gpu: &Gpu, textures: &mut TexturesDelta) {
        for id in mem::take(&mut self.stale) {
            self.renderer.free_texture(&id);
        }
        for (id, deltas) in mem::take(&mut textures.set) {
            // Whatever shows it may look different.
            self.kept = None;
            for delta in deltas {
                self.renderer
                    .update_texture(&gpu.device, &gpu.queue, id, &delta);
            }
        }
        self.stale.extend(mem::take(&mut textures.free));
    }

    /// Draws the panels over what `onto` shows, or over black.
    pub fn draw(
        &mut self,
        gpu: &Gpu,
        onto: &wgpu::TextureView,
        primitives: &[ClippedPrimitive],
        screen: &ScreenDescriptor,
        load: LoadOp<wgpu::Color>,
    ) {
        let mut encoder = gpu
            .device
            .create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
        self.update(gpu, &mut encoder, primitives, screen);
        if let Some(kept) = &self.kept {
            let mut pass = pass(&mut encoder, onto, load);
            pass.set_pipeline(&self.over);
            pass.set_bind_group(0, &kept.bindings, &[]);
            pass.draw(0..3, 0..1);
        }
        gpu.queue.submit([encoder.finish()]);
    }

    /// Brings the picture up to date.
    fn update(
        &mut self,
        gpu: &Gpu,
        encoder: &mut CommandEncoder,
        primitives: &[ClippedPrimitive],
        screen: &ScreenDescriptor,
    ) {
        let ScreenDescriptor {
            size_in_pixels: size_px,
            pixels_per_point,
        } = *screen;
        #[expect(clippy::float_cmp, reason = "the very same")]
        let fits =
            |kept: &Kept| kept.size_px == size_px && kept.pixels_per_point == pixels_per_point;
        let kept = self.kept.take().filter(fits);
        let changed = kept.as_ref().map_or(Rect::EVERYTHING, |kept| {
            damage(&kept.primitives, primitives)
        });
        let mut kept = kept.unwrap_or_else(|| self.kept(gpu, screen));
        if let Some([min, max]) = pixels(changed, screen) {
            let corner = |px: [u32; 2]| {
                #[expect(clippy::cast_precision_loss, reason = "textures are not that large")]
                let [x, y] = px.map(|px| px as f32 / pixels_per_point);
                Pos2::new(x, y)
            };
            let clip = Rect::from_min_max(corner(min), corner(max));
            let painted: Vec<ClippedPrimitive> = primitives
                .iter()
                .filter_map(|primitive| within(primitive, clip))
                .collect();
            let Gpu { device, queue, .. } = gpu;
            self.renderer
                .update_buffers(device, queue, encoder, &painted, screen);
            let mut pass = pass(encoder, &kept.view, LoadOp::Load).forget_lifetime();
            pass.set_scissor_rect(min[0], min[1], max[0] - min[0], max[1] - min[1]);
            pass.set_pipeline(&self.empty);
            pass.draw(0..3, 0..1);
            self.renderer.render(&mut pass, &painted, screen);
            // Where nothing differs, what was painted says the same already.
            kept.primitives = primitives.to_vec();
        }
        self.kept = Some(kept);
    }

    /// An empty picture.
    fn kept(&self, gpu: &Gpu, screen: &ScreenDescriptor) -> Kept {
        let [width, height] = screen.size_in_pixels;
        let texture = gpu.device.create_texture(&wgpu::TextureDescriptor {
            label: Some("panels"),
            size: wgpu::Extent3d {
                width,
                height,
                depth_or_array_layers: 1,
            },
            mip_level_count: 1,
            sample_count: 1,
            dimension: wgpu::TextureDimension::D2,
            format: self.format,
            usage: wgpu::TextureUsages::RENDER_ATTACHMENT | wgpu::TextureUsages::TEXTURE_BINDING,
            view_formats: &[],
        });
        let view = texture.create_view(&wgpu::TextureViewDescriptor::default());
        let bindings = gpu.device.create_bind_group(&wgpu::BindGroupDescriptor {
            label: Some("panels"),
            layout: &self.over.get_bind_group_layout(0),
            entries: &[wgpu::BindGroupEntry {
                binding: 0,
                resource: wgpu::BindingResource::TextureView(&view),
            }],
        });
        Kept {
            view,
            bindings,
            size_px: screen.size_in_pixels,
            pixels_per_point: screen.pixels_per_point,
            primitives: Vec::new(),
        }
    }
}

fn pass<'a>(
    encoder: &'a mut CommandEncoder,
    view: &wgpu::TextureView,
    load: LoadOp<wgpu::Color>,
) -> RenderPass<'a> {
    encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
        label: Some("panels"),
        color_attachments: &[Some(wgpu::RenderPassColorAttachment {
            view,
            depth_slice: None,
            resolve_target: None,
            ops: wgpu::Operations {
                load,
                store: wgpu::StoreOp::Store,
            },
        })],
        ..wgpu::RenderPassDescriptor::default()
    })
}

/// The part of a primitive within a clip; `None` where none of it is.
fn within(primitive: &ClippedPrimitive, clip: Rect) -> Option<ClippedPrimitive> {
    let clip_rect = primitive.clip_rect.intersect(clip);
    let is_in = match &primitive.primitive {
        Primitive::Mesh(mesh) => mesh.calc_bounds().intersects(clip_rect),
        Primitive::Callback(_) => true,
    };
    (clip_rect.is_positive() && is_in).then(|| ClippedPrimitive {
        clip_rect,
        primitive: primitive.primitive.clone(),
    })
}

/// The pixels that a rectangle in points touches, as their least and their end; `None` of none.
fn pixels(rect: Rect, screen: &ScreenDescriptor) -> Option<[[u32; 2]; 2]> {
    if rect.is_negative() {
        return None;
    }
    let [width, height] = screen.size_in_pixels;
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "such conversions saturate, and sizes bound them"
    )]
    let px = |at: Pos2, round: fn(f32) -> f32| {
        let scaled = at * screen.pixels_per_point;
        [
            (round(scaled.x) as u32).min(width),
            (round(scaled.y) as u32).min(height),
        ]
    };
    let [min, max] = [px(rect.min, f32::floor), px(rect.max, f32::ceil)];
    (min[0] < max[0] && min[1] < max[1]).then_some([min, max])
}
