//! The event loop's side: events in, commands run, frames drawn.

use super::{
    Command, Notice, Notices, Options, ViewerError, Wake,
    action::Action,
    command,
    frame::Panels,
    input::Drag,
    loading::{self, Loading},
    panels::{self, Shown, Statistics},
    shell::Shell,
    state::State,
};
use crate::{
    camera::{CameraChoice, CameraError, Viewport},
    pick::PickLine,
    scene::{Loaded, Warning},
};
use std::{
    io::Write,
    path::PathBuf,
    time::{Duration, Instant},
};
use winit::{
    application::ApplicationHandler,
    dpi::PhysicalSize,
    event::{StartCause, WindowEvent},
    event_loop::{ActiveEventLoop, ControlFlow, EventLoopProxy},
    window::WindowId,
};

/// All that lives as long as the event loop.
pub(super) struct App {
    options: Options,
    proxy: EventLoopProxy<Wake>,
    window: Option<Shell>,
    state: State,
    /// What the scene was made from, for the command that makes it again.
    paths: Vec<PathBuf>,
    loading: Option<(Loading, Vec<PathBuf>)>,
    /// The first scene takes the command line's camera.
    first: bool,
    notices: Notices,
    help: bool,
    reveal_selection: bool,
    drag: Option<Drag>,
    /// The scene that the log spoke of last; none for the empty one before the first.
    announced: u64,
    statistics: Statistics,
    /// Why the window could not be opened, for the caller of [`super::run`].
    pub failed: Option<ViewerError>,
}

impl App {
    pub fn new(options: Options, proxy: EventLoopProxy<Wake>) -> Result<Self, ViewerError> {
        let state = State::new(
            Loaded::default(),
            CameraChoice::default(),
            Viewport::DEFAULT,
            options.sides,
        )?;
        let mut app = Self {
            paths: Vec::new(),
            loading: None,
            first: true,
            notices: Notices::new(),
            help: false,
            reveal_selection: false,
            drag: None,
            announced: 0,
            statistics: Statistics::default(),
            failed: None,
            window: None,
            state,
            proxy,
            options,
        };
        app.open(app.options.paths.clone());
        Ok(app)
    }

    fn open(&mut self, paths: Vec<PathBuf>) {
        let proxy = self.proxy.clone();
        let wake = move || drop(proxy.send_event(Wake::Look));
        self.loading = Some((Loading::start(paths.clone(), wake), paths));
    }

    /// Takes what a load brought: the scene on screen stays until its successor is whole.
    fn take_loaded(&mut self) {
        let Some((result, paths)) = self
            .loading
            .as_ref()
            .and_then(|(load, paths)| Some((load.poll()?, paths.clone())))
        else {
            return;
        };
        self.loading = None;
        let opened = result
            .map_err(|error| error.to_string())
            .and_then(|mut loaded| {
                let warnings = std::mem::take(&mut loaded.warnings);
                self.show_scene(loaded).map_err(|error| error.to_string())?;
                Ok(warnings)
            });
        match opened {
            Ok(warnings) => {
                self.paths = paths;
                self.notices.clear();
                self.warn(&warnings);
                loading::build_trees(self.state.scene());
            }
            Err(text) => self.complain(text),
        }
    }

    fn show_scene(&mut self, mut loaded: Loaded) -> Result<(), CameraError> {
        if !self.first {
            return self.state.open(loaded);
        }
        if let Err(error) = loaded.scene.hide(&self.options.hidden) {
            self.complain(format!("--hide: {error}"));
        }
        loaded.camera = self.options.camera.or(loaded.camera);
        self.state.open(loaded)?;
        self.first = false;
        Ok(())
    }

    /// Says what went wrong, to whoever looks at the window and to whoever looks at the terminal.
    fn complain(&mut self, text: String) {
        log::error!("{text}");
        self.notices.push(Notice {
            text,
            is_error: true,
        });
    }

    fn warn(&mut self, warnings: &[Warning]) {
        const SHOWN: usize = 4;
        for warning in warnings {
            log::warn!("{warning}");
        }
        self.notices
            .extend(warnings.iter().take(SHOWN).map(|warning| Notice {
                text: warning.to_string(),
                is_error: false,
            }));
        if warnings.len() > SHOWN {
            let text = format!("and {} more warnings", warnings.len() - SHOWN);
            self.notices.push(Notice {
                text,
                is_error: false,
            });
        }
    }

    fn run_command(&mut self, command: Command, event_loop: &ActiveEventLoop) {
        match command {
            Command::Act(action) => self.act(action),
            Command::OpenDialog => {
                let proxy = self.proxy.clone();
                loading::open_dialog(move |paths| drop(proxy.send_event(Wake::Open(paths))));
            }
            Command::Open(paths) => self.open(paths),
            Command::CopyCommandLine => {
                let text = self.view_command();
                self.copy(text);
            }
            Command::CopyPick => {
                let line = self
                    .state
                    .selection()
                    .and_then(|selection| selection.pick.as_ref());
                if let Some(text) = line.and_then(|line| serde_json::to_string(line).ok()) {
                    self.copy(text);
                }
            }
            Command::Escape if self.loading.is_some() => self.loading = None,
            Command::Escape if self.help => self.help = false,
            Command::Escape => self.act(Action::Select(None)),
            Command::ToggleHelp => self.help = !self.help,
            Command::Quit => event_loop.exit(),
        }
    }

