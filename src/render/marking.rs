//! Marks a picture: draws the selection's outline, and a copy of the colours with what is selected or lit, so that a
//! mouse move does not draw the scene again.

use super::{
    Onto, Renderer, bindings,
    formats::{COLOUR, MARKS},
    gpu::Gpu,
    scene_buffers::SceneBuffers,
    shader_structs,
    shaders::shader_module,
    targets::Targets,
    without_depth,
};
use crate::{
    camera::View,
    look::{self, Background},
};
use glam::DVec2;
use std::collections::HashMap;
use wgpu::util::DeviceExt;

/// Stands for the id of the selection where there are several objects in it.
const SEVERAL: u32 = u32::MAX - 1;

/// What is marked in a picture.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Marks {
    /// Indices of the selected objects: tinted, and outlined together as [`Renderer::draw_outline`] left it.
    pub selection: Vec<usize>,
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
    /// A bit for the id of each selected object, where there are several.
    several: wgpu::Buffer,
    pub(super) made: HashMap<&'static str, wgpu::RenderPipeline>,
}

impl Renderer {
    /// Draws the outline about the pixels that show one of these objects. Needed when the selection changed, and after each
    /// [`Renderer::draw`].
    pub fn draw_outline(&mut self, (scene, targets, view): Onto<'_>, selection: &[usize]) {
        let (gpu, outline_px) = (&self.gpu, self.outline_px());
        let marks = Marks {
            selection: selection.into(),
            hover: None,
        };
        let post = (self.post).get_or_insert_with(|| PostPasses::new(gpu));
        post.write(gpu, &marks, outline_px, self.background);
        // What this pass writes it cannot read.
        let bindings = post.bind(gpu, targets, &targets.colour_view);
        let pipeline = post.pipeline(gpu, "outline");
        let rect = screen_rect(scene, selection, view, outline_px);
        gpu.submit(|encoder| {
            let mut pass =
                without_depth::begin(encoder, &targets.outline_view, without_depth::CLEAR);
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
        post.write(gpu, marks, outline_px, self.background);
        let marked = [
            ("hover", marks.hover.as_slice()),
            ("selection", &marks.selection),
        ];
        let rect = |objects| screen_rect(scene, objects, view, outline_px);
        let marked = marked.map(|(entry, objects)| (entry, rect(objects)));
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
            bindings::buffer(wgpu::BufferBindingType::Storage { read_only: true }),
        ];
        let (bind_group_layout, layout) =
            bindings::layouts(gpu, "marks", wgpu::ShaderStages::FRAGMENT, &types);
        Self {
            shader: shader_module(gpu, "marks"),
            bind_group_layout,
            layout,
            uniform: super::uniform_buffer::<shader_structs::Marking>(gpu, "marks"),
            several: bits(gpu, &[0]),
            made: HashMap::new(),
        }
    }

    fn write(&mut self, gpu: &Gpu, marks: &Marks, outline_px: f32, background: Background) {
        let uniform = uniform(marks, outline_px, background);
        let bytes = bytemuck::bytes_of(&uniform);
        gpu.queue.write_buffer(&self.uniform, 0, bytes);
        if uniform.selection == SEVERAL {
            let ids = || marks.selection.iter().map(|index| index + 1);
            let mut words = vec![0_u32; ids().max().unwrap_or(0) / 32 + 1];
            ids().for_each(|id| words[id / 32] |= 1 << (id % 32));
            self.several = bits(gpu, &words);
        }
    }

    fn bind(&self, gpu: &Gpu, targets: &Targets, outline: &wgpu::TextureView) -> wgpu::BindGroup {
        let resources = [
            self.uniform.as_entire_binding(),
            wgpu::BindingResource::TextureView(&targets.colour_view),
            wgpu::BindingResource::TextureView(&targets.ids_view),
            wgpu::BindingResource::TextureView(outline),
            self.several.as_entire_binding(),
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

fn uniform(marks: &Marks, outline_px: f32, background: Background) -> shader_structs::Marking {
    let of_index = |i: usize| u32::try_from(i + 1).unwrap_or(u32::MAX);
    // 0 is the background's id, so "none" is another number.
    let id = |object: Option<usize>| object.map_or(u32::MAX, of_index);
    let selection = match marks.selection[..] {
        [] => u32::MAX,
        [one] => of_index(one),
        _ => SEVERAL,
    };
    shader_structs::Marking {
        selection_colour: background.over(look::SELECTION),
        tint: look::TINT,
        lit: look::LIT,
        selection,
        hover: id(marks.hover),
        outline_px,
        padding: [0; 3],
    }
}

/// A buffer of bits.
fn bits(gpu: &Gpu, words: &[u32]) -> wgpu::Buffer {
    gpu.device
        .create_buffer_init(&wgpu::util::BufferInitDescriptor {
            label: Some("selected"),
            contents: bytemuck::cast_slice(words),
            usage: wgpu::BufferUsages::STORAGE,
        })
}

/// The rectangle of pixels that may show some of these objects, with `margin` around it, as left, top, width and height.
/// `None` when it lies outside the picture.
fn screen_rect(
    scene: &SceneBuffers,
    objects: &[usize],
    view: &View,
    margin: f32,
) -> Option<[u32; 4]> {
    let size = view.viewport.size_px();
    // Beyond this many, to find the rectangle costs more than to mark the whole picture.
    if objects.len() > 1000 || (scene.ndc.is_some() && !objects.is_empty()) {
        let size = view.viewport;
        return Some([0, 0, size.width(), size.height()]);
    }
    let places = objects.iter().filter_map(|object| scene.shown(*object));
    let boxes = places.map(|place| place.bounds_world);
    let mut min = DVec2::INFINITY;
    let mut max = DVec2::NEG_INFINITY;
    for corner in boxes
        .filter(|bounds| !bounds.is_empty())
        .flat_map(|bounds| bounds.corners())
    {
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
