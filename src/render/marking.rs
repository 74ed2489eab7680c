//! Marks a picture: draws the selection's outline, and a copy of the colours with what is selected or lit, so that a
//! mouse move does not draw the scene again.

use super::{
    Onto, Renderer, bindings,
    formats::{COLOUR, MARKS},
    gpu::Gpu,
    scene_buffers::Place,
    shader_structs,
    shaders::shader_module,
    targets::Targets,
    without_depth,
};
use crate::{camera::View, look};
use glam::DVec2;
use std::collections::HashMap;

/// What is marked in a picture.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Marks {
    /// Index of the selected object: tinted, and outlined as [`Renderer::draw_outline`] left it.
    pub selection: Option<usize>,
    /// Index of the object under the cursor: lit.
    pub hover: Option<usize>,
}

/// Pipelines of the passes after the scene.
#[derive(Debug)]
pub(super) struct PostPasses {
    shader: wgpu::ShaderModule,
    bind_group_layout: wgpu::BindGroupLayout,
    layout: wgpu::PipelineLayout,
    uniform: wgpu::Buffer,
    pub(super) made: HashMap<&'static str, wgpu::RenderPipeline>,
}

impl Renderer {
    /// Draws the outline about the pixels that show an object. Needed when the selection changed, and after each
    /// [`Renderer::draw`].
    pub fn draw_outline(&mut self, (scene, targets, view): Onto<'_>, selection: usize) {
        let (gpu, outline_px) = (&self.gpu, self.outline_px());
        let marks = Marks {
            selection: Some(selection),
            hover: None,
        };
        let post = (self.post).get_or_insert_with(|| PostPasses::new(gpu));
        post.write(gpu, &uniform(&marks, outline_px));
        // What this pass writes it cannot read.
        let bindings = post.bind(gpu, targets, &targets.colour_view);
        let pipeline = post.pipeline(gpu, "outline");
        let place = scene.shown(selection);
        gpu.submit(|encoder| {
            let mut pass =
                without_depth::begin(encoder, &targets.outline_view, without_depth::CLEAR);
            let rect = place.and_then(|place| screen_rect(place, view, outline_px));
            if let Some([x, y, width, height]) = rect {
                pass.set_scissor_rect(x, y, width, height);
                pass.set_pipeline(&pipeline);
                pass.set_bind_group(0, &bindings, &[]);
                pass.draw(0..3, 0..1);
            }
        });
    }

    /// Copies the colours, and marks the copy: all that a mouse move needs.
    pub fn mark(&mut self, (scene, targets, view): Onto<'_>, marks: &Marks) {
        let (gpu, outline_px) = (&self.gpu, self.outline_px());
        let post = (self.post).get_or_insert_with(|| PostPasses::new(gpu));
        post.write(gpu, &uniform(marks, outline_px));
        let rect = |object: Option<usize>| screen_rect(scene.shown(object?)?, view, outline_px);
        let marked = [("hover", marks.hover), ("selection", marks.selection)];
        let marked = marked.map(|(entry, object)| (entry, rect(object)));
        let bindings = post.bind(gpu, targets, &targets.outline_view);
        gpu.submit(|encoder| {
            let [from, to] =
                [&targets.colour_view, &targets.marked_view].map(wgpu::TextureView::texture);
            encoder.copy_texture_to_texture(from.as_image_copy(), to.as_image_copy(), from.size());
            let mut pass = without_depth::begin(encoder, &targets.marked_view, wgpu::LoadOp::Load);
            pass.set_bind_group(0, &bindings, &[]);
            for (entry, rect) in marked {
                let Some([x, y, width, height]) = rect else {
                    continue;
                };
                pass.set_scissor_rect(x, y, width, height);
                pass.set_pipeline(&post.pipeline(gpu, entry));
                pass.draw(0..3, 0..1);
            }
        });
    }

    /// Makes one pipeline that pictures of a view and their marks need, if any is missing. Returns whether one was. A
    /// pipeline that is not made ahead is made at first use, and a frame waits for it.
    pub(crate) fn make_ahead(&mut self, view: &View) -> bool {
        let gpu = &self.gpu;
        let post = (self.post).get_or_insert_with(|| PostPasses::new(gpu));
        let mut entries = ["hover", "selection", "outline"].into_iter();
        let missing = entries.find(|entry| !post.made.contains_key(entry));
        if let Some(entry) = missing {
            post.pipeline(gpu, entry);
        }
        missing.is_some() || self.pipelines.make_ahead(gpu, view)
    }

