//! The program behind the window: what commands do, and what loads bring. Knows no window.

use super::{
    Command, Notice, Notices, Options, Wake, Waker,
    action::Action,
    check::Checking,
    command_line,
    dialogs::{self, Answer},
    files::Reload,
    gallery::Chart,
    input::Drag,
    loading::{Loading, TreeBuild},
    panels::{Filter, Floating, Statistics},
    pass,
    screenshot::Screenshots,
    state::State,
    textures::Textures,
};
use crate::{
    camera::{CameraChoice, Viewport},
    geometry::Mesh,
    pick::PickLine,
    scene::{Loaded, Scene, Warning, description},
};
use std::{io::Write, path::PathBuf, sync::Arc, time::Instant};

/// All that outlives frames, devices and windows.
pub(super) struct App {
    pub options: Options,
    /// Wakes whoever shows this.
    pub wake: Waker,
    pub context: egui::Context,
    pub textures: Textures,
    pub state: State,
    /// What the scene was made from, for the command that makes it again.
    pub paths: Vec<PathBuf>,
    /// The files of its meshes, for the scene file that names them.
    pub meshes: Vec<(PathBuf, Arc<Mesh>)>,
    /// The load under way, of which files, and whether they are those on screen.
    pub loading: Option<(Loading, Vec<PathBuf>, Reload)>,
    /// What is being built for the scene on screen.
    pub trees: Option<TreeBuild>,
    /// Nothing was shown yet: the first scene takes the command line's camera.
    pub first: bool,
    pub notices: Notices,
    pub floating: Floating,
    pub filter: Filter,
    pub checking: Checking,
    pub chart: Option<Chart>,
    pub screenshots: Screenshots,
    /// What was open before the gallery.
    pub outside: Vec<PathBuf>,
    pub reveal_selection: bool,
    pub drag: Option<Drag>,
    /// The scene that the log spoke of last; none for the empty one before the first.
    announced: u64,
    pub statistics: Statistics,
    /// What is to go on the clipboard.
    pub copied: Option<String>,
    /// The user is done.
    pub quit: bool,
}

/// What is of use of a text on the clipboard; the rest may be objects.
#[derive(serde::Deserialize)]
struct Clipping {
    camera: Option<CameraChoice>,
}

impl App {
    /// Begins to load what the options name.
    pub fn new(options: Options, wake: Waker) -> Self {
        let state = State::new(
            Loaded::default(),
            CameraChoice::default(),
            Viewport::DEFAULT,
            options.sides,
        );
        let mut app = Self {
            paths: options.paths.clone(),
            meshes: Vec::new(),
            loading: None,
            trees: None,
            first: true,
            notices: Notices::new(),
            floating: Floating::default(),
            filter: Filter::default(),
            checking: Checking::Off,
            chart: None,
            screenshots: Screenshots::default(),
            outside: Vec::new(),
            reveal_selection: false,
            drag: None,
            announced: 0,
            statistics: Statistics::default(),
            copied: None,
            quit: false,
            context: pass::context(),
            textures: Textures::default(),
            state: state.expect("nothing is framed by default"),
            wake,
            options,
        };
        app.open(app.paths.clone());
        app
    }

    /// Whether something is under way that will change what is shown.
    pub fn is_busy(&self) -> bool {
        let checks = matches!(&self.checking, Checking::On(check) if check.found.is_none());
        let studies = self
            .chart
            .as_ref()
            .is_some_and(|chart| chart.rows.is_none());
        self.loading.is_some() || checks || studies || !self.state.scene().trees_are_built()
    }

    /// Takes what the user answered.
    pub fn answered(&mut self, answer: Answer) {
        match answer {
            Answer::Open(paths) => self.open(paths),
            Answer::Save(path) => self.save(path),
            Answer::NoDialog => self.complain(
                "this desktop shows no file dialog: drop files on the window, or name them when starting".into(),
            ),
        }
    }

