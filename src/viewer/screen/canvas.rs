//! What is drawn: the scene's picture with its marks, and the panels over it, onto any texture.

use super::{
    panels_picture::PanelsPicture,
    place::SceneRect,
    scene_picture::{Progress, ScenePicture},
};
use crate::{
    camera::Viewport,
    image::{Id, Image, Rgb},
    render::{Destination, Gpu, GpuError, MeshStore, read_rgb},
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
    /// Of the texture that was drawn onto last.
    size: Viewport,
}

/// One frame, laid out.
pub(in crate::viewer) struct Laid {
    /// Where the scene goes; `None` where there is no room for it.
    pub place: Option<SceneRect>,
    /// The panels' triangles.
    pub primitives: Vec<egui::ClippedPrimitive>,
    /// Physical pixels for a point.
    pub pixels_per_point: f32,
    /// Nobody moves the picture: it may get smooth edges.
    pub at_rest: bool,
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
            gpu,
            format,
            size: Viewport::DEFAULT,
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
        self.scene.take_uploaded(uploaded);
    }

    /// The meshes in graphics memory.
    pub fn meshes(&self) -> MeshStore {
        self.scene.meshes().clone()
    }

    /// What is on screen of the scene.
    pub fn on_screen(&self) -> Option<OnScreen> {
        self.scene.on_screen()
    }

    /// Takes what came and went among egui's textures.
    pub fn take_textures(&mut self, textures: &mut egui::TexturesDelta) {
        self.panels.take_textures(&self.gpu, textures);
    }

    /// Draws a frame onto all of a texture, with smooth edges in time if the picture is `at_rest`. Returns how far the
    /// scene's picture has come.
    ///
    /// # Errors
    /// When scene or picture are too large, or the device fails.
    pub fn draw(
        &mut self,
        texture: &wgpu::Texture,
        state: &State,
        laid: &Laid,
        at_rest: bool,
    ) -> Result<Progress, GpuError> {
        let view_as = |format: TextureFormat| {
            texture.create_view(&wgpu::TextureViewDescriptor {
                format: Some(format),
                ..Default::default()
            })
        };
        let format = self.format;
        let size_px = [texture.width(), texture.height()];
        self.size = Viewport::new(size_px[0], size_px[1]).unwrap_or(self.size);
        let (mut scene, mut has_scene) = (Ok(Progress::default()), false);
        if let Some(place) = laid.place {
            self.scene.renderer.scale_factor = laid.pixels_per_point;
            scene = self
                .scene
                .advance(&self.gpu, state, place.viewport, at_rest);
        }
        if let (Some(place), Ok(_)) = (laid.place, &scene) {
            let destination = Destination {
                view: &view_as(format.add_srgb_suffix()),
                format: format.add_srgb_suffix(),
                size_px,
                origin_px: place.origin_px,
            };
            has_scene = self.scene.composite(&self.gpu, state, &destination);
        }
        self.gpu.check()?;
        // egui blends in sRGB values, so it draws through a view that does not convert them.
        // Where the scene could not be drawn, they say so.
        let screen = ScreenDescriptor {
            size_in_pixels: size_px,
            pixels_per_point: laid.pixels_per_point,
        };
        let load = if has_scene {
            wgpu::LoadOp::Load
        } else {
            wgpu::LoadOp::Clear(wgpu::Color::BLACK)
        };
        self.panels
            .draw(&self.gpu, &view_as(format), &laid.primitives, &screen, load);
        if self.gpu.is_software() {
            // The frame time that is shown is the frame's, then, and not that of handing it over.
            self.gpu.wait()?;
        }
        self.gpu.check()?;
        scene
    }

    /// The frame that was drawn last, as a picture, with smooth edges.
    ///
    /// # Errors
    /// When memory runs out, or the device fails.
    pub fn picture(&mut self, state: &State, laid: &Laid) -> Result<Image<Rgb>, GpuError> {
        let texture = self.texture(self.size);
        loop {
            let progress = self.draw(&texture, state, laid, true)?;
            if !progress.behind && !progress.rough {
                break;
            }
            self.gpu.wait()?;
        }
        let picture = read_rgb(&self.gpu, &texture, self.size)?;
        if !matches!(self.format, TextureFormat::Bgra8Unorm) {
            return Ok(picture);
        }
        let pixels = picture.pixels().iter().map(|[b, g, r]| [*r, *g, *b]);
        Ok(Image::new(self.size, pixels.collect()))
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
        let size = self.size;
        let bare = Laid {
            place: Some(SceneRect {
                origin_px: [0, 0],
                ..place
            }),
            primitives: Vec::new(),
            pixels_per_point: place.pixels_per_point,
            at_rest: true,
        };
        self.size = place.viewport;
        let picture = self.picture(state, &bare);
        self.size = size;
        picture
    }

    /// A texture of this size that it can draw onto and that can be read.
    pub fn texture(&self, size: Viewport) -> wgpu::Texture {
        self.gpu.device.create_texture(&wgpu::TextureDescriptor {
            label: Some("window"),
            size: wgpu::Extent3d {
                width: size.width(),
                height: size.height(),
                depth_or_array_layers: 1,
            },
            mip_level_count: 1,
            sample_count: 1,
            dimension: wgpu::TextureDimension::D2,
            format: self.format,
            usage: wgpu::TextureUsages::RENDER_ATTACHMENT | wgpu::TextureUsages::COPY_SRC,
            view_formats: &[self.format.add_srgb_suffix()],
        })
    }
}
