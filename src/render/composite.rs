//! Draws the selection's outline, and the finished picture: marks over cached colours, so that a mouse move does not
//! draw the scene again.

use super::{
    Onto, Renderer, bindings,
    formats::MARKS,
    gpu::{Gpu, GpuError},
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

/// Where a finished picture goes: a window's surface, or a texture.
#[derive(Clone, Copy, Debug)]
pub struct Destination<'a> {
    /// The texture. It keeps its pixels beside the picture. Its format must be sRGB or the twin of an sRGB one, and
    /// must allow views as both: colours are copied as stored, tints are mixed in linear light.
    pub texture: &'a wgpu::Texture,
    /// Where the picture's top left corner goes in the texture, in pixels.
    pub origin_px: [u32; 2],
    /// The largest width and height of the picture there. It is clipped to this, and to the texture.
    pub room_px: [u32; 2],
    /// How many pixels of the texture one pixel of the picture covers along each side: 1, or more for a picture of
    /// lower resolution, whose texture must allow copies to it.
    pub coarseness: u32,
}

impl Destination<'_> {
    /// Where a rectangle of the picture goes; both are left, top, width and height. `None` where none of it is seen, as
    /// in a window that has shrunk since the picture was drawn.
    pub(super) fn within(&self, rect: [u32; 4]) -> Option<[u32; 4]> {
        let [left, top, width, height] = rect.map(|px| px * self.coarseness);
        let extent = |axis: usize, first: u32, count: u32, texture: u32| {
            let origin = self.origin_px[axis];
            let room = self.room_px[axis].min(texture.saturating_sub(origin));
            (origin + first, count.min(room.saturating_sub(first)))
        };
        let (x, width) = extent(0, left, width, self.texture.width());
        let (y, height) = extent(1, top, height, self.texture.height());
        (width > 0 && height > 0).then_some([x, y, width, height])
    }
}

/// Pipelines of the passes after the scene.
#[derive(Debug)]
pub(super) struct PostPasses {
    shader: wgpu::ShaderModule,
    bind_group_layout: wgpu::BindGroupLayout,
    layout: wgpu::PipelineLayout,
    uniform: wgpu::Buffer,
    pub(super) made: HashMap<(&'static str, wgpu::TextureFormat), wgpu::RenderPipeline>,
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
        let uniform = shader_structs::Composite {
            outline_px,
            ..uniform(&marks, [0, 0], 1)
        };
        let post = (self.post).get_or_insert_with(|| PostPasses::new(gpu));
        post.write(gpu, &uniform);
        // What this pass writes it cannot read.
        let bindings = post.bind(gpu, targets, &targets.values_view, &targets.values_view);
        let pipeline = post.pipeline(gpu, "outline", MARKS);
        let place = scene.shown(selection);
        gpu.submit(|encoder| {
            let mut pass = without_depth::begin(encoder, &targets.outline_view, true);
            let rect = place.and_then(|place| screen_rect(place, view, outline_px));
            if let Some([x, y, width, height]) = rect {
                pass.set_scissor_rect(x, y, width, height);
                pass.set_pipeline(&pipeline);
                pass.set_bind_group(0, &bindings, &[]);
                pass.draw(0..3, 0..1);
            }
        });
    }

    /// Puts the picture with its marks into a destination: the only pass that a mouse move needs.
    ///
    /// # Errors
    /// When a coarse picture cannot be read: memory runs out, or the device is lost.
    pub fn composite(
        &mut self,
        (scene, targets, view): Onto<'_>,
        marks: &Marks,
        destination: &Destination<'_>,
    ) -> Result<(), GpuError> {
        let (texture, coarseness) = (destination.texture, destination.coarseness);
        let (gpu, outline_px) = (&self.gpu, self.outline_px());
        let post = (self.post).get_or_insert_with(|| PostPasses::new(gpu));
        post.write(gpu, &uniform(marks, destination.origin_px, coarseness));
        let viewport = targets.viewport;
        let box_of = |object: Option<usize>| screen_rect(scene.shown(object?)?, view, outline_px);
        let marked = [("hover", marks.hover), ("selection", marks.selection)];
        let marked = marked.map(|(entry, object)| (entry, box_of(object).unwrap_or_default()));
        let srgb = texture.format().add_srgb_suffix();
        let whole: &[_] = if coarseness == 1 {
            &[("copy", [0, 0, viewport.width(), viewport.height()])]
        } else {
            targets.enlarge(gpu, destination)?;
            &[]
        };
        let passes: [(_, _, &[_]); 2] = [
            (srgb.remove_srgb_suffix(), &targets.values_view, whole),
            (srgb, &targets.colour_view, &marked),
        ];
        gpu.submit(|encoder| {
            for (format, picture, rects) in passes {
                let shown = |&(entry, rect): &_| Some((entry, destination.within(rect)?));
                let shown: Vec<_> = rects.iter().filter_map(shown).collect();
                if shown.is_empty() {
                    continue;
                }
                let view = texture.create_view(&wgpu::TextureViewDescriptor {
                    format: Some(format),
                    ..Default::default()
                });
                let bind_group = post.bind(gpu, targets, picture, &targets.outline_view);
                let mut pass = without_depth::begin(encoder, &view, false);
                pass.set_bind_group(0, &bind_group, &[]);
                for (entry, [x, y, width, height]) in shown {
                    pass.set_scissor_rect(x, y, width, height);
                    pass.set_pipeline(&post.pipeline(gpu, entry, format));
                    pass.draw(0..3, 0..1);
                }
            }
        });
        Ok(())
    }

