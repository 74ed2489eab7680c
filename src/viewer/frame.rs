//! One frame: the scene where it changed, its marks, and the panels over it, onto the window's surface.

use super::{
    check::OnScreen,
    frozen,
    input::SceneRect,
    stage,
    state::{Frozen, State},
};
use crate::{
    camera::{UpAxis, View},
    image::{Id, Image},
    render::{Destination, Gpu, GpuError, Marks, Renderer, SceneBuffers, Targets},
};
use egui_wgpu::{Renderer as EguiRenderer, RendererOptions, ScreenDescriptor};
use std::{mem, sync::Arc};
use wgpu::{CurrentSurfaceTexture, SurfaceConfiguration, SurfaceTexture, TextureFormat};
use winit::{event_loop::OwnedDisplayHandle, window::Window};

/// The window's surface and all that is drawn onto it.
pub(super) struct Frame {
    window: Arc<Window>,
    instance: wgpu::Instance,
    surface: wgpu::Surface<'static>,
    config: SurfaceConfiguration,
    gpu: Gpu,
    renderer: Renderer,
    panels: EguiRenderer,
    scene: Option<Scene>,
    /// What the targets hold.
    drawn: Option<Drawn>,
    targets: Option<Targets>,
}

/// The scene on the GPU and which one it is.
struct Scene {
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
    selection: Option<usize>,
}

/// The panels as egui wants them drawn.
pub(super) struct Panels {
    /// Triangles.
    pub primitives: Vec<egui::ClippedPrimitive>,
    /// Textures that came and went.
    pub textures: egui::TexturesDelta,
    /// Physical pixels for a point.
    pub pixels_per_point: f32,
}

impl Frame {
    /// A surface on `window` and a device that draws on it.
    pub fn new(window: Arc<Window>, display: OwnedDisplayHandle) -> Result<Self, GpuError> {
        let descriptor =
            wgpu::InstanceDescriptor::new_with_display_handle_from_env(Box::new(display));
        let instance = wgpu::Instance::new(descriptor);
        let surface = instance
            .create_surface(Arc::clone(&window))
            .map_err(|_| GpuError::NoAdapter)?;
        let gpu = Gpu::for_surface(&instance, &surface)?;
        let config = configuration(&gpu, &surface, &window)?;
        let renderer = Renderer::new(&gpu, gpu.colour_samples());
        let panels = EguiRenderer::new(&gpu.device, config.format, RendererOptions::default());
        let frame = Self {
            window,
            instance,
            surface,
            config,
            gpu,
            renderer,
            panels,
            scene: None,
            drawn: None,
            targets: None,
        };
        frame.configure();
        Ok(frame)
    }

    /// What the adapter calls itself.
    pub fn adapter_name(&self) -> String {
        self.gpu.adapter_name().to_owned()
    }

