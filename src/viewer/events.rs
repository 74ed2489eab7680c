//! The event loop's side: events in, frames out.

use super::{ViewerError, Wake, app::App, pass::Pass, shell::Shell};
use std::time::Instant;
use winit::{
    application::ApplicationHandler,
    dpi::PhysicalSize,
    event::{StartCause, WindowEvent},
    event_loop::{ActiveEventLoop, ControlFlow},
    window::WindowId,
};

/// The program in its window.
pub(super) struct Host {
    pub app: App,
    /// The window, once the event loop runs.
    pub shell: Option<Shell>,
    /// Why it could not be opened, for the caller of [`super::run`].
    pub failed: Option<ViewerError>,
}

impl Host {
    fn pass(&mut self, event_loop: &ActiveEventLoop) -> Option<Pass> {
        let shell = self.shell.as_mut()?;
        let input = shell.egui.take_egui_input(&shell.window);
        let mut pass = self.app.pass(input);
        let platform = std::mem::take(&mut pass.platform);
        shell.egui.handle_platform_output(&shell.window, platform);
        if self.app.quit {
            event_loop.exit();
        }
        Some(pass)
    }

    fn redraw(&mut self, event_loop: &ActiveEventLoop) {
        let start = Instant::now();
        self.app.take_loaded();
        self.app.take_checked();
        let Some(pass) = self.pass(event_loop) else {
            return;
        };
        let (app, Some(shell)) = (&mut self.app, &mut self.shell) else {
            return;
        };
        let title = format!("{} \u{2013} Sightline", app.state.name());
        shell.window.set_title(&title);
        match shell.surface.restore() {
            Ok(false) => {}
            Ok(true) => app.textures.renew(),
            Err(error) => return app.complain(error.to_string()),
        }
        let laid = app.lay(pass, &mut shell.surface.canvas);
        let drawn = shell.surface.draw(&app.state, &laid);
        if let Ok(true) = drawn {
            app.statistics.frame = start.elapsed();
        }
        app.drawn(drawn, &mut shell.surface.canvas, &laid);
    }

    fn request_redraw(&self) {
        if let Some(shell) = &self.shell {
            shell.window.request_redraw();
        }
    }
}

impl ApplicationHandler<Wake> for Host {
    fn new_events(&mut self, event_loop: &ActiveEventLoop, cause: StartCause) {
        if let StartCause::ResumeTimeReached { .. } = cause {
            event_loop.set_control_flow(ControlFlow::Wait);
            self.request_redraw();
        }
    }

    fn resumed(&mut self, event_loop: &ActiveEventLoop) {
        if self.shell.is_some() {
            return;
        }
        let app = &mut self.app;
        match Shell::open(event_loop, &app.options, app.context.clone()) {
            Ok(shell) => {
                let gpu = &shell.surface.canvas.gpu;
                gpu.adapter_name().clone_into(&mut app.statistics.adapter);
                app.statistics.software = gpu.is_software();
                self.shell = Some(shell);
                self.request_redraw();
            }
            Err(error) => {
                self.failed = Some(error);
                event_loop.exit();
            }
        }
    }

    fn user_event(&mut self, event_loop: &ActiveEventLoop, wake: Wake) {
        match wake {
            Wake::Look => self.request_redraw(),
            Wake::Answered(answer) => {
                self.app.answered(answer);
                self.request_redraw();
            }
            Wake::RepaintAt(time) if time <= Instant::now() => self.request_redraw(),
            Wake::RepaintAt(time) => event_loop.set_control_flow(ControlFlow::WaitUntil(time)),
        }
    }

    fn window_event(&mut self, event_loop: &ActiveEventLoop, _: WindowId, event: WindowEvent) {
        let Some(shell) = &mut self.shell else {
            return;
        };
        match &event {
            WindowEvent::CloseRequested => return event_loop.exit(),
            WindowEvent::RedrawRequested => return self.redraw(event_loop),
            WindowEvent::Resized(PhysicalSize { width, height }) => {
                shell.surface.resize(*width, *height);
            }
            _ => {}
        }
        // A press, the moves after it and the release are each seen in a pass of their own, however slow frames are:
        // of what happens within one pass egui sees only the end.
        let is_button = matches!(event, WindowEvent::MouseInput { .. });
        if is_button {
            self.pass(event_loop);
        }
        let Some(shell) = &mut self.shell else { return };
        if shell.egui.on_window_event(&shell.window, &event).repaint {
            self.request_redraw();
        }
        if is_button {
            self.pass(event_loop);
        }
    }
}
