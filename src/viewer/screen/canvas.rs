//! What is drawn: the scene where it changed, its marks, and the panels over it, onto any texture.

use super::{frozen, overlay_lines, place::SceneRect, surroundings};
use crate::{
    camera::{UpAxis, View, Viewport},
    image::{Id, Image, Rgb},
    render::{
        Destination, Gpu, GpuError, Marks, Renderer, SceneBuffers, Targets, Wireframe, read_rgb,
    },
    viewer::model::{Frozen, OnScreen, Overlay, Overlays, State},
};
use egui_wgpu::{Renderer as EguiRenderer, RendererOptions, ScreenDescriptor};
use std::mem;
use wgpu::TextureFormat;

/// All that one device draws, and what it has drawn already.
pub(in crate::viewer) struct Canvas {
    pub gpu: Gpu,
    /// What it draws onto: values as they are, viewed as sRGB where the scene goes in.
    pub format: TextureFormat,
    renderer: Renderer,
    panels: EguiRenderer,
    /// Of the texture that was drawn onto last.
    size: Viewport,
    scene: Option<Uploaded>,
    /// The scene that does not fit, and why: it is not tried again.
    unfit: Option<(u64, GpuError)>,
    /// What the targets hold.
    drawn: Option<Drawn>,
    targets: Option<Targets>,
    /// egui's textures that the last frame may still have shown.
    stale: Vec<egui::TextureId>,
}

/// The scene on the GPU and which one it is.
struct Uploaded {
    buffers: SceneBuffers,
    revision: u64,
    visibility: u64,
}

/// All that colours and ids depend on, and then the selection, on which its outline depends.
#[derive(Clone, Copy, PartialEq)]
struct Drawn {
    view: View,
    revision: u64,
    visibility: u64,
    grid: Option<UpAxis>,
    frozen: Option<Frozen>,
    /// What is drawn with the scene, about which object, and whether the trees that it may show are there.
    overlays: Option<(Overlays, Option<usize>, bool)>,
    selection: Option<usize>,
}

/// One frame, laid out.
pub(in crate::viewer) struct Laid {
    /// Where the scene goes; `None` where there is no room for it.
    pub place: Option<SceneRect>,
    /// The panels' triangles.
    pub primitives: Vec<egui::ClippedPrimitive>,
    /// Physical pixels for a point.
    pub pixels_per_point: f32,
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

    /// Draws and shows a frame. Returns whether the scene itself was drawn anew.
    ///
    /// # Errors
    /// When scene or picture are too large, or the device fails.
    fn draw(&mut self, state: &State, laid: &Laid) -> Result<bool, GpuError>;
}

impl Canvas {
    /// A canvas for textures of this format, which must have an sRGB twin.
    pub fn new(gpu: Gpu, format: TextureFormat) -> Self {
        let renderer = Renderer::new(&gpu, gpu.colour_samples());
        let panels = EguiRenderer::new(&gpu.device, format, RendererOptions::default());
        Self {
            gpu,
            format,
            renderer,
            panels,
            size: Viewport::DEFAULT,
            scene: None,
            unfit: None,
            drawn: None,
            targets: None,
            stale: Vec::new(),
        }
    }

    /// The largest side that a texture may have, in pixels.
    pub fn max_texture_side(&self) -> usize {
        self.gpu.device.limits().max_texture_dimension_2d as usize
    }

    /// The ids on screen, when they are those of `wanted`.
    pub fn read_ids(&self, wanted: &OnScreen) -> Result<Option<Image<Id>>, GpuError> {
        let (Some(targets), Some(drawn)) = (&self.targets, &self.drawn) else {
            return Ok(None);
        };
        let shown = OnScreen {
            view: drawn.view,
            scene_revision: drawn.revision,
            visibility_revision: drawn.visibility,
        };
        let is_wanted = shown == *wanted;
        is_wanted.then(|| targets.read_ids(&self.gpu)).transpose()
    }

    /// Takes what came and went among egui's textures. What goes may still be in the next frame, and is freed after it.
    pub fn take_textures(&mut self, textures: &mut egui::TexturesDelta) {
        for id in mem::take(&mut self.stale) {
            self.panels.free_texture(&id);
        }
        for (id, deltas) in mem::take(&mut textures.set) {
            for delta in deltas {
                self.panels
                    .update_texture(&self.gpu.device, &self.gpu.queue, id, &delta);
            }
        }
        self.stale.extend(mem::take(&mut textures.free));
    }

    /// Draws a frame onto all of a texture. Returns whether the scene itself was drawn anew.
    ///
    /// # Errors
    /// When scene or picture are too large, or the device fails.
    pub fn draw(
        &mut self,
        texture: &wgpu::Texture,
        state: &State,
        laid: &Laid,
    ) -> Result<bool, GpuError> {
        let view_as = |format: TextureFormat| {
            texture.create_view(&wgpu::TextureViewDescriptor {
                format: Some(format),
                ..Default::default()
            })
        };
        let format = self.format;
        let size_px = [texture.width(), texture.height()];
        self.size = Viewport::new(size_px[0], size_px[1]).unwrap_or(self.size);
        let mut scene = Ok(false);
        if let Some(place) = laid.place {
            self.renderer.scale_factor = laid.pixels_per_point;
            scene = self.draw_scene(state, place.viewport);
        }
        if let (Some(place), Ok(_)) = (laid.place, &scene) {
            let selection = state.selection().map(|selection| selection.object);
            if let (Some(scene), Some(targets)) = (&self.scene, &self.targets) {
                self.renderer.composite(
                    &self.gpu,
                    &scene.buffers,
                    targets,
                    state.view(),
                    &Marks {
                        selection,
                        hover: state.hover(),
                    },
                    &Destination {
                        view: &view_as(format.add_srgb_suffix()),
                        format: format.add_srgb_suffix(),
                        size_px,
                        origin_px: place.origin_px,
                    },
                );
            }
        }
        self.gpu.check()?;
        // egui blends in sRGB values, so it draws through a view that does not convert them.
        // Where the scene could not be drawn, they say so.
        self.draw_panels(&view_as(format), size_px, laid, scene.is_ok());
        if self.gpu.is_software() {
            // The frame time that is shown is the frame's, then, and not that of handing it over.
            self.gpu.wait()?;
        }
        self.gpu.check()?;
        scene
    }

