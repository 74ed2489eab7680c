//! The program behind the window: all that outlives frames, devices and windows, and what it says.

use super::wake::{Wake, Waker};
use crate::{
    camera::{CameraChoice, Viewport},
    geometry::Mesh,
    scene::{Loaded, Warning},
    viewer::{
        jobs::{Chart, Checking, Loading, TreeBuild},
        model::State,
        options::Options,
        screen::Textures,
        ui::{self, Drag, Filter, Floating, Notice, Notices, Statistics},
    },
};
use std::{path::PathBuf, sync::Arc};

/// Whether a load is of the files that are on screen already: then view, selection and visibility stay.
#[derive(Clone, Copy)]
pub(super) struct Reload(pub bool);

/// Screenshots that are asked for.
#[derive(Default)]
pub(in crate::viewer) struct Screenshots {
    /// Of the next frame.
    pub wanted: bool,
    /// Where they go: the folder that the program runs in, at first.
    pub folder: PathBuf,
}

/// Whether the status line tells times and the adapter. Pictures that are compared do without: they differ by machine.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(in crate::viewer) enum Telling {
    Machine,
    Nothing,
}

/// All that outlives frames, devices and windows.
pub(in crate::viewer) struct App {
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
    pub(super) loading: Option<(Loading, Vec<PathBuf>, Reload)>,
    /// What is being built for the scene on screen.
    pub trees: Option<TreeBuild>,
    /// Nothing was shown yet: the first scene takes the command line's camera.
    pub first: bool,
    pub notices: Notices,
    pub floating: Floating,
    pub filter: Filter,
    pub checking: Checking,
    /// The pixels in which a comparison found differences.
    pub marks: Option<egui::TextureHandle>,
    pub chart: Option<Chart>,
    pub screenshots: Screenshots,
    /// What was open before the gallery.
    pub outside: Vec<PathBuf>,
    pub reveal_selection: bool,
    pub drag: Option<Drag>,
    /// The scene that the log spoke of last; none for the empty one before the first.
    announced: u64,
    pub telling: Telling,
    pub statistics: Statistics,
    /// The largest side of a texture that the device has.
    pub max_texture_side: Option<usize>,
    /// What is to go on the clipboard.
    pub copied: Option<String>,
    /// The user is done.
    pub quit: bool,
}

impl App {
    /// With nothing to show yet.
    pub(super) fn new(options: Options, wake: Waker, telling: Telling) -> Self {
        let state = State::new(
            Loaded::default(),
            CameraChoice::default(),
            Viewport::DEFAULT,
            options.sides,
        );
        Self {
            paths: options.paths.clone(),
            meshes: Vec::new(),
            loading: None,
            trees: None,
            first: true,
            notices: Notices::new(),
            floating: Floating::default(),
            filter: Filter::default(),
            checking: Checking::Off,
            marks: None,
            chart: None,
            screenshots: Screenshots::default(),
            outside: Vec::new(),
            reveal_selection: false,
            drag: None,
            announced: 0,
            telling,
            statistics: Statistics::default(),
            max_texture_side: None,
            copied: None,
            quit: false,
            context: ui::context(),
            textures: Textures::default(),
            state: state.expect("nothing is framed by default"),
            wake,
            options,
        }
    }

    /// Whether something is under way that will change what is shown.
    pub fn is_busy(&self) -> bool {
        let checks = matches!(&self.checking, Checking::On(check) if check.report.is_none());
        let studies = self
            .chart
            .as_ref()
            .is_some_and(|chart| chart.rows.is_none());
        self.loading.is_some() || checks || studies || !self.state.scene().trees_are_built()
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

    /// Begins to build the trees of what is shown.
    pub fn build_trees(&mut self) {
        let wake = self.wake.clone();
        self.trees = Some(TreeBuild::start(self.state.scene(), move || {
            wake(Wake::Look);
        }));
    }

    /// The window's title.
    pub fn title(&self) -> String {
        format!("{} \u{2013} Sightline", self.state.name())
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