    /// Takes over the camera that a text has, as a scene file writes it.
    fn paste_camera(&mut self, text: &str) -> Result<(), String> {
        let none = "the clipboard holds no camera: Shift+C copies one, and so does the [camera] of a scene file";
        let says = toml::from_str::<Clipping>(text).map_err(|_| none)?;
        let camera = Action::Camera(says.camera.ok_or(none)?);
        self.state
            .check(&camera)
            .map_err(|error| format!("the camera on the clipboard: {error}"))?;
        self.act(camera);
        Ok(())
    }

    /// Says what went wrong, to whoever looks at the window and to whoever looks at the terminal. What stands there
    /// already is not said again.
    pub fn complain(&mut self, text: String) {
        if self.notices.iter().any(|notice| notice.text == text) {
            return;
        }
        log::error!("{text}");
        self.notices.push(Notice {
            text,
            is_error: true,
        });
        self.context.request_repaint();
    }

    /// Says that something is done.
    pub fn say(&mut self, text: String) {
        log::info!("{text}");
        self.notices.push(Notice {
            text,
            is_error: false,
        });
        self.context.request_repaint();
    }

    /// Says what was left out of files or mended: the first few to whoever looks at the window.
    pub fn warn(&mut self, warnings: &[Warning]) {
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

    pub fn run_command(&mut self, command: Command) {
        match command {
            Command::Act(action) => self.act(action),
            Command::OpenDialog => {
                let wake = self.wake.clone();
                dialogs::open_dialog(move |answer| wake(Wake::Answered(answer)));
            }
            Command::SaveDialog => {
                let wake = self.wake.clone();
                dialogs::save_dialog(move |answer| wake(Wake::Answered(answer)));
            }
            Command::Open(paths) => self.open(paths),
            Command::Reload => self.reload(),
            Command::CopyCommandLine => {
                self.copied = Some(self.view_command());
                if self.state.edited() {
                    self.complain(
                        "the command gives the scene as its files have it: save it first (Ctrl+S), then copy again"
                            .into(),
                    );
                }
            }
            Command::CopyCamera => {
                let camera = self.state.camera_choice();
                self.copied = description::to_toml(&Scene::default(), &camera, &[]).ok();
            }
            Command::Paste(text) => {
                if let Err(reason) = self.paste_camera(&text) {
                    self.complain(reason);
                }
            }
            Command::Screenshot => {
                self.screenshots.wanted = true;
                self.context.request_repaint();
            }
            Command::CopyPick => {
                let line = self
                    .state
                    .selection()
                    .and_then(|selection| selection.pick.as_ref());
                self.copied = line.and_then(|line| serde_json::to_string(line).ok());
            }
            Command::Escape if self.loading.is_some() => self.loading = None,
            Command::Escape if self.floating.help => self.floating.help = false,
            Command::Escape if self.state.method().is_some() => self.act(Action::PickBy(None)),
            Command::Escape if matches!(self.checking, Checking::On(_)) => {
                self.checking = Checking::Off;
            }
            Command::Escape => self.act(Action::Select(None)),
            Command::NextExhibit { forward } => self.open_next_exhibit(forward),
            Command::LeaveGallery => self.open(self.outside.clone()),
            Command::ToggleCheck => self.toggle_check(),
            Command::ToggleHelp => self.floating.help ^= true,
            Command::TogglePipeline => self.floating.pipeline ^= true,
            Command::Quit => self.quit = true,
        }
    }

    pub fn act(&mut self, action: Action) {
        let clicks = matches!(action, Action::Click(..));
        let start = Instant::now();
        let (method, stage) = (self.state.method(), self.state.stage());
        let picked = self.state.apply(action);
        if self.state.stage() != stage {
            self.build_trees();
        }
        if self.state.method() != method {
            self.checking = match self.state.method() {
                Some(_) => Checking::Wanted,
                None => Checking::Off,
            };
        }
        if clicks {
            self.statistics.pick = Some(start.elapsed());
            self.reveal_selection = true;
        }
        if let Some(line) = picked {
            let command = command_line::pick_command(&self.state, &self.paths, line.px);
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
        let viewport = self.state.world().1.viewport;
        let middle = viewport.size_px() / 2.0;
        let at_px = pick.map_or(middle, |pick| pick.px);
        command_line::pick_command(&self.state, &self.paths, at_px)
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