    /// The frame that was drawn last, as a picture.
    ///
    /// # Errors
    /// When memory runs out, or the device fails.
    pub fn picture(&mut self, state: &State, laid: &Laid) -> Result<Image<Rgb>, GpuError> {
        let texture = self.texture(self.size);
        self.draw(&texture, state, laid)?;
        let picture = read_rgb(&self.gpu, &texture, self.size)?;
        if !matches!(self.format, TextureFormat::Bgra8Unorm) {
            return Ok(picture);
        }
        let pixels = picture.pixels().iter().map(|[b, g, r]| [*r, *g, *b]);
        Ok(Image::new(self.size, pixels.collect()))
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

    /// Brings the targets up to date. Returns whether colours had to be drawn.
    fn draw_scene(&mut self, state: &State, viewport: Viewport) -> Result<bool, GpuError> {
        self.upload(state)?;
        if self
            .targets
            .as_ref()
            .is_none_or(|targets| targets.viewport() != viewport)
        {
            self.targets = Some(Targets::new(
                &self.gpu,
                viewport,
                self.gpu.colour_samples(),
            )?);
            self.drawn = None;
        }
        let (Some(scene), Some(targets)) = (&self.scene, &self.targets) else {
            return Ok(false);
        };
        let selection = state.selection().map(|selection| selection.object);
        let overlays = state.overlays();
        let wanted = Drawn {
            overlays: (overlays.in_scene())
                .then(|| (overlays, selection, state.scene().trees_are_built())),
            view: View {
                viewport,
                ..*state.view()
            },
            revision: state.scene_revision(),
            visibility: state.visibility_revision(),
            grid: state.grid().then_some(state.shown_up_axis()),
            frozen: state.frozen().copied(),
            selection,
        };
        let unmarked = |drawn: Drawn| Drawn {
            selection: None,
            ..drawn
        };
        let anew = self.drawn.map(unmarked) != Some(unmarked(wanted));
        if anew {
            let scene_now = state.scene();
            let floor = wanted
                .grid
                .map(|up_axis| surroundings::floor(&scene_now.visible_bounds(), up_axis));
            let frozen = wanted
                .frozen
                .map(|frozen| frozen::lines(&frozen, scene_now));
            let stage = surroundings::of(state.stage());
            let lines: Vec<_> = floor
                .into_iter()
                .chain(frozen)
                .chain([stage, overlay_lines::lines(state)])
                .flatten()
                .collect();
            self.renderer.wireframe = overlays
                .shows(Overlay::Wireframe)
                .then(|| selection.map_or(Wireframe::OfAll, Wireframe::Of));
            self.renderer
                .draw(&self.gpu, &scene.buffers, targets, &wanted.view, &lines)?;
        }
        if let Some(object) = wanted.selection.filter(|_| self.drawn != Some(wanted)) {
            self.renderer
                .draw_selection(&self.gpu, &scene.buffers, targets, &wanted.view, object);
        }
        self.drawn = Some(wanted);
        Ok(anew)
    }

    fn upload(&mut self, state: &State) -> Result<(), GpuError> {
        let (revision, visibility) = (state.scene_revision(), state.visibility_revision());
        match &mut self.scene {
            Some(scene) if scene.revision == revision => {
                if scene.visibility != visibility {
                    scene.buffers.update(&self.gpu, state.scene())?;
                    scene.visibility = visibility;
                }
            }
            _ => {
                if let Some((_, error)) = self.unfit.as_ref().filter(|(of, _)| *of == revision) {
                    return Err(error.clone());
                }
                let buffers = SceneBuffers::upload(&self.gpu, state.scene());
                let buffers = buffers.inspect_err(|error| {
                    self.unfit = Some((revision, error.clone()));
                })?;
                self.scene = Some(Uploaded {
                    buffers,
                    revision,
                    visibility,
                });
            }
        }
        Ok(())
    }

    fn draw_panels(
        &mut self,
        view: &wgpu::TextureView,
        size_px: [u32; 2],
        laid: &Laid,
        has_scene: bool,
    ) {
        let screen = ScreenDescriptor {
            size_in_pixels: size_px,
            pixels_per_point: laid.pixels_per_point,
        };
        let Gpu { device, queue, .. } = &self.gpu;
        let mut encoder = device.create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
        self.panels
            .update_buffers(device, queue, &mut encoder, &laid.primitives, &screen);
        let pass = encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
            label: Some("panels"),
            color_attachments: &[Some(wgpu::RenderPassColorAttachment {
                view,
                depth_slice: None,
                resolve_target: None,
                ops: wgpu::Operations {
                    load: if has_scene && laid.place.is_some() {
                        wgpu::LoadOp::Load
                    } else {
                        wgpu::LoadOp::Clear(wgpu::Color::BLACK)
                    },
                    store: wgpu::StoreOp::Store,
                },
            })],
            ..wgpu::RenderPassDescriptor::default()
        });
        self.panels
            .render(&mut pass.forget_lifetime(), &laid.primitives, &screen);
        queue.submit([encoder.finish()]);
    }
}
