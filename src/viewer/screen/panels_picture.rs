//! The panels' picture, kept from frame to frame: it is painted again when anything in it looks different.

use super::place::SceneRect;
use crate::render::{
    Gpu,
    bindings::bind,
    shader_module,
    without_depth::{self, extent},
};
use egui::{
    ClippedPrimitive, TextureId, TexturesDelta,
    epaint::{ImageDelta, Primitive},
};
use egui_wgpu::{Renderer, RendererOptions, ScreenDescriptor};
use std::{mem, sync::Arc};
use wgpu::{BlendState, RenderPipeline, TextureFormat, TextureViewDescriptor};

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

/// The picture, with premultiplied alpha, and what was painted there.
struct Kept {
    view: wgpu::TextureView,
    bindings: wgpu::BindGroup,
    size_px: [u32; 2],
    pixels_per_point: f32,
    primitives: Arc<[ClippedPrimitive]>,
}

impl PanelsPicture {
    /// A picture for frames of this format, without conversion to sRGB.
    pub fn new(gpu: &Gpu, format: TextureFormat) -> Self {
        let shader = shader_module(gpu, "panels");
        let pipeline = |fragment, blend| {
            let target = wgpu::ColorTargetState {
                blend,
                ..format.into()
            };
            without_depth::pipeline(gpu, None, &shader, ["cover", fragment], target)
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

    /// Applies the changes of egui's textures. A dropped texture may still be in the next frame, and is freed after it.
    pub fn take_textures(&mut self, gpu: &Gpu, textures: &mut TexturesDelta) {
        for id in mem::take(&mut self.stale) {
            self.renderer.free_texture(&id);
        }
        for (id, deltas) in mem::take(&mut textures.set) {
            // A partial update brings new glyphs, which nothing shows yet. After a whole one, anything may look
            // different.
            if deltas.iter().any(ImageDelta::is_whole) {
                self.kept = None;
            }
            for delta in deltas {
                self.renderer
                    .update_texture(&gpu.device, &gpu.queue, id, &delta);
            }
        }
        self.stale.extend(mem::take(&mut textures.free));
    }

    /// Brings the picture up to date. Returns whether it was painted again.
    pub fn update(
        &mut self,
        gpu: &Gpu,
        primitives: &Arc<[ClippedPrimitive]>,
        screen: &ScreenDescriptor,
    ) -> bool {
        let (size_px, pixels_per_point) = (screen.size_in_pixels, screen.pixels_per_point);
        #[expect(clippy::float_cmp, reason = "the very same")]
        let fits =
            |kept: &Kept| kept.size_px == size_px && kept.pixels_per_point == pixels_per_point;
        let kept = self.kept.take().filter(fits);
        let is_same = kept
            .as_ref()
            .is_some_and(|kept| are_same(&kept.primitives, primitives));
        let new = || Kept::new(gpu, &self.over, self.format, screen);
        let kept = self.kept.insert(kept.unwrap_or_else(new));
        if is_same {
            return false;
        }
        gpu.submit(|encoder| {
            self.renderer
                .update_buffers(&gpu.device, &gpu.queue, encoder, primitives, screen);
            let mut pass = without_depth::begin(encoder, &kept.view, false).forget_lifetime();
            pass.set_pipeline(&self.empty);
            pass.draw(0..3, 0..1);
            self.renderer.render(&mut pass, primitives, screen);
        });
        kept.primitives = primitives.clone();
        true
    }

    /// Copies the picture onto a texture of its size, without blending.
    pub fn copy(&self, gpu: &Gpu, onto: &wgpu::Texture) {
        let Some(kept) = &self.kept else { return };
        gpu.submit(|encoder| {
            let [from, to] = [kept.view.texture(), onto].map(wgpu::Texture::as_image_copy);
            encoder.copy_texture_to_texture(from, to, extent(kept.size_px));
        });
    }

    /// Blends the picture over a place. While a window changes its size, a place may reach beyond it.
    pub fn draw_over(&self, gpu: &Gpu, onto: &wgpu::Texture, place: SceneRect) {
        let Some(kept) = &self.kept else { return };
        gpu.submit(|encoder| {
            let view = onto.create_view(&TextureViewDescriptor::default());
            let mut pass = without_depth::begin(encoder, &view, false);
            pass.set_pipeline(&self.over);
            pass.set_bind_group(0, &kept.bindings, &[]);
            let [x, y] = place.origin_px;
            let width = place
                .viewport
                .width()
                .min(kept.size_px[0].saturating_sub(x));
            let height = place
                .viewport
                .height()
                .min(kept.size_px[1].saturating_sub(y));
            if width > 0 && height > 0 {
                pass.set_scissor_rect(x, y, width, height);
                pass.draw(0..3, 0..1);
            }
        });
    }

    /// Draws a whole frame onto a texture that cannot be copied to.
    pub fn draw_page(&self, gpu: &Gpu, page: &wgpu::Texture, onto: &wgpu::Texture) {
        let [page, onto] =
            [page, onto].map(|texture| texture.create_view(&TextureViewDescriptor::default()));
        gpu.submit(|encoder| {
            let mut pass = without_depth::begin(encoder, &onto, true);
            pass.set_pipeline(&self.over);
            pass.set_bind_group(0, &bindings(gpu, &self.over, &page), &[]);
            pass.draw(0..3, 0..1);
        });
    }
}

impl Kept {
    /// An empty picture.
    fn new(
        gpu: &Gpu,
        over: &RenderPipeline,
        format: TextureFormat,
        screen: &ScreenDescriptor,
    ) -> Self {
        let size_px = screen.size_in_pixels;
        let usage = wgpu::TextureUsages::TEXTURE_BINDING | wgpu::TextureUsages::COPY_SRC;
        let texture = without_depth::texture(gpu, "panels", size_px, format, 1, usage, &[]);
        let view = texture.create_view(&TextureViewDescriptor::default());
        Self {
            bindings: bindings(gpu, over, &view),
            view,
            size_px,
            pixels_per_point: screen.pixels_per_point,
            primitives: Arc::default(),
        }
    }
}

fn bindings(gpu: &Gpu, over: &RenderPipeline, picture: &wgpu::TextureView) -> wgpu::BindGroup {
    let resource = wgpu::BindingResource::TextureView(picture);
    let layout = over.get_bind_group_layout(0);
    bind(gpu, "panels", &layout, [resource])
}

/// Whether two frames' triangles are the same.
fn are_same(before: &[ClippedPrimitive], now: &[ClippedPrimitive]) -> bool {
    let is_same = |(before, now): (&ClippedPrimitive, &ClippedPrimitive)| match (
        &before.primitive,
        &now.primitive,
    ) {
        (Primitive::Mesh(was), Primitive::Mesh(is)) => {
            before.clip_rect == now.clip_rect && was == is
        }
        _ => false,
    };
    before.len() == now.len() && before.iter().zip(now).all(is_same)
}
