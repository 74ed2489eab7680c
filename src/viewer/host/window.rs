//! The window's event loop: events in, frames out.

use super::shell::Shell;
#[cfg(feature = "screen-readers")]
use crate::viewer::app::Reader;
use crate::viewer::{
    app::{App, Host, Wake, Waker},
    jobs::ask_darkness,
    options::{Options, ViewerError},
    ui::{Attempt, Command},
};
use egui::Theme;
use std::{
    sync::Arc,
    time::{Duration, Instant},
};
use winit::{
    application::ApplicationHandler,
    dpi::PhysicalSize,
    event::{StartCause, WindowEvent},
    event_loop::{ActiveEventLoop, ControlFlow, EventLoop},
    window::WindowId,
};

/// Opens the window and returns when it is closed.
pub fn run(options: Options) -> Result<(), ViewerError> {
    let event_loop = event_loop()?;
    event_loop.set_control_flow(ControlFlow::Wait);
    let proxy = event_loop.create_proxy();
    // Sending fails once the loop has ended with the window: then nobody is to be woken.
    let wake: Waker = Arc::new(move |wake| drop(proxy.send_event(wake)));
    let app = App::start(
        options,
        Arc::clone(&wake),
        Host::Window,
        egui::Context::default(),
    );
    app.context.set_request_repaint_callback(move |info| {
        let delay = info.delay.min(Duration::from_hours(1));
        wake(Wake::RepaintAt(Instant::now() + delay));
    });
    let mut host = Program {
        app,
        shell: None,
        failed: None,
    };
    let ran = event_loop.run_app(&mut host);
    ran.map_err(|reason| {
        log::info!("{reason}");
        ViewerError::DisplayGone(host.app.rescue())
    })?;
    host.failed.map_or(Ok(()), Err)
}

/// Checks that there is a display to open a window on. Not to be called in a process that has a window.
pub fn display() -> Result<(), ViewerError> {
    event_loop::<()>().map(drop)
}

/// An event loop on the display that answers: Wayland's before X11's.
fn event_loop<T>() -> Result<EventLoop<T>, ViewerError> {
    let mut builder = EventLoop::with_user_event();
    #[cfg(target_os = "linux")]
    super::display::choose(&mut builder)?;
    let built = builder.build();
    built.map_err(|error| ViewerError::no_display(&error))
}

/// The program in its window.
struct Program {
    app: App,
    /// The window, once the event loop runs.
    shell: Option<Shell>,
    /// Why the window could not be opened, for the caller of [`run`].
    failed: Option<ViewerError>,
}

impl Program {
    /// Runs a pass on the input since the last one, without drawing.
    fn pass(&mut self, event_loop: &ActiveEventLoop) {
        let Some(shell) = &mut self.shell else { return };
        let asked = self.app.pass(shell.input());
        shell.obey(asked);
        self.end_pass(event_loop);
    }

    fn redraw(&mut self, event_loop: &ActiveEventLoop) {
        let Some(shell) = &mut self.shell else { return };
        let frame = self.app.frame(shell.input(), &mut shell.surface);
        shell.obey(frame.platform);
        shell.set_title(self.app.title());
        shell.fill_screen(self.app.fills_screen);
        self.end_pass(event_loop);
    }

    fn end_pass(&self, event_loop: &ActiveEventLoop) {
        #[cfg(target_os = "linux")]
        super::x11::keep_ready(&self.app);
        if self.app.quit {
            event_loop.exit();
        }
    }

    fn request_redraw(&mut self) {
        if let Some(shell) = &self.shell {
            shell.window.request_redraw();
        }
    }
}

impl ApplicationHandler<Wake> for Program {
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
        let (remembered, context) = (app.memory.window, app.context.clone());
        #[cfg(target_os = "linux")]
        super::x11::save_when_gone(event_loop);
        match Shell::open(event_loop, &app.options, remembered, context, &app.wake) {
            Ok(shell) => {
                #[cfg(feature = "screen-readers")]
                let shell = super::reader::show(shell, event_loop, &app.wake);
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
            Wake::Answered(number, what, answer) => {
                self.app.answered(number, what, answer);
                self.request_redraw();
            }
            Wake::Pasted(Ok(text)) => {
                if let Some(shell) = &mut self.shell {
                    let events = &mut shell.egui.egui_input_mut().events;
                    events.push(egui::Event::Paste(text));
                }
                self.app.succeeded(Attempt::Paste);
                self.request_redraw();
            }
            Wake::Pasted(Err(reason)) => {
                self.app.failed(Attempt::Paste, reason.to_owned());
                self.request_redraw();
            }
            Wake::Copied(result) => {
                self.app.was_copied(result);
                self.request_redraw();
            }
            Wake::Desktop { is_dark } => {
                let theme = if is_dark { Theme::Dark } else { Theme::Light };
                if let Some(shell) = &mut self.shell {
                    shell.egui.egui_input_mut().system_theme = Some(theme);
                    log::info!("the desktop is {theme:?}");
                }
                self.request_redraw();
            }
            #[cfg(feature = "screen-readers")]
            Wake::Reader(reader) => {
                match reader {
                    Reader::Came => self.app.context.enable_accesskit(),
                    Reader::Left => self.app.context.disable_accesskit(),
                    Reader::Uses(request) => {
                        if let Some(shell) = &mut self.shell {
                            shell.egui.on_accesskit_action_request(request);
                        }
                    }
                }
                self.request_redraw();
            }
            Wake::RepaintAt(time) if time <= Instant::now() => self.request_redraw(),
            Wake::RepaintAt(time) => match event_loop.control_flow() {
                // An earlier frame is due already.
                ControlFlow::WaitUntil(sooner) if sooner < time => {}
                _ => event_loop.set_control_flow(ControlFlow::WaitUntil(time)),
            },
        }
    }

    fn window_event(&mut self, event_loop: &ActiveEventLoop, _: WindowId, mut event: WindowEvent) {
        let Some(shell) = &mut self.shell else {
            return;
        };
        match &mut event {
            WindowEvent::ScaleFactorChanged {
                inner_size_writer, ..
            } => shell.keep_size(inner_size_writer),
            WindowEvent::CloseRequested => {
                self.app.run_after_typing(Command::Quit);
                self.pass(event_loop);
                return self.request_redraw();
            }
            WindowEvent::RedrawRequested => return self.redraw(event_loop),
            WindowEvent::Resized(PhysicalSize { width, height }) => {
                shell.surface.resize(*width, *height);
                self.app.fills_screen = shell.fills_screen();
                self.app.memory.window = shell.place(self.app.memory.window);
            }
            // The user changes the desktop's theme in another window, so the theme may be new when this one gets the
            // focus.
            WindowEvent::Focused(true) if shell.window.theme().is_none() => {
                let wake = Arc::clone(&self.app.wake);
                ask_darkness(move |is_dark| wake(Wake::Desktop { is_dark }));
            }
            WindowEvent::Moved(_) => {
                self.app.memory.window = shell.place(self.app.memory.window);
            }
            _ => {}
        }
        // A press, the moves after it and the release each get a pass of their own, however slow frames are: within one
        // pass, egui sees only the final state.
        let is_button = matches!(event, WindowEvent::MouseInput { .. });
        if is_button {
            shell.size_px = None;
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
