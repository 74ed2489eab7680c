//! The window's surface: presents frames, and is made again when it or the whole device is lost.

use super::canvas::{Canvas, Laid, Screen};
use crate::{
    camera::Viewport,
    render::{Gpu, GpuError},
};
use std::sync::Arc;
use wgpu::{
    CurrentSurfaceTexture, SurfaceConfiguration, SurfaceTexture, TextureFormat, TextureUsages,
};
use winit::{event_loop::OwnedDisplayHandle, window::Window};

/// A window's surface and the canvas that draws onto it.
pub(in crate::viewer) struct WindowSurface {
    window: Arc<Window>,
    instance: wgpu::Instance,
    screen: wgpu::Surface<'static>,
    config: SurfaceConfiguration,
    canvas: Canvas,
}

impl WindowSurface {
    /// A surface on `window` and a device that draws on it.
    pub fn new(window: Arc<Window>, display: OwnedDisplayHandle) -> Result<Self, GpuError> {
        let descriptor =
            wgpu::InstanceDescriptor::new_with_display_handle_from_env(Box::new(display));
        let instance = wgpu::Instance::new(descriptor);
        let screen = create(&instance, &window)?;
        let (gpu, format) = Gpu::for_surface(&instance, &screen)?;
        let config = configuration(format, &window);
        let canvas = Canvas::new(gpu, config.format);
        let surface = Self {
            window,
            instance,
            screen,
            config,
            canvas,
        };
        surface.configure();
        Ok(surface)
    }

    /// The window has another size; 0 while it is minimised.
    pub fn resize(&mut self, width: u32, height: u32) {
        (self.config.width, self.config.height) = (width, height);
        self.configure();
    }

    /// The next texture to draw on; `None` when there is none now, such as while the window is minimised.
    fn acquire(&mut self) -> Result<Option<SurfaceTexture>, GpuError> {
        for _ in 0..2 {
            if self.config.width == 0 || self.config.height == 0 {
                return Ok(None);
            }
            match self.screen.get_current_texture() {
                CurrentSurfaceTexture::Success(texture)
                | CurrentSurfaceTexture::Suboptimal(texture) => {
                    return Ok(Some(texture));
                }
                CurrentSurfaceTexture::Timeout | CurrentSurfaceTexture::Occluded => {
                    return Ok(None);
                }
                CurrentSurfaceTexture::Lost => {
                    self.screen = create(&self.instance, &self.window)?;
                }
                CurrentSurfaceTexture::Outdated | CurrentSurfaceTexture::Validation => {}
            }
            let size = self.window.inner_size();
            (self.config.width, self.config.height) = (size.width, size.height);
            self.configure();
        }
        Ok(None)
    }

    /// Configures the surface, unless it is empty.
    fn configure(&self) {
        if self.config.width > 0 && self.config.height > 0 {
            self.screen
                .configure(&self.canvas.gpu().device, &self.config);
        }
    }
}

impl Screen for WindowSurface {
    fn restore(&mut self) -> Result<bool, GpuError> {
        if !self.canvas.gpu().is_lost() {
            return Ok(false);
        }
        let screen = create(&self.instance, &self.window)?;
        let (gpu, format) = Gpu::for_surface(&self.instance, &screen)?;
        self.config = configuration(format, &self.window);
        self.canvas = Canvas::new(gpu, format);
        self.screen = screen;
        self.configure();
        Ok(true)
    }

    fn canvas(&mut self) -> Option<&mut Canvas> {
        Some(&mut self.canvas)
    }

    fn size(&self) -> Option<Viewport> {
        Viewport::new(self.config.width, self.config.height).ok()
    }

    fn paint(&mut self, laid: &Laid) -> Result<(), GpuError> {
        if let Some(frame) = self.acquire()? {
            let painted = self.canvas.paint(laid, &frame.texture);
            self.window.pre_present_notify();
            self.canvas.gpu().queue.present(frame);
            painted?;
        }
        Ok(())
    }
}