    /// Makes one pipeline that pictures of a view and their marks need on textures of a format, if any is missing.
    /// Returns whether one was. A pipeline that is not made ahead is made at first use, and a frame waits for it.
    pub(crate) fn make_ahead(&mut self, view: &View, format: wgpu::TextureFormat) -> bool {
        let gpu = &self.gpu;
        let post = (self.post).get_or_insert_with(|| PostPasses::new(gpu));
        let srgb = format.add_srgb_suffix();
        let mut passes = [
            ("copy", srgb.remove_srgb_suffix()),
            ("hover", srgb),
            ("selection", srgb),
            ("outline", MARKS),
        ]
        .into_iter();
        let missing = passes.find(|pass| !post.made.contains_key(pass));
        if let Some((entry, format)) = missing {
            post.pipeline(gpu, entry, format);
        }
        missing.is_some() || self.pipelines.make_ahead(gpu, view)
    }

    /// Half the outline's width in pixels: at least 1, since a thinner one would vanish from a coarse picture.
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
            bindings::layouts(gpu, "composite", wgpu::ShaderStages::FRAGMENT, &types);
        Self {
            shader: shader_module(gpu, "composite"),
            bind_group_layout,
            layout,
            uniform: super::uniform_buffer::<shader_structs::Composite>(gpu, "composite"),
            made: HashMap::new(),
        }
    }

    fn write(&self, gpu: &Gpu, uniform: &shader_structs::Composite) {
        let bytes = bytemuck::bytes_of(uniform);
        gpu.queue.write_buffer(&self.uniform, 0, bytes);
    }

    fn bind(
        &self,
        gpu: &Gpu,
        targets: &Targets,
        picture: &wgpu::TextureView,
        marks: &wgpu::TextureView,
    ) -> wgpu::BindGroup {
        let resources = [
            self.uniform.as_entire_binding(),
            wgpu::BindingResource::TextureView(picture),
            wgpu::BindingResource::TextureView(&targets.ids_view),
            wgpu::BindingResource::TextureView(marks),
        ];
        bindings::bind(gpu, "composite", &self.bind_group_layout, resources)
    }

    fn pipeline(
        &mut self,
        gpu: &Gpu,
        entry: &'static str,
        format: wgpu::TextureFormat,
    ) -> wgpu::RenderPipeline {
        let entries = ["cover", entry];
        self.made
            .entry((entry, format))
            .or_insert_with(|| {
                let layout = Some(&self.layout);
                without_depth::pipeline(gpu, layout, &self.shader, entries, format.into())
            })
            .clone()
    }
}

#[expect(clippy::cast_precision_loss, reason = "textures are not that large")]
fn uniform(marks: &Marks, origin_px: [u32; 2], coarseness: u32) -> shader_structs::Composite {
    let of_index = |i: usize| u32::try_from(i + 1).unwrap_or(u32::MAX);
    // 0 is the background's id, so "none" is another number.
    let id = |object: Option<usize>| object.map_or(u32::MAX, of_index);
    shader_structs::Composite {
        origin_px: origin_px.map(|px| px as f32),
        selection: id(marks.selection),
        hover: id(marks.hover),
        selection_colour: look::SELECTION.to_linear(),
        tint: look::TINT,
        lit: look::LIT,
        outline_px: 0.0,
        coarseness: coarseness as f32,
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
