//! What is drawn: the scene's picture with its marks, and the panels over it, onto any texture.

use super::{
    panels_picture::PanelsPicture,
    place::SceneRect,
    scene_picture::{Look, Progress, ScenePicture},
    wanted::Motion,
};
use crate::{
    camera::Viewport,
    image::{Id, Image, Rgb},
    render::{Gpu, GpuError, MeshStore, read_rgb},
    viewer::{
        jobs::Uploaded,
        model::{OnScreen, State},
    },
};
use egui_wgpu::ScreenDescriptor;
use wgpu::TextureFormat;

/// All that one device draws, and what it has drawn already.
pub(in crate::viewer) struct Canvas {
    pub gpu: Gpu,
    /// What it draws onto: values as they are, viewed as sRGB where the scene goes in.
    pub format: TextureFormat,
    scene: ScenePicture,
    panels: PanelsPicture,
    /// The frame, which stays: only what changes in it is drawn again.
    page: wgpu::Texture,
    size: Viewport,
    /// It is another than the one that was shown last.
    pub unshown: bool,
    /// What the page shows of the scene, and where.
    shown: Option<(SceneRect, Look)>,
}

/// One frame, laid out.
pub(in crate::viewer) struct Laid {
    /// Where the scene goes; `None` where there is no room for it.
    pub place: Option<SceneRect>,
    /// The panels' triangles.
    pub primitives: Vec<egui::ClippedPrimitive>,
    /// Physical pixels for a point.
    pub pixels_per_point: f32,
    /// How the scene moves.
    pub motion: Motion,
}

/// Where frames go: the surface of a window, or a picture in memory.
pub(in crate::viewer) trait Screen {
    /// Sees to a device that works. Returns whether it is another one than before, which has none of egui's textures.
    ///
    /// # Errors
    /// When there is no device to be had.
    fn restore(&mut self) -> Result<bool, GpuError>;

    /// What its device draws with; `None` before there is one.
    fn canvas(&mut self) -> Option<&mut Canvas>;

    /// Draws and shows a frame. Returns how far the scene's picture has come.
    ///
    /// # Errors
    /// When scene or picture are too large, or the device fails.
    fn draw(&mut self, state: &State, laid: &Laid) -> Result<Progress, GpuError>;
}

impl Canvas {
    /// A canvas for textures of this format, which must have an sRGB twin.
    pub fn new(gpu: Gpu, format: TextureFormat) -> Self {
        Self {
            panels: PanelsPicture::new(&gpu, format),
            scene: ScenePicture::new(&gpu),
            page: page(&gpu, Viewport::DEFAULT, format),
            size: Viewport::DEFAULT,
            unshown: true,
            shown: None,
            gpu,
            format,
        }
    }

    /// The largest side that a texture may have, in pixels.
    pub fn max_texture_side(&self) -> usize {
        self.gpu.device.limits().max_texture_dimension_2d as usize
    }

    /// The ids on screen, when they are those of `wanted`.
    pub fn read_ids(&self, wanted: &OnScreen) -> Result<Option<Image<Id>>, GpuError> {
        self.scene.read_ids(&self.gpu, wanted)
    }

    /// Takes a scene that is in graphics memory, and is to be shown next.
    pub fn take_uploaded(&mut self, uploaded: Uploaded) {
        self.scene.scenes.take_uploaded(uploaded);
    }

    /// The meshes in graphics memory.
    pub fn meshes(&self) -> MeshStore {
        self.scene.scenes.meshes.clone()
    }

    /// What is on screen of the scene.
    pub fn on_screen(&self) -> Option<OnScreen> {
        self.scene.on_screen()
    }

    /// Takes what came and went among egui's textures.
    pub fn take_textures(&mut self, textures: &mut egui::TexturesDelta) {
        self.panels.take_textures(&self.gpu, textures);
    }

