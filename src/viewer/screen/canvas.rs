//! The frame: panels with the scene's picture among them, painted onto any texture.

use super::{
    place::SceneRect,
    scene_picture::{Brush, ScenePicture, Updated},
};
use crate::{
    camera::{View, Viewport},
    image::{Id, Image, Rgb},
    look::Background,
    render::{Gpu, GpuError, MeshStore, Renderer, SMOOTH_SAMPLES, read_rgb, without_depth},
    viewer::model::{OnScreen, Stage, State, Subject},
};
use egui::{
    ClippedPrimitive, Color32, Mesh, Pos2, Rect, TextureId, TexturesDelta, epaint::Primitive,
};
use egui_wgpu::{RendererOptions, ScreenDescriptor};
use std::mem;
use wgpu::TextureFormat;

/// Everything that one device draws, and what it has drawn already.
pub(in crate::viewer) struct Canvas {
    brush: Brush,
    /// The format of the textures that frames are painted onto. Colours are stored as they are.
    format: TextureFormat,
    /// The camera's picture, or the world stage.
    scene: ScenePicture,
    /// Pictures of the object, view and NDC stages, while any is shown.
    stages: Option<Box<[ScenePicture; 3]>>,
    /// egui's textures that the next frame may still show.
    stale: Vec<TextureId>,
}

/// One frame, laid out.
#[derive(Clone)]
pub(in crate::viewer) struct Laid {
    /// Where the scene goes; `None` where there is no room for it.
    pub place: Option<SceneRect>,
    /// Where each stage goes within it; empty while the camera's picture is shown.
    pub panes: Vec<(Stage, SceneRect)>,
    /// The panels' triangles, and what is behind them.
    pub primitives: Vec<ClippedPrimitive>,
    pub panels_on: Color32,
    /// What is behind the scene.
    pub background: Background,
    /// Physical pixels for a point.
    pub pixels_per_point: f32,
    /// Whether the scene moves: its picture may then be coarse.
    pub moves: bool,
}

/// Where frames go: the surface of a window, or a picture in memory.
pub(in crate::viewer) trait Screen {
    /// Replaces a lost device. Returns whether the device is new: then it has none of egui's textures.
    fn restore(&mut self) -> Result<bool, GpuError>;

    /// The device's canvas; `None` before there is a device.
    fn canvas(&mut self) -> Option<&mut Canvas>;

    /// The size of frames; `None` while the window is minimised.
    fn size(&self) -> Option<Viewport>;

    /// Paints a frame, and shows it.
    fn paint(&mut self, laid: &Laid) -> Result<(), GpuError>;
}

impl Canvas {
    /// A canvas for textures of this format, which is not sRGB.
    pub fn new(gpu: Gpu, format: TextureFormat) -> Self {
        let options = RendererOptions {
            // A pixel of the picture is shown as it is.
            dithering: false,
            ..RendererOptions::default()
        };
        Self {
            brush: Brush {
                renderer: Renderer::new(&gpu, SMOOTH_SAMPLES),
                panels: egui_wgpu::Renderer::new(&gpu.device, format, options),
                meshes: MeshStore::default(),
                gpu,
            },
            format,
            scene: ScenePicture::default(),
            stages: None,
            stale: Vec::new(),
        }
    }

    /// The device.
    pub fn gpu(&self) -> &Gpu {
        &self.brush.gpu
    }

    /// Makes a pipeline that pictures of a view will need. Returns whether any was missing.
    pub fn make_ahead(&mut self, view: &View) -> bool {
        self.brush.renderer.make_ahead(view)
    }

    /// The ids of the scene's picture, as they are drawn.
    pub fn drawn_ids(&mut self, state: &State) -> Result<Option<Image<Id>>, GpuError> {
        self.scene.drawn_ids(&mut self.brush, &state.subject())
    }

    /// What the scene's picture shows.
    pub fn on_screen(&self) -> Option<OnScreen> {
        self.scene.on_screen()
    }

    /// Applies the changes of egui's textures. What is dropped may still be in the next frame, and is freed after it.
    pub fn take_textures(&mut self, textures: &mut TexturesDelta) {
        let (gpu, panels) = (&self.brush.gpu, &mut self.brush.panels);
        for (id, deltas) in mem::take(&mut textures.set) {
            for delta in deltas {
                panels.update_texture(&gpu.device, &gpu.queue, id, &delta);
            }
        }
        self.stale.extend(mem::take(&mut textures.free));
    }

