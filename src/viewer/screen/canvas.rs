//! The frame: the scene's picture with its marks and the panels over it, drawn onto any texture.

use super::{
    brush::Brush,
    panels_picture::PanelsPicture,
    picture_progress::PictureProgress,
    place::SceneRect,
    scene_picture::{Look, ScenePicture},
    wanted::Motion,
};
use crate::{
    camera::{View, Viewport},
    image::{Id, Image, Rgb},
    render::{
        Gpu, GpuError, MeshStore, Renderer, SMOOTH_SAMPLES, read_rgb,
        without_depth::{self, extent},
    },
    viewer::model::{OnScreen, Stage, State, Subject},
};
use egui_wgpu::ScreenDescriptor;
use std::{sync::Arc, time::Instant};
use wgpu::TextureFormat;

/// Everything that one device draws, and what it has drawn already.
pub(in crate::viewer) struct Canvas {
    pub gpu: Gpu,
    /// The page's format: values are stored as they are; the scene is drawn through an sRGB view.
    pub format: TextureFormat,
    renderer: Renderer,
    /// The camera's picture, or the world stage.
    scene: ScenePicture,
    /// Pictures of the object, view and NDC stages, while any is shown.
    stages: Option<Box<[ScenePicture; 3]>>,
    panels: PanelsPicture,
    /// The frame, kept until something in it changes.
    page: wgpu::Texture,
    size: Viewport,
    /// The page differs from what was presented last.
    pub unshown: bool,
    /// What the page shows of the scene, and where.
    shown: Vec<(SceneRect, Option<Look>)>,
}

/// One frame, laid out.
#[derive(Clone)]
pub(in crate::viewer) struct Laid {
    /// Where the scene goes; `None` where there is no room for it.
    pub place: Option<SceneRect>,
    /// Where each stage goes within it; empty while the camera's picture is shown.
    pub panes: Vec<(Stage, SceneRect)>,
    /// The panels' triangles.
    pub primitives: Arc<[egui::ClippedPrimitive]>,
    /// Physical pixels for a point.
    pub pixels_per_point: f32,
    /// How the scene moves.
    pub motion: Motion,
}

/// Where frames go: the surface of a window, or a picture in memory.
pub(in crate::viewer) trait Screen {
    /// Replaces a lost device. Returns whether the device is new: then it has none of egui's textures.
    fn restore(&mut self) -> Result<bool, GpuError>;

    /// The device's canvas; `None` before there is a device.
    fn canvas(&mut self) -> Option<&mut Canvas>;

    /// Draws and shows a frame. Returns how far the scene's picture has come.
    fn draw(&mut self, state: &State, laid: &Laid) -> Result<PictureProgress, GpuError>;
}

impl Canvas {
    /// A canvas for textures of this format, which must have an sRGB twin.
    pub fn new(gpu: Gpu, format: TextureFormat) -> Self {
        Self {
            panels: PanelsPicture::new(&gpu, format),
            renderer: Renderer::new(&gpu, SMOOTH_SAMPLES),
            scene: ScenePicture::new(&gpu),
            stages: None,
            page: page(&gpu, Viewport::DEFAULT, format),
            size: Viewport::DEFAULT,
            unshown: true,
            shown: Vec::new(),
            gpu,
            format,
        }
    }

    /// Makes a pipeline that pictures of a view will need. Returns whether any was missing.
    pub fn make_ahead(&mut self, view: &View) -> bool {
        self.renderer.make_ahead(view, self.format)
    }

    /// The ids on screen, when they are those of `wanted`.
    pub fn read_ids(&self, wanted: &OnScreen) -> Result<Option<Image<Id>>, GpuError> {
        self.scene.read_ids(&self.gpu, wanted)
    }

    /// What the scene's picture on screen shows.
    pub fn on_screen(&self) -> Option<OnScreen> {
        self.scene.shown.as_ref().map(|shown| shown.of.on_screen())
    }

    /// Applies the changes of egui's textures.
    pub fn take_textures(&mut self, textures: &mut egui::TexturesDelta) {
        self.panels.take_textures(&self.gpu, textures);
    }

