//! The program behind the window: what commands do, and what loads bring.

use super::{
    Command, Notice, Notices, Options, ViewerError, Wake,
    action::Action,
    check::{Check, Checking, OnScreen},
    command,
    input::Drag,
    loading::{self, Loading, TreeBuild},
    panels::{Filter, Floating, Statistics},
    shell::Shell,
    stages::Stage,
    state::State,
};
use crate::{
    camera::{CameraChoice, CameraError, Viewport},
    geometry::Mesh,
    pick::PickLine,
    scene::{Loaded, Warning, description},
};
use glam::DVec2;
use std::{io::Write, path::PathBuf, sync::Arc, time::Instant};
use winit::event_loop::{ActiveEventLoop, EventLoopProxy};

/// All that lives as long as the event loop.
pub(super) struct App {
    pub options: Options,
    pub proxy: EventLoopProxy<Wake>,
    /// The window, once the event loop runs.
    pub shell: Option<Shell>,
    pub state: State,
    /// What the scene was made from, for the command that makes it again.
    paths: Vec<PathBuf>,
    /// The files of its meshes, for the scene file that names them.
    meshes: Vec<(PathBuf, Arc<Mesh>)>,
    /// The load under way, of which files, and whether they are those on screen.
    pub loading: Option<(Loading, Vec<PathBuf>, Reload)>,
    /// What is being built for the scene on screen.
    trees: Option<TreeBuild>,
    /// The first scene takes the command line's camera.
    first: bool,
    pub notices: Notices,
    pub floating: Floating,
    pub filter: Filter,
    pub checking: Checking,
    pub reveal_selection: bool,
    pub drag: Option<Drag>,
    /// The scene that the log spoke of last; none for the empty one before the first.
    announced: u64,
    pub statistics: Statistics,
    /// Why the window could not be opened, for the caller of [`super::run`].
    pub failed: Option<ViewerError>,
}