    /// Brings the scene's pictures up to date.
    pub fn update(&mut self, state: &State, laid: &Laid) -> Result<Updated, GpuError> {
        if laid.panes.is_empty() {
            let stages = self.stages.take().into_iter().flat_map(|stages| *stages);
            self.stale
                .extend(stages.filter_map(|picture| picture.name()));
        }
        self.brush.renderer.scale_factor = laid.pixels_per_point;
        self.brush.renderer.background = laid.background;
        let mut all = Ok(Updated::default());
        for (stage, place) in places(laid) {
            let Some(subject) = subject(state, stage, place) else {
                continue;
            };
            let picture = picture_of(&mut self.scene, &mut self.stages, stage);
            let updated = picture.update(&mut self.brush, &subject, laid.moves);
            all = all.and_then(|all: Updated| {
                let updated = updated?;
                Ok(Updated {
                    anew: all.anew || updated.anew,
                    rough: all.rough || updated.rough,
                })
            });
        }
        all
    }

    /// Paints a frame.
    pub fn paint(&mut self, laid: &Laid, onto: &wgpu::Texture) -> Result<(), GpuError> {
        let pictures = places(laid).into_iter().filter_map(|(stage, place)| {
            let picture = picture_of(&mut self.scene, &mut self.stages, stage);
            Some(quad(picture.texture(place.viewport)?, place))
        });
        let mut primitives: Vec<_> = pictures.collect();
        primitives.extend_from_slice(&laid.primitives);
        let screen = ScreenDescriptor {
            size_in_pixels: [onto.width(), onto.height()],
            pixels_per_point: laid.pixels_per_point,
        };
        let [r, g, b, a] = laid
            .panels_on
            .to_array()
            .map(|value| f64::from(value) / 255.0);
        let Brush { gpu, panels, .. } = &mut self.brush;
        gpu.submit(|encoder| {
            panels.update_buffers(&gpu.device, &gpu.queue, encoder, &primitives, &screen);
            let view = onto.create_view(&wgpu::TextureViewDescriptor::default());
            let clear = wgpu::LoadOp::Clear(wgpu::Color { r, g, b, a });
            let mut pass = without_depth::begin(encoder, &view, clear).forget_lifetime();
            panels.render(&mut pass, &primitives, &screen);
        });
        for id in self.stale.drain(..) {
            panels.free_texture(&id);
        }
        if gpu.is_software() {
            // Without this wait, the frame time on display would be that of the submission only.
            gpu.wait()?;
        }
        gpu.check()
    }

    /// A picture of a frame at rest.
    pub fn picture(
        &mut self,
        state: &State,
        laid: &Laid,
        size: Viewport,
    ) -> Result<Image<Rgb>, GpuError> {
        let rested = Laid {
            moves: false,
            ..laid.clone()
        };
        while self.update(state, &rested)?.rough {}
        let page = self.page(size)?;
        self.paint(&rested, &page)?;
        read_rgb(&self.brush.gpu, &page, size)
    }

    /// A texture that frames can be painted onto, and read.
    pub fn page(&self, size: Viewport) -> Result<wgpu::Texture, GpuError> {
        let (gpu, px) = (&self.brush.gpu, [size.width(), size.height()]);
        let usage = wgpu::TextureUsages::COPY_SRC;
        gpu.check_picture(size)?;
        gpu.within_memory(|| without_depth::texture(gpu, "page", px, self.format, 1, usage, &[]))
    }
}

/// The picture of a stage, or with `None` the camera's.
fn picture_of<'a>(
    scene: &'a mut ScenePicture,
    stages: &'a mut Option<Box<[ScenePicture; 3]>>,
    stage: Option<Stage>,
) -> &'a mut ScenePicture {
    let at = match stage {
        None | Some(Stage::World) => return scene,
        Some(Stage::Object) => 0,
        Some(Stage::View) => 1,
        Some(Stage::Ndc) => 2,
    };
    &mut stages.get_or_insert_default()[at]
}

/// A picture at its place, pixel by pixel.
fn quad(texture: TextureId, place: SceneRect) -> ClippedPrimitive {
    let rect = place.to_points();
    let whole = Rect::from_min_max(Pos2::ZERO, Pos2::new(1.0, 1.0));
    let mut mesh = Mesh::with_texture(texture);
    mesh.add_rect_with_uv(rect, whole, Color32::WHITE);
    ClippedPrimitive {
        clip_rect: rect,
        primitive: Primitive::Mesh(mesh),
    }
}

/// What is drawn, and where: stages, or else the camera's picture.
fn places(laid: &Laid) -> Vec<(Option<Stage>, SceneRect)> {
    if laid.panes.is_empty() {
        return laid.place.map(|place| (None, place)).into_iter().collect();
    }
    let panes = laid.panes.iter();
    panes.map(|(stage, place)| (Some(*stage), *place)).collect()
}

/// What the picture at a place shows.
fn subject(state: &State, stage: Option<Stage>, place: SceneRect) -> Option<Subject<'_>> {
    let subject = match stage {
        Some(stage) => state.pane_subject(stage)?,
        None => state.subject(),
    };
    Some(Subject {
        view: View {
            viewport: place.viewport,
            ..subject.view
        },
        ..subject
    })
}