    fn act(&mut self, action: Action) {
        let clicks = matches!(action, Action::Click(..));
        let start = Instant::now();
        let picked = self.state.apply(action);
        if clicks {
            self.statistics.pick = Some(start.elapsed());
            self.reveal_selection = true;
        }
        if let Some(line) = picked {
            log::info!("{}", self.view_command());
            if self.options.print_picks {
                print(&line);
            }
        }
    }

    /// The view as a command, at the pick or else in the middle.
    fn view_command(&self) -> String {
        let at_px = self
            .state
            .selection()
            .and_then(|selection| Some(selection.pick.as_ref()?.px));
        let viewport = self.state.view().viewport;
        let middle =
            glam::DVec2::new(f64::from(viewport.width()), f64::from(viewport.height())) / 2.0;
        command::pick_command(&self.state, &self.paths, at_px.unwrap_or(middle))
    }

    fn copy(&mut self, text: String) {
        if let Some(shell) = &mut self.window {
            shell.egui.set_clipboard_text(text);
        }
    }

    fn redraw(&mut self, event_loop: &ActiveEventLoop) {
        self.take_loaded();
        let Some(mut shell) = self.window.take() else {
            return;
        };
        let start = Instant::now();
        let input = shell.egui.take_egui_input(&shell.window);
        let dropped = input
            .dropped_files
            .iter()
            .map(|file| file.path().to_path_buf())
            .collect::<Vec<_>>();
        let context = shell.egui.egui_ctx().clone();
        let mut commands = Vec::new();
        let mut place = None;
        let output = context.run_ui(input, |ui| {
            let mut shown = Shown {
                state: &self.state,
                notices: &mut self.notices,
                loading: self.loading.as_ref().map(|(load, _)| load.fraction()),
                help: self.help,
                statistics: &self.statistics,
                reveal_selection: self.reveal_selection,
            };
            let (scene, asked) = panels::show(ui, &mut shown, &mut self.drag);
            place = scene;
            commands.extend(asked);
        });
        self.reveal_selection = false;
        shell
            .egui
            .handle_platform_output(&shell.window, output.platform_output);
        if !dropped.is_empty() {
            commands.push(Command::Open(dropped));
        }
        // What was shown is what was acted on; if that changed the state, the next frame shows it.
        let panels_change = commands
            .iter()
            .any(|command| !matches!(command, Command::Act(Action::Hover(_) | Action::Resize(_))));
        let hover = self.state.hover();
        self.window = Some(shell);
        for command in commands {
            self.run_command(command, event_loop);
        }
        let Some(shell) = &mut self.window else {
            return;
        };
        shell
            .window
            .set_title(&format!("{} \u{2013} Sightline", self.state.name()));
        let panels = Panels {
            primitives: context.tessellate(output.shapes, output.pixels_per_point),
            textures: output.textures_delta,
            pixels_per_point: output.pixels_per_point,
        };
        let drawn = shell.frame.draw(&self.state, place, panels);
        match drawn {
            Ok(true) => {
                self.statistics.frame = start.elapsed();
                self.announce();
            }
            Ok(false) => {}
            Err(error) => {
                self.notices.push(Notice {
                    text: error.to_string(),
                    is_error: true,
                });
                context.request_repaint();
            }
        }
        if panels_change || hover != self.state.hover() {
            context.request_repaint();
        } else if self.loading.is_some() {
            context.request_repaint_after(Duration::from_millis(50));
        }
    }

    /// Says once that a scene is on the screen.
    fn announce(&mut self) {
        let scene = self.state.scene();
        if self.announced != self.state.scene_revision() {
            self.announced = self.state.scene_revision();
            log::info!(
                "scene shown: {} objects, {} triangles",
                scene.objects().len(),
                scene.triangle_count()
            );
        }
    }

    fn request_redraw(&self) {
        if let Some(shell) = &self.window {
            shell.window.request_redraw();
        }
    }
}

impl ApplicationHandler<Wake> for App {
    fn new_events(&mut self, event_loop: &ActiveEventLoop, cause: StartCause) {
        if let StartCause::ResumeTimeReached { .. } = cause {
            event_loop.set_control_flow(ControlFlow::Wait);
            self.request_redraw();
        }
    }

    fn resumed(&mut self, event_loop: &ActiveEventLoop) {
        if self.window.is_some() {
            return;
        }
        match Shell::open(event_loop, &self.options, &self.proxy) {
            Ok(shell) => {
                self.statistics.adapter = shell.frame.adapter_name();
                self.statistics.software = shell.frame.is_software();
                self.window = Some(shell);
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
            Wake::Open(paths) => {
                self.open(paths);
                self.request_redraw();
            }
            Wake::RepaintAt(time) if time <= Instant::now() => self.request_redraw(),
            Wake::RepaintAt(time) => event_loop.set_control_flow(ControlFlow::WaitUntil(time)),
        }
    }

    fn window_event(&mut self, event_loop: &ActiveEventLoop, _: WindowId, event: WindowEvent) {
        let Some(shell) = &mut self.window else {
            return;
        };
        match &event {
            WindowEvent::CloseRequested => return event_loop.exit(),
            WindowEvent::RedrawRequested => return self.redraw(event_loop),
            WindowEvent::Resized(PhysicalSize { width, height }) => {
                shell.frame.resize(*width, *height);
            }
            _ => {}
        }
        if shell.egui.on_window_event(&shell.window, &event).repaint {
            self.request_redraw();
        }
    }
}

/// A pick as a line on stdout. Who reads it may be gone: that is no reason to stop showing.
fn print(line: &PickLine) {
    if let Ok(json) = serde_json::to_string(line) {
        let mut out = std::io::stdout().lock();
        let _ = writeln!(out, "{json}").and_then(|()| out.flush());
    }
}