    /// Brings the page up to date. Returns how far the scene's picture has come.
    pub fn draw(
        &mut self,
        size: Viewport,
        state: &State,
        laid: &Laid,
    ) -> Result<PictureProgress, GpuError> {
        let began = Instant::now();
        let is_new = self.size != size;
        if is_new {
            (self.page, self.size) = (page(&self.gpu, size, self.format), size);
        }
        let places = places(laid);
        if laid.panes.is_empty() {
            self.stages = None;
        }
        let (mut progress, mut looks) = (Ok(PictureProgress::default()), Vec::new());
        for (stage, place) in &places {
            let (picture, mut brush, meshes) =
                self.picture_of(*stage, laid.pixels_per_point, began);
            picture.scenes.meshes = meshes;
            let Some(subject) = subject(state, *stage, *place) else {
                looks.push((*place, None));
                continue;
            };
            let advanced = picture.advance(&mut brush, &subject, laid.motion);
            looks.push((*place, picture.look(&subject)));
            let meshes = picture.scenes.meshes.clone();
            self.scene.scenes.meshes = meshes;
            progress = progress.and_then(|progress| Ok(progress.and(advanced?)));
        }
        let screen = ScreenDescriptor {
            size_in_pixels: [size.width(), size.height()],
            pixels_per_point: laid.pixels_per_point,
        };
        let is_painted = self.panels.update(&self.gpu, &laid.primitives, &screen);
        let before = self.shown.iter().map(|(place, _)| place);
        let is_moved = before.ne(places.iter().map(|(_, place)| place));
        let is_anew = is_painted || is_new || is_moved;
        if is_anew {
            self.panels.copy(&self.gpu, &self.page);
        }
        self.unshown |= is_anew;
        for (at, (stage, _)) in places.iter().enumerate() {
            let look = looks[at];
            if !is_anew && self.shown.get(at) == Some(&look) {
                continue;
            }
            if let (place, Some(look)) = look {
                let page = self.page.clone();
                let (picture, mut brush, _) = self.picture_of(*stage, laid.pixels_per_point, began);
                picture.composite(&mut brush, &look, &page, place)?;
                self.panels.draw_over(&self.gpu, &self.page, place);
                self.unshown = true;
            }
        }
        self.shown = looks;
        if self.gpu.is_software() {
            // Without this wait, the frame time on display would be that of the submission only.
            self.gpu.wait()?;
        }
        self.gpu.check()?;
        progress
    }

    /// The picture of a stage, or with `None` the camera's; what draws it in this frame; the uploaded meshes.
    fn picture_of(
        &mut self,
        stage: Option<Stage>,
        scale_factor: f32,
        began: Instant,
    ) -> (&mut ScenePicture, Brush<'_>, MeshStore) {
        let brush = Brush {
            gpu: &self.gpu,
            renderer: &mut self.renderer,
            scale_factor,
            began,
        };
        let meshes = self.scene.scenes.meshes.clone();
        let new = || Box::new([(); 3].map(|()| ScenePicture::new(brush.gpu)));
        let stage = match stage {
            None | Some(Stage::World) => return (&mut self.scene, brush, meshes),
            Some(Stage::Object) => 0,
            Some(Stage::View) => 1,
            Some(Stage::Ndc) => 2,
        };
        let stages = self.stages.get_or_insert_with(new);
        (&mut stages[stage], brush, meshes)
    }

    /// Copies the page onto a texture of its format.
    pub fn show(&mut self, onto: &wgpu::Texture) {
        self.unshown = false;
        if onto.usage().contains(wgpu::TextureUsages::COPY_DST) {
            let (width, height) = (self.page.width(), self.page.height());
            let size = extent([width.min(onto.width()), height.min(onto.height())]);
            let (from, to) = (self.page.as_image_copy(), onto.as_image_copy());
            (self.gpu).submit(|encoder| encoder.copy_texture_to_texture(from, to, size));
        } else {
            self.panels.draw_page(&self.gpu, &self.page, onto);
        }
    }

    /// A picture of the frame, drawn until its edges are smooth.
    pub fn picture(&mut self, state: &State, laid: &Laid) -> Result<Image<Rgb>, GpuError> {
        let rested = Laid {
            motion: Motion::Rests,
            ..laid.clone()
        };
        self.smooth_picture(self.size, state, &rested)
    }

    /// The scene's picture without panels, drawn until its edges are smooth.
    pub fn picture_alone(
        &mut self,
        state: &State,
        place: SceneRect,
    ) -> Result<Image<Rgb>, GpuError> {
        let origin_px = [0, 0];
        let bare = Laid {
            place: Some(SceneRect { origin_px, ..place }),
            panes: Vec::new(),
            primitives: Arc::default(),
            pixels_per_point: place.pixels_per_point,
            motion: Motion::Rests,
        };
        self.smooth_picture(place.viewport, state, &bare)
    }

    fn smooth_picture(
        &mut self,
        size: Viewport,
        state: &State,
        laid: &Laid,
    ) -> Result<Image<Rgb>, GpuError> {
        loop {
            let progress = self.draw(size, state, laid)?;
            if progress.behind.is_none() && !progress.rough {
                break;
            }
            self.gpu.wait()?;
        }
        self.read()
    }

    /// Reads the page.
    pub fn read(&self) -> Result<Image<Rgb>, GpuError> {
        read_rgb(&self.gpu, &self.page, self.size)
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

/// A texture of this size that can be drawn onto, copied and read.
fn page(gpu: &Gpu, size: Viewport, format: TextureFormat) -> wgpu::Texture {
    use wgpu::TextureUsages as Usages;
    let size = [size.width(), size.height()];
    let usage = Usages::TEXTURE_BINDING | Usages::COPY_SRC | Usages::COPY_DST;
    let view_formats = [format.add_srgb_suffix()];
    without_depth::texture(gpu, "page", size, format, 1, usage, &view_formats)
}