    /// Brings the page up to date. Returns how far the scene's picture has come.
    ///
    /// # Errors
    /// When scene or picture are too large, or the device fails.
    pub fn draw(
        &mut self,
        size: Viewport,
        state: &State,
        laid: &Laid,
    ) -> Result<Progress, GpuError> {
        let is_new = self.size != size;
        if is_new {
            (self.page, self.size) = (page(&self.gpu, size, self.format), size);
        }
        let mut scene = Ok(Progress::default());
        if let Some(place) = laid.place {
            self.scene.scale_factor = laid.pixels_per_point;
            scene = (self.scene).advance(&self.gpu, state, place.viewport, laid.motion);
        }
        let look = laid.place.zip(self.scene.look(state));
        let screen = ScreenDescriptor {
            size_in_pixels: [size.width(), size.height()],
            pixels_per_point: laid.pixels_per_point,
        };
        let mut painted = self.panels.update(&self.gpu, &laid.primitives, &screen);
        if is_new || look.map(|(place, _)| place) != self.shown.map(|(place, _)| place) {
            painted = vec![[[0, 0], screen.size_in_pixels]];
        }
        if !painted.is_empty() {
            self.panels.copy(&self.gpu, &self.page, &painted);
        }
        let is_over = |place: SceneRect| painted.iter().any(|rect| place.touches(*rect));
        let is_drawn = look != self.shown || look.is_some_and(|(place, _)| is_over(place));
        if let Some((place, look)) = look.filter(|_| is_drawn) {
            (self.scene).composite(&self.gpu, &look, &self.page, place);
            self.panels.draw_over(&self.gpu, &self.page, place);
        }
        self.shown = look;
        self.unshown |= is_drawn || !painted.is_empty();
        if self.gpu.is_software() {
            // The frame time that is shown is the frame's, then, and not that of handing it over.
            self.gpu.wait()?;
        }
        self.gpu.check()?;
        scene
    }

    /// Shows the page on a texture of its format.
    pub fn show(&mut self, onto: &wgpu::Texture) {
        self.unshown = false;
        if onto.usage().contains(wgpu::TextureUsages::COPY_DST) {
            let mut encoder = self.gpu.encoder();
            encoder.copy_texture_to_texture(
                self.page.as_image_copy(),
                onto.as_image_copy(),
                wgpu::Extent3d {
                    width: self.page.width().min(onto.width()),
                    height: self.page.height().min(onto.height()),
                    depth_or_array_layers: 1,
                },
            );
            self.gpu.queue.submit([encoder.finish()]);
        } else {
            self.panels.draw_page(&self.gpu, &self.page, onto);
        }
    }

    /// The frame that was drawn last, with smooth edges.
    ///
    /// # Errors
    /// When memory runs out, or the device fails.
    pub fn picture(&mut self, state: &State, laid: &Laid) -> Result<Image<Rgb>, GpuError> {
        let rested = Laid {
            motion: Motion::Rests,
            primitives: laid.primitives.clone(),
            ..*laid
        };
        self.smooth_picture(self.size, state, &rested)
    }

    /// The scene's picture that was drawn last, without panels.
    ///
    /// # Errors
    /// When memory runs out, or the device fails.
    pub fn picture_alone(
        &mut self,
        state: &State,
        place: SceneRect,
    ) -> Result<Image<Rgb>, GpuError> {
        let bare = Laid {
            place: Some(SceneRect {
                origin_px: [0, 0],
                ..place
            }),
            primitives: Vec::new(),
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

    /// The page.
    ///
    /// # Errors
    /// When memory runs out, or the device fails.
    pub fn read(&self) -> Result<Image<Rgb>, GpuError> {
        let picture = read_rgb(&self.gpu, &self.page, self.size)?;
        if !matches!(self.format, TextureFormat::Bgra8Unorm) {
            return Ok(picture);
        }
        let pixels = picture.pixels().iter().map(|[b, g, r]| [*r, *g, *b]);
        Ok(Image::new(self.size, pixels.collect()))
    }
}

/// A texture of this size that can be drawn onto, copied and read.
fn page(gpu: &Gpu, size: Viewport, format: TextureFormat) -> wgpu::Texture {
    use wgpu::TextureUsages as Usages;
    gpu.device.create_texture(&wgpu::TextureDescriptor {
        label: Some("page"),
        size: wgpu::Extent3d {
            width: size.width(),
            height: size.height(),
            depth_or_array_layers: 1,
        },
        mip_level_count: 1,
        sample_count: 1,
        dimension: wgpu::TextureDimension::D2,
        format,
        usage: Usages::RENDER_ATTACHMENT
            | Usages::TEXTURE_BINDING
            | Usages::COPY_SRC
            | Usages::COPY_DST,
        view_formats: &[format.add_srgb_suffix()],
    })
}