fn create(
    instance: &wgpu::Instance,
    window: &Arc<Window>,
) -> Result<wgpu::Surface<'static>, GpuError> {
    let surface = instance.create_surface(Arc::clone(window));
    surface.map_err(|_| Gpu::no_window(instance))
}

/// How the surface shows frames: sRGB values as they are, with vsync.
fn configuration(format: TextureFormat, window: &Window) -> SurfaceConfiguration {
    let size = window.inner_size();
    SurfaceConfiguration {
        usage: TextureUsages::RENDER_ATTACHMENT,
        format,
        color_space: wgpu::SurfaceColorSpace::Auto,
        width: size.width,
        height: size.height,
        present_mode: wgpu::PresentMode::AutoVsync,
        desired_maximum_frame_latency: 1,
        alpha_mode: wgpu::CompositeAlphaMode::Auto,
        view_formats: Vec::new(),
    }
}

#[cfg(all(test, target_os = "linux"))]
mod tests {
    use super::*;
    use crate::look::Background;
    use std::{env, process::Command};
    use winit::{
        application::ApplicationHandler,
        event::WindowEvent,
        event_loop::{ActiveEventLoop, EventLoop},
        platform::x11::EventLoopBuilderExtX11,
        window::WindowId,
    };

    /// Loses a window's device as soon as there is a window.
    #[derive(Default)]
    struct Losing {
        is_done: bool,
    }

    impl ApplicationHandler for Losing {
        fn resumed(&mut self, event_loop: &ActiveEventLoop) {
            let window = event_loop.create_window(Window::default_attributes());
            let window = Arc::new(window.expect("a window"));
            let surface = WindowSurface::new(window, event_loop.owned_display_handle());
            let mut surface = surface.unwrap_or_else(|error| panic!("{error}"));
            assert_eq!(surface.restore(), Ok(false), "nothing is lost");
            surface.canvas.gpu().device.destroy();
            // The next poll reports the loss.
            let _ = surface.canvas.gpu().wait();
            assert_eq!(surface.restore(), Ok(true));
            assert_eq!(surface.restore(), Ok(false), "once for each loss");
            let laid = Laid {
                place: None,
                panes: Vec::new(),
                primitives: Vec::new(),
                panels_on: egui::Color32::BLACK,
                background: Background::DARK,
                pixels_per_point: 1.0,
                moves: false,
            };
            let painted = surface.paint(&laid);
            painted.unwrap_or_else(|error| panic!("{error}"));
            self.is_done = true;
            event_loop.exit();
        }

        fn window_event(&mut self, _: &ActiveEventLoop, _: WindowId, _: WindowEvent) {}
    }

    /// A window whose device is lost goes on with another, on the same window. Windows need a display: the test runs
    /// itself again under Xvfb.
    #[test]
    fn a_window_s_lost_device_is_replaced() {
        const HAS_DISPLAY: &str = "SIGHTLINE_TEST_HAS_DISPLAY";
        if env::var_os(HAS_DISPLAY).is_none() {
            let output = Command::new("xvfb-run")
                .arg("-a")
                .arg(env::current_exe().expect("this test"))
                .args([
                    "--exact",
                    "viewer::screen::window_surface::tests::a_window_s_lost_device_is_replaced",
                ])
                .env(HAS_DISPLAY, "")
                .output()
                .expect("xvfb-run runs (Debian, Ubuntu: apt-get install xvfb)");
            let said = String::from_utf8_lossy(&output.stdout);
            let is_done = output.status.success() && said.contains("1 passed");
            assert!(is_done, "{said}{}", String::from_utf8_lossy(&output.stderr));
            return;
        }
        let event_loop = EventLoop::builder()
            .with_x11()
            .with_any_thread(true)
            .build()
            .expect("a display");
        let mut losing = Losing::default();
        event_loop.run_app(&mut losing).expect("it ends");
        assert!(losing.is_done);
    }
}