    /// Whether the processor draws.
    pub fn is_software(&self) -> bool {
        self.gpu.is_software()
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

    /// The window has another size; 0 while it is minimised.
    pub fn resize(&mut self, width: u32, height: u32) {
        (self.config.width, self.config.height) = (width, height);
        self.configure();
    }

    /// Draws and shows a frame; the scene in the rectangle `place`. Returns whether the scene itself was drawn anew.
    pub fn draw(
        &mut self,
        state: &State,
        place: Option<SceneRect>,
        mut panels: Panels,
    ) -> Result<bool, GpuError> {
        for (id, deltas) in mem::take(&mut panels.textures.set) {
            for delta in deltas {
                self.panels
                    .update_texture(&self.gpu.device, &self.gpu.queue, id, &delta);
            }
        }
        let freed = mem::take(&mut panels.textures.free);
        let drawn = match self.acquire()? {
            Some(surface_texture) => {
                let anew = self.draw_onto(&surface_texture, state, place, &panels)?;
                self.window.pre_present_notify();
                self.gpu.queue.present(surface_texture);
                anew
            }
            None => false,
        };
        for id in freed {
            self.panels.free_texture(&id);
        }
        Ok(drawn)
    }

    fn draw_onto(
        &mut self,
        surface_texture: &SurfaceTexture,
        state: &State,
        place: Option<SceneRect>,
        panels: &Panels,
    ) -> Result<bool, GpuError> {
        let view_as = |format: TextureFormat| {
            surface_texture
                .texture
                .create_view(&wgpu::TextureViewDescriptor {
                    format: Some(format),
                    ..Default::default()
                })
        };
        let format = self.config.format;
        let mut anew = false;
        if let Some(place) = place {
            anew = self.draw_scene(state, place.viewport)?;
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
                        size_px: [self.config.width, self.config.height],
                        origin_px: place.origin_px,
                    },
                );
            }
        }
        // egui blends in sRGB values, so it draws through a view that does not convert them.
        self.draw_panels(&view_as(format), panels, place.is_some());
        Ok(anew)
    }

    /// Brings the targets up to date. Returns whether colours had to be drawn.
    fn draw_scene(
        &mut self,
        state: &State,
        viewport: crate::camera::Viewport,
    ) -> Result<bool, GpuError> {
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
        let wanted = Drawn {
            view: View {
                viewport,
                ..*state.view()
            },
            revision: state.scene_revision(),
            visibility: state.visibility_revision(),
            grid: state.grid().then_some(state.up_axis()),
            frozen: state.frozen().copied(),
            selection: state.selection().map(|selection| selection.object),
        };
        let unmarked = |drawn: Drawn| Drawn {
            selection: None,
            ..drawn
        };
        let anew = self.drawn.map(unmarked) != Some(unmarked(wanted));
        #[expect(clippy::cast_possible_truncation, reason = "a small factor")]
        {
            self.renderer.scale_factor = self.window.scale_factor() as f32;
        }
        if anew {
            let scene_now = state.scene();
            let floor = wanted
                .grid
                .map(|up_axis| stage::floor(&scene_now.visible_bounds(), up_axis));
            let frozen = wanted
                .frozen
                .map(|frozen| frozen::lines(&frozen, scene_now));
            let stage = stage::of(state.stage());
            let lines: Vec<_> = floor
                .into_iter()
                .chain(frozen)
                .chain([stage])
                .flatten()
                .collect();
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
                let buffers = SceneBuffers::upload(&self.gpu, state.scene())?;
                self.scene = Some(Scene {
                    buffers,
                    revision,
                    visibility,
                });
            }
        }
        Ok(())
    }

    fn draw_panels(&mut self, view: &wgpu::TextureView, panels: &Panels, over_scene: bool) {
        let screen = ScreenDescriptor {
            size_in_pixels: [self.config.width, self.config.height],
            pixels_per_point: panels.pixels_per_point,
        };
        let Gpu { device, queue, .. } = &self.gpu;
        let mut encoder = device.create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
        self.panels
            .update_buffers(device, queue, &mut encoder, &panels.primitives, &screen);
        let pass = encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
            label: Some("panels"),
            color_attachments: &[Some(wgpu::RenderPassColorAttachment {
                view,
                depth_slice: None,
                resolve_target: None,
                ops: wgpu::Operations {
                    load: if over_scene {
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
            .render(&mut pass.forget_lifetime(), &panels.primitives, &screen);
        queue.submit([encoder.finish()]);
        if self.gpu.is_software() {
            // The frame time that is shown is the frame's, then, and not that of handing it over.
            let _ = self.gpu.wait();
        }
    }

    /// The next texture to draw on; `None` when there is none to be had now, as while minimised.
    fn acquire(&mut self) -> Result<Option<SurfaceTexture>, GpuError> {
        for _ in 0..2 {
            if self.config.width == 0 || self.config.height == 0 {
                return Ok(None);
            }
            match self.surface.get_current_texture() {
                CurrentSurfaceTexture::Success(texture)
                | CurrentSurfaceTexture::Suboptimal(texture) => {
                    return Ok(Some(texture));
                }
                CurrentSurfaceTexture::Timeout | CurrentSurfaceTexture::Occluded => {
                    return Ok(None);
                }
                CurrentSurfaceTexture::Lost => {
                    let surface = self.instance.create_surface(Arc::clone(&self.window));
                    self.surface = surface.map_err(|_| GpuError::NoAdapter)?;
                }
                CurrentSurfaceTexture::Outdated | CurrentSurfaceTexture::Validation => {}
            }
            let size = self.window.inner_size();
            (self.config.width, self.config.height) = (size.width, size.height);
            self.configure();
        }
        Ok(None)
    }

    fn configure(&self) {
        if self.config.width > 0 && self.config.height > 0 {
            self.surface.configure(&self.gpu.device, &self.config);
        }
    }
}

/// How the surface shows frames: sRGB values as they are, viewed as light where the scene is put in; in step with the
/// screen.
fn configuration(
    gpu: &Gpu,
    surface: &wgpu::Surface,
    window: &Window,
) -> Result<SurfaceConfiguration, GpuError> {
    let formats = surface.get_capabilities(&gpu.adapter).formats;
    let plain = [TextureFormat::Bgra8Unorm, TextureFormat::Rgba8Unorm];
    let format = plain
        .into_iter()
        .find(|format| formats.contains(format))
        .ok_or_else(|| GpuError::Device {
            adapter: gpu.adapter_name().to_owned(),
            reason: "the screen takes no 8-bit colours".into(),
        })?;
    let size = window.inner_size();
    Ok(SurfaceConfiguration {
        usage: wgpu::TextureUsages::RENDER_ATTACHMENT,
        format,
        color_space: wgpu::SurfaceColorSpace::Auto,
        width: size.width,
        height: size.height,
        present_mode: wgpu::PresentMode::AutoVsync,
        desired_maximum_frame_latency: 1,
        alpha_mode: wgpu::CompositeAlphaMode::Auto,
        view_formats: vec![format.add_srgb_suffix()],
    })
}
