//! Draws scenes with the GPU. This module knows no window, no panels and no picking.
//!
//! ```text
//! Gpu  ->  Renderer (pipelines)                      once
//! Scene -> SceneBuffers                              when the scene changes
//! Viewport -> Targets (colours, ids, selection)      when the picture's size changes
//! Renderer::draw            colours and ids          when scene, view or lines change
//! Renderer::draw_outline    the selection's outline  when the selection changes too
//! Renderer::mark            the picture with marks   when what is selected or lit changes too
//! ```
//!
//! Only the batches that a view may show are drawn. Batches of a kind share a draw call where that does not change the
//! picture. All cores compose their table rows for the view ([`SceneBuffers`]).
//!
//! Where the adapter has no primitive index, triangles are numbered by their corners ([`Numbers`]). Meshes are split to
//! fit into buffers. The grid that the rasteriser snaps corners to is measured ([`Rasteriser`]).
//!
//! Pixels that were found by rays can take the place of drawn ones ([`Renderer::take_pixels`]).
//!
//! Each step submits its own work. [`render`] takes all steps for one picture.
//!
//! A pixel shows the surface that the picker's rules choose: the camera is the same, near and far are compared with
//! view depth, and at equal depth the triangle with the lower number wins, or the object with the lower index of those
//! that touch.
//! Everything is composed in `f64` and rounded to `f32` once (see [`transform`] and [`sphere`]).

mod abilities;
mod adapters;
mod batches;
pub(crate) mod bindings;
mod draw_order;
mod drawing;
mod formats;
mod frustum;
mod gpu;
mod gpu_error;
mod lines;
mod marking;
mod mesh_buffers;
mod mesh_store;
mod open;
mod pipelines;
mod pixels;
mod probe;
mod rasteriser;
mod readback;
mod resolve;
pub(crate) mod rounding;
mod scene_buffers;
pub(crate) mod section;
mod seen;
pub mod shader_structs;
mod shaders;
pub mod sphere;
mod targets;
pub mod transform;
mod view_rows;
pub mod view_space;
pub mod view_units;
pub(crate) mod without_depth;

pub use abilities::{Numbers, Restraint};
pub use adapters::{AdapterCan, AdapterFound, adapters};
pub use drawing::Wireframe;
pub use gpu::{Gpu, GpuError};
pub use lines::Line;
pub use marking::Marks;
pub use mesh_store::MeshStore;
pub use rasteriser::Rasteriser;
pub(crate) use readback::read_rgb;
pub use scene_buffers::SceneBuffers;
pub use shaders::SHADERS;
pub use targets::Targets;

use crate::{
    camera::View,
    image::{Id, Image, Rgb},
    look::Background,
    scene::Scene,
};
use std::cell::OnceCell;

/// Samples per pixel of a picture at rest, for smooth edges.
pub const SMOOTH_SAMPLES: u32 = 4;

/// The pipelines of one device, for one number of colour samples.
#[derive(Debug)]
pub struct Renderer {
    /// Pixels to a point of the screen: how wide lines and outlines are, at least one pixel. 1 at first.
    pub scale_factor: f32,
    /// What is behind scenes; [`Background::DARK`] at first.
    pub background: Background,
    /// The objects whose triangles' edges are drawn over their faces; `None` at first.
    pub wireframe: Option<Wireframe>,
    pipelines: pipelines::Pipelines,
    /// Made at first use.
    post: Option<marking::PostPasses>,
    /// Made at first use.
    resolve: OnceCell<resolve::Resolve>,
    frame: wgpu::Buffer,
    gpu: Gpu,
}

/// What is drawn, what it is drawn onto, and the view through which it is seen.
pub type Onto<'a> = (&'a SceneBuffers, &'a Targets, &'a View);

impl Renderer {
    /// A renderer for targets with 1 or [`SMOOTH_SAMPLES`] colour samples per pixel. It compiles shaders at first use.
    pub fn new(gpu: &Gpu, colour_samples: u32) -> Self {
        Self {
            scale_factor: 1.0,
            background: Background::DARK,
            wireframe: None,
            pipelines: pipelines::Pipelines::new(gpu, colour_samples),
            post: None,
            resolve: OnceCell::new(),
            frame: uniform_buffer::<shader_structs::Frame>(gpu, "frame"),
            gpu: gpu.clone(),
        }
    }
}

/// Draws one picture without a window: ids and smooth colours, with `selection` marked.
///
/// # Errors
/// When scene or picture are too large for the adapter, or it fails.
pub fn render(
    gpu: &Gpu,
    scene: &Scene,
    view: &View,
    selection: Option<usize>,
    background: Background,
) -> Result<(Image<Id>, Image<Rgb>), GpuError> {
    let (targets, buffers, mut renderer) = prepare(gpu, scene, view)?;
    renderer.background = background;
    let onto = (&buffers, &targets, view);
    renderer.draw(onto, &[])?;
    let marks = Marks {
        selection: selection.into_iter().collect(),
        hover: None,
    };
    renderer.draw_outline(onto, &marks.selection);
    let picture = renderer.read_marked(onto, &marks)?;
    Ok((targets.read_ids(gpu)?, picture))
}

/// The colours of [`render`] with nothing selected, for about half of its work.
///
/// # Errors
/// As [`render`].
pub fn picture(
    gpu: &Gpu,
    scene: &Scene,
    view: &View,
    background: Background,
) -> Result<Image<Rgb>, GpuError> {
    let (targets, buffers, mut renderer) = prepare(gpu, scene, view)?;
    renderer.background = background;
    renderer.draw_colours((&buffers, &targets, view), &[])?;
    // Without marks, the picture is the colours as drawn.
    targets.read_colours(gpu)
}

/// All that a picture of a scene takes.
fn prepare(
    gpu: &Gpu,
    scene: &Scene,
    view: &View,
) -> Result<(Targets, SceneBuffers, Renderer), GpuError> {
    let targets = Targets::new(gpu, view.viewport, SMOOTH_SAMPLES)?;
    let buffers = SceneBuffers::upload(gpu, scene)?;
    Ok((targets, buffers, Renderer::new(gpu, SMOOTH_SAMPLES)))
}

fn uniform_buffer<T>(gpu: &Gpu, label: &'static str) -> wgpu::Buffer {
    gpu.device.create_buffer(&wgpu::BufferDescriptor {
        label: Some(label),
        size: size_of::<T>() as u64,
        usage: wgpu::BufferUsages::UNIFORM | wgpu::BufferUsages::COPY_DST,
        mapped_at_creation: false,
    })
}