/// Whether a load is of the files that are on screen already: then view, selection and visibility stay.
#[derive(Clone, Copy)]
pub(super) struct Reload(bool);

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
            meshes: Vec::new(),
            loading: None,
            trees: None,
            first: true,
            notices: Notices::new(),
            floating: Floating::default(),
            filter: Filter::default(),
            checking: Checking::Off,
            reveal_selection: false,
            drag: None,
            announced: 0,
            statistics: Statistics::default(),
            failed: None,
            shell: None,
            state,
            proxy,
            options,
        };
        app.open(app.options.paths.clone());
        Ok(app)
    }

    /// Loads files in place of what is shown, once they are whole.
    pub fn open(&mut self, paths: Vec<PathBuf>) {
        self.load(paths, Reload(false));
    }

    fn load(&mut self, paths: Vec<PathBuf>, reload: Reload) {
        let proxy = self.proxy.clone();
        let wake = move || drop(proxy.send_event(Wake::Look));
        self.loading = Some((Loading::start(paths.clone(), wake), paths, reload));
    }

    /// Takes what a load brought: the scene on screen stays until its successor is whole.
    pub fn take_loaded(&mut self) {
        let Some(result) = self.loading.as_ref().and_then(|(load, ..)| load.poll()) else {
            return;
        };
        let Some((_, paths, reload)) = self.loading.take() else {
            return;
        };
        let shown = result
            .map_err(|error| error.to_string())
            .and_then(|loaded| {
                let warnings = loaded.warnings.clone();
                self.show_scene(loaded, reload)
                    .map_err(|error| error.to_string())?;
                Ok(warnings)
            });
        match shown {
            Ok(warnings) => {
                self.paths = paths;
                self.notices.clear();
                self.warn(&warnings);
                self.trees = Some(TreeBuild::start(self.state.scene()));
            }
            Err(text) => self.complain(text),
        }
    }

    fn show_scene(&mut self, mut loaded: Loaded, reload: Reload) -> Result<(), CameraError> {
        let meshes = std::mem::take(&mut loaded.meshes);
        if reload.0 {
            self.state.reload(loaded);
        } else if self.first {
            if let Err(error) = loaded.scene.hide(&self.options.hidden) {
                self.complain(format!("--hide: {error}"));
            }
            loaded.camera = self.options.camera.or(loaded.camera);
            self.state.open(loaded)?;
            self.first = false;
        } else {
            self.state.open(loaded)?;
        }
        self.meshes = meshes;
        Ok(())
    }

    /// Writes what is shown as a scene file, which from then on is what is shown.
    pub fn save(&mut self, path: PathBuf) {
        self.act(Action::Stage(Stage::World));
        let text = description::to_toml(
            self.state.scene(),
            &self.state.camera_choice(),
            &self.meshes,
        );
        let written = text.map_err(|error| error.to_string()).and_then(|text| {
            let failed = |error| format!("cannot write {}: {error}", path.display());
            std::fs::write(&path, text).map_err(failed)
        });
        match written {
            Ok(()) => {
                log::info!("saved {}", path.display());
                self.paths = vec![path];
            }
            Err(text) => self.complain(text),
        }
    }

    /// Says what went wrong, to whoever looks at the window and to whoever looks at the terminal.
    pub fn complain(&mut self, text: String) {
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

    pub fn run_command(&mut self, command: Command, event_loop: &ActiveEventLoop) {
        match command {
            Command::Act(action) => self.act(action),
            Command::OpenDialog => {
                let proxy = self.proxy.clone();
                loading::open_dialog(move |answer| drop(proxy.send_event(Wake::Answered(answer))));
            }
            Command::SaveDialog => {
                let proxy = self.proxy.clone();
                loading::save_dialog(move |answer| drop(proxy.send_event(Wake::Answered(answer))));
            }
            Command::Open(paths) => self.open(paths),
            Command::Reload if self.loading.is_none() => {
                self.load(self.paths.clone(), Reload(true));
            }
            Command::Reload => {}
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
            Command::Escape if self.floating.help => self.floating.help = false,
            Command::Escape if matches!(self.checking, Checking::On(_)) => {
                self.checking = Checking::Off;
            }
            Command::Escape => self.act(Action::Select(None)),
            Command::ToggleCheck => self.toggle_check(),
            Command::ToggleHelp => self.floating.help ^= true,
            Command::TogglePipeline => self.floating.pipeline ^= true,
            Command::Quit => event_loop.exit(),
        }
    }

    /// Asks for a comparison of what will be on screen, or puts away the one that is.
    fn toggle_check(&mut self) {
        self.checking = match &self.checking {
            Checking::Wanted => Checking::Off,
            // One that a key before this one has outdated is as good as gone.
            Checking::On(check) if check.is_about(&self.state) => Checking::Off,
            Checking::Off | Checking::On(_) => Checking::Wanted,
        };
    }

    /// Begins the comparison that is asked for.
    pub fn start_check(&mut self) {
        let (Checking::Wanted, Some(shell)) = (&self.checking, &self.shell) else {
            return;
        };
        match shell.frame.read_ids(&OnScreen::of(&self.state)) {
            Ok(Some(drawn)) => {
                let proxy = self.proxy.clone();
                let wake = move || drop(proxy.send_event(Wake::Look));
                let check = Check::start(&self.state, drawn, wake);
                self.checking = Checking::On(Box::new(check));
                shell.egui.egui_ctx().request_repaint();
            }
            Ok(None) => {}
            Err(error) => {
                self.checking = Checking::Off;
                self.complain(error.to_string());
            }
        }
    }

    /// Takes what a comparison found, and puts away one of what is no longer shown.
    pub fn take_checked(&mut self) {
        let (Checking::On(check), Some(shell)) = (&mut self.checking, &self.shell) else {
            return;
        };
        if !check.is_about(&self.state) {
            self.checking = Checking::Off;
        } else if check.poll(shell.egui.egui_ctx())
            && let Some(found) = &check.found
        {
            let command = command::verify_command(&self.state, &self.paths);
            let differ = found.report.disagreements.len();
            log::info!("{differ} pixels differ: {command}");
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
            let command = command::pick_command(&self.state, &self.paths, line.px);
            log::info!("{command}");
            if self.options.print_picks {
                print(&line);
            }
        }
    }

    /// The view as a command, at the pick or else in the middle.
    fn view_command(&self) -> String {
        let selection = self.state.selection();
        let pick = selection.and_then(|selection| selection.pick.as_ref());
        let viewport = self.state.view().viewport;
        let middle = DVec2::new(f64::from(viewport.width()), f64::from(viewport.height())) / 2.0;
        let at_px = pick.map_or(middle, |pick| pick.px);
        command::pick_command(&self.state, &self.paths, at_px)
    }

    fn copy(&mut self, text: String) {
        if let Some(shell) = &mut self.shell {
            shell.egui.set_clipboard_text(text);
        }
    }

    /// Says once that a scene is on the screen.
    pub fn announce(&mut self) {
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
}

/// A pick as a line on stdout. Who reads it may be gone: that is no reason to stop showing.
fn print(line: &PickLine) {
    if let Ok(json) = serde_json::to_string(line) {
        let mut out = std::io::stdout().lock();
        let _ = writeln!(out, "{json}").and_then(|()| out.flush());
    }
}