    /// Half the outline's width in pixels: at least 1, or some of it would vanish.
    #[expect(clippy::cast_precision_loss, reason = "a few pixels")]
    fn outline_px(&self) -> f32 {
        (look::OUTLINE_PX as f32 * self.scale_factor).max(1.0)
    }
}

impl PostPasses {
    pub fn new(gpu: &Gpu) -> Self {
        let texture = |sample_type| wgpu::BindingType::Texture {
            sample_type,
            view_dimension: wgpu::TextureViewDimension::D2,
            multisampled: false,
        };
        let float = wgpu::TextureSampleType::Float { filterable: false };
        let types = [
            bindings::buffer(wgpu::BufferBindingType::Uniform),
            texture(float),
            texture(wgpu::TextureSampleType::Uint),
            texture(float),
        ];
        let (bind_group_layout, layout) =
            bindings::layouts(gpu, "marks", wgpu::ShaderStages::FRAGMENT, &types);
        Self {
            shader: shader_module(gpu, "marks"),
            bind_group_layout,
            layout,
            uniform: super::uniform_buffer::<shader_structs::Marking>(gpu, "marks"),
            made: HashMap::new(),
        }
    }

    fn write(&self, gpu: &Gpu, uniform: &shader_structs::Marking) {
        let bytes = bytemuck::bytes_of(uniform);
        gpu.queue.write_buffer(&self.uniform, 0, bytes);
    }

    fn bind(&self, gpu: &Gpu, targets: &Targets, outline: &wgpu::TextureView) -> wgpu::BindGroup {
        let resources = [
            self.uniform.as_entire_binding(),
            wgpu::BindingResource::TextureView(&targets.colour_view),
            wgpu::BindingResource::TextureView(&targets.ids_view),
            wgpu::BindingResource::TextureView(outline),
        ];
        bindings::bind(gpu, "marks", &self.bind_group_layout, resources)
    }

    fn pipeline(&mut self, gpu: &Gpu, entry: &'static str) -> wgpu::RenderPipeline {
        let make = || {
            let format = if entry == "outline" { MARKS } else { COLOUR };
            let (layout, entries) = (Some(&self.layout), ["cover", entry]);
            without_depth::pipeline(gpu, layout, &self.shader, entries, format.into())
        };
        self.made.entry(entry).or_insert_with(make).clone()
    }
}

fn uniform(marks: &Marks, outline_px: f32) -> shader_structs::Marking {
    let of_index = |i: usize| u32::try_from(i + 1).unwrap_or(u32::MAX);
    // 0 is the background's id, so "none" is another number.
    let id = |object: Option<usize>| object.map_or(u32::MAX, of_index);
    shader_structs::Marking {
        selection_colour: look::SELECTION.to_linear(),
        tint: look::TINT,
        lit: look::LIT,
        selection: id(marks.selection),
        hover: id(marks.hover),
        outline_px,
        padding: [0; 3],
    }
}

/// The rectangle of pixels that may show an object, with `margin` around it, as left, top, width and height. `None`
/// when it lies outside the picture.
fn screen_rect(place: &Place, view: &View, margin: f32) -> Option<[u32; 4]> {
    let size = view.viewport.size_px();
    if place.bounds_world.is_empty() {
        return None;
    }
    let mut min = DVec2::INFINITY;
    let mut max = DVec2::NEG_INFINITY;
    for corner in place.bounds_world.corners() {
        (min, max) = match view.project(corner) {
            Some(corner) => (min.min(corner.px), max.max(corner.px)),
            // A box that reaches behind the eye may be at any pixel.
            None => (DVec2::NEG_INFINITY, DVec2::INFINITY),
        };
    }
    let margin = f64::from(margin) + 1.0;
    let min = (min - margin).floor().clamp(DVec2::ZERO, size);
    let max = (max + margin).ceil().clamp(DVec2::ZERO, size);
    let (min, extent) = (min.as_uvec2(), (max - min).as_uvec2());
    (extent.x > 0 && extent.y > 0).then_some([min.x, min.y, extent.x, extent.y])
}
