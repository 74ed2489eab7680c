//! The panels' picture, kept from frame to frame: only what looks different is painted again. Software adapters take
//! forty milliseconds for all panels of a window, and next to nothing for a few digits.

use super::{
    damage::{damage, disjoint},
    panel_tiles::PanelTiles,
    place::{PixelRect, SceneRect},
};
use crate::render::{
    Gpu,
    bindings::bind,
    shader_module,
    without_depth::{self, at, extent},
};
use egui::{
    ClippedPrimitive, Pos2, Rect, TextureId, TexturesDelta,
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
    /// Where the picture is not empty.
    tiles: PanelTiles,
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

    /// Brings the picture up to date. Returns its rectangles that changed, each as its first pixel and the one past its
    /// last.
    pub fn update(
        &mut self,
        gpu: &Gpu,
        primitives: &Arc<[ClippedPrimitive]>,
        screen: &ScreenDescriptor,
    ) -> Vec<PixelRect> {
        let (size_px, pixels_per_point) = (screen.size_in_pixels, screen.pixels_per_point);
        #[expect(clippy::float_cmp, reason = "the very same")]
        let fits =
            |kept: &Kept| kept.size_px == size_px && kept.pixels_per_point == pixels_per_point;
        let kept = self.kept.take().filter(fits);
        let changed = match &kept {
            Some(kept) => damage(&kept.primitives, primitives),
            None => vec![Rect::EVERYTHING],
        };
        let new = || Kept::new(gpu, &self.over, self.format, screen);
        let kept = self.kept.insert(kept.unwrap_or_else(new));
        let rects = disjoint(changed.into_iter().filter_map(|rect| pixels(rect, screen)));
        if rects.is_empty() {
            // Nothing looks different.
            return rects;
        }
        let corner = |px: [u32; 2]| {
            #[expect(clippy::cast_precision_loss, reason = "textures are not that large")]
            let [x, y] = px.map(|px| px as f32 / pixels_per_point);
            Pos2::new(x, y)
        };
        let mut painted = Vec::new();
        for &[min, max] in &rects {
            let clip = Rect::from_min_max(corner(min), corner(max));
            let within = |primitive| within(primitive, clip);
            painted.extend(primitives.iter().filter_map(within));
        }
        gpu.submit(|encoder| {
            self.renderer
                .update_buffers(&gpu.device, &gpu.queue, encoder, &painted, screen);
            let mut pass = without_depth::begin(encoder, &kept.view, false).forget_lifetime();
            pass.set_pipeline(&self.empty);
            for &[min, max] in &rects {
                pass.set_scissor_rect(min[0], min[1], max[0] - min[0], max[1] - min[1]);
                pass.draw(0..3, 0..1);
            }
            self.renderer.render(&mut pass, &painted, screen);
        });
        kept.primitives = primitives.clone();
        kept.tiles = PanelTiles::under(primitives, screen);
        rects
    }

    /// Copies pixels of the picture onto a texture, without blending.
    pub fn copy(&self, gpu: &Gpu, onto: &wgpu::Texture, rects: &[PixelRect]) {
        let Some(kept) = &self.kept else { return };
        gpu.submit(|encoder| {
            for &[[x, y], [right, bottom]] in rects {
                let [from, to] = [kept.view.texture(), onto].map(|texture| at(texture, [x, y]));
                let size = extent([right - x, bottom - y]);
                encoder.copy_texture_to_texture(from, to, size);
            }
        });
    }

    /// Blends the picture over a place, where it is not empty.
    pub fn draw_over(&self, gpu: &Gpu, onto: &wgpu::Texture, place: SceneRect) {
        let Some(kept) = &self.kept else { return };
        gpu.submit(|encoder| {
            let view = onto.create_view(&TextureViewDescriptor::default());
            let mut pass = without_depth::begin(encoder, &view, false);
            pass.set_pipeline(&self.over);
            pass.set_bind_group(0, &kept.bindings, &[]);
            for [x, y, width, height] in kept.tiles.runs(place) {
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
            tiles: PanelTiles::default(),
        }
    }
}

fn bindings(gpu: &Gpu, over: &RenderPipeline, picture: &wgpu::TextureView) -> wgpu::BindGroup {
    let resource = wgpu::BindingResource::TextureView(picture);
    let layout = over.get_bind_group_layout(0);
    bind(gpu, "panels", &layout, [resource])
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

/// The pixels that a rectangle in points touches; `None` if there are none.
fn pixels(rect: Rect, screen: &ScreenDescriptor) -> Option<PixelRect> {
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
