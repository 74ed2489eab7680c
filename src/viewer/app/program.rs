//! The program behind the window: all that outlives frames, devices and windows, with its messages and its title.

use super::{
    memory::Memory,
    modal::Modal,
    numbers::Numbers,
    rest::Rest,
    wake::{Wake, Waker},
};
use crate::{
    camera::{CameraChoice, Viewport},
    plain::plain,
    scene::{Loaded, Warning},
    viewer::{
        jobs::{self, Chart, Checking, Job, Typefaces, Watching},
        model::{Stage, State},
        options::Options,
        screen::{SceneRect, Textures},
        ui::{
            self, Attempt, Command, Drag, Filter, Kind, Notice, Notices, Shot, ShotTo, Start,
            Statistics, Sums, Tour,
        },
    },
};
use std::{path::PathBuf, time::Duration};

/// How long a confirmation is shown, in seconds.
pub(super) const SAID_S: f64 = 4.0;

/// Screenshots.
#[derive(Default)]
pub(in crate::viewer) struct Screenshots {
    /// Whether the card for them is open.
    pub is_open: bool,
    /// What the card asks for.
    pub shot: Shot,
    /// What the next frame is taken for.
    pub wanted: Option<(Shot, ShotTo)>,
    /// The folder that they are written to; at first, the one that the program runs in.
    pub folder: PathBuf,
}

/// Watches of files, for changes by others.
#[derive(Default)]
pub(in crate::viewer) struct Watches {
    /// Of the files of the scene on show.
    pub now: Option<Watching>,
    /// Of the files of the scene that was left for the gallery.
    pub outside: Option<Watching>,
    /// The scene's revision at which `now` was brought up to date last.
    pub revision: u64,
    /// Files that are gone, as messages say.
    pub gone: Vec<PathBuf>,
}

/// Who shows the program.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(in crate::viewer) enum Host {
    /// A window. It opens the system's dialogs, and its status line shows times and the adapter.
    Window,
    /// A picture. It opens no dialogs, and its status line shows no times and no adapter, which differ between
    /// machines.
    Picture,
}

/// All that outlives frames, devices and windows.
#[expect(clippy::struct_excessive_bools, reason = "each is about another thing")]
pub(in crate::viewer) struct App {
    pub options: Options,
    /// Wakes whoever shows this.
    pub wake: Waker,
    pub context: egui::Context,
    pub textures: Textures,
    pub state: State,
    /// The one thing that waits.
    pub(super) modal: Modal,
    /// How many file dialogs were opened so far.
    pub(super) dialogs: u64,
    /// Commands that wait for the next pass: first the number that is being typed is entered.
    pub(super) late: Vec<Command>,
    /// The file that could not be opened last, until another is on show.
    pub(super) not_opened: Option<PathBuf>,
    /// The build of trees for the scene on screen. Dropping it stops it.
    pub trees: Option<Job<()>>,
    /// Whether nothing was shown yet: the first scene takes the command line's camera.
    pub first: bool,
    pub notices: Notices,
    /// The warnings about the files on screen, as they were last read.
    pub(super) told: Vec<String>,
    /// Whether the help shows.
    pub helps: bool,
    /// Where in the tour the user is.
    pub tour: Option<Tour>,
    /// What begins once the demo is on show and laid out, and the number of the pass in which it was asked for.
    pub(super) beginning: Option<(Start, u64)>,
    /// Whether the matrices showed before the four views did.
    pub(super) matrices_showed: bool,
    /// What is remembered from one run to the next.
    pub memory: Memory,
    /// The last write of the memory to its file.
    pub(super) keeping: Option<Job<()>>,
    pub(super) watches: Watches,
    /// The search for system typefaces with characters that egui's own lack.
    pub(super) typefaces: Typefaces,
    /// Questions to the files of meshes, and their answers.
    pub(super) numbers: Numbers,
    pub sums: Sums,
    pub filter: Filter,
    pub checking: Checking,
    /// The pixels in which a comparison found differences.
    pub marks: Option<egui::TextureHandle>,
    pub chart: Option<Chart>,
    pub screenshots: Screenshots,
    pub reveal_selection: bool,
    pub drag: Option<Drag>,
    /// The scene's revision that the log announced last; 0 before the first scene.
    announced: u64,
    pub host: Host,
    pub statistics: Statistics,
    /// What to say once the host has copied.
    pub(super) copying: Option<&'static str>,
    /// Whether the window covers all of the screen.
    pub fills_screen: bool,
    /// Where the panels leave room for the scene; `None` where there is none.
    pub(super) place: Option<SceneRect>,
    /// Where each of the stages goes within that place.
    pub(super) panes: Vec<(Stage, SceneRect)>,
    /// Whether the scene's picture moves or rests.
    pub rest: Rest,
    /// The user has quit.
    pub quit: bool,
}

impl App {
    /// A program with an empty scene. Its panels are to be run in `context`.
    pub(super) fn new(options: Options, wake: Waker, host: Host, context: egui::Context) -> Self {
        let state = State::new(
            Loaded::default(),
            CameraChoice::default(),
            Viewport::DEFAULT,
            options.sides,
        );
        let memory = Memory::read(options.memory.as_deref());
        let typefaces = Typefaces::default();
        ui::note_missing(&context, typefaces.missing.clone());
        let app = Self {
            modal: Modal::None,
            dialogs: 0,
            late: Vec::new(),
            not_opened: None,
            trees: None,
            first: true,
            notices: Notices::new(),
            told: Vec::new(),
            helps: false,
            tour: options.tour.then(Tour::default),
            beginning: None,
            matrices_showed: false,
            memory,
            keeping: None,
            watches: Watches::default(),
            typefaces,
            numbers: Numbers::default(),
            sums: Sums::default(),
            filter: Filter::default(),
            checking: Checking::Off,
            marks: None,
            chart: None,
            screenshots: Screenshots::default(),
            reveal_selection: false,
            drag: None,
            announced: 0,
            host,
            statistics: Statistics::default(),
            copying: None,
            fills_screen: false,
            place: None,
            panes: Vec::new(),
            rest: Rest::default(),
            quit: false,
            context,
            textures: Textures::default(),
            state: state.expect("nothing is framed by default"),
            wake,
            options,
        };
        app.dress();
        app
    }

    /// Gives the panels the window's looks.
    pub fn dress(&self) {
        ui::dress(&self.context);
        ui::set_click(&self.context);
        self.memory.look.apply(&self.context);
    }

    /// Whether something is under way that will change what is shown.
    pub fn is_busy(&self) -> bool {
        let checks = matches!(&self.checking, Checking::On(check) if check.found.is_none());
        let studies = matches!(&self.chart, Some(chart) if chart.rows.is_none());
        let files = matches!(self.modal, Modal::Loading(_) | Modal::Saving(..));
        files
            || checks
            || studies
            || self.typefaces.is_busy()
            || self.numbers.is_busy()
            || !self.state.scene().trees_are_built()
    }

    /// Reports an error, in the window and in the log. A message that is on screen already is not repeated.
    pub fn complain(&mut self, text: String) {
        self.post_error(None, text);
    }

    /// Reports why an attempt has failed. The message goes when the next one succeeds.
    pub fn failed(&mut self, attempt: Attempt, text: String) {
        self.post_error(Some(attempt), text);
    }

    /// An attempt has succeeded: removes messages about those before it that failed.
    pub fn succeeded(&mut self, attempt: Attempt) {
        let about = Kind::Error(Some(attempt));
        self.notices.retain(|notice| notice.kind != about);
    }

    /// Removes the latest warning or error. Returns whether there was one.
    pub(super) fn dismiss_latest(&mut self) -> bool {
        let latest = self.notices.iter().rposition(Notice::stays);
        latest.map(|at| self.notices.remove(at)).is_some()
    }

    fn post_error(&mut self, of: Option<Attempt>, text: String) {
        if self.notices.iter().any(|notice| notice.text == text) {
            return;
        }
        // What a picture cannot show is an error of the command that asked for it.
        if self.host == Host::Window {
            log::error!("{text}");
        }
        self.post(text, Kind::Error(of));
    }

    /// Confirms that something is done. The message goes away by itself.
    pub fn say(&mut self, text: String) {
        log::info!("{text}");
        let until_s = self.context.input(|input| input.time) + SAID_S;
        self.post(text, Kind::Done { until_s });
    }

    /// Shows a warning, which stays until it is closed.
    pub fn remind(&mut self, text: String) {
        log::warn!("{text}");
        self.post(text, Kind::Warning);
    }

    /// Shows a message, in place of one with the same text.
    fn post(&mut self, text: String, kind: Kind) {
        self.notices.retain(|notice| notice.text != text);
        self.notices.push(Notice::new(text, kind));
        self.context.request_repaint();
    }

    /// Reports what was left out of files or mended: all of it in the log, the first few warnings in the window.
    pub fn warn(&mut self, warnings: &[Warning]) {
        const SHOWN: usize = 4;
        for warning in warnings {
            log::warn!("{warning}");
        }
        let shown = warnings.iter().take(SHOWN).map(Warning::to_string);
        let more = warnings.len().saturating_sub(SHOWN);
        let more = (more > 0).then(|| format!("and {more} more warnings"));
        let notice = |text| Notice::new(text, Kind::Warning);
        self.notices.extend(shown.chain(more).map(notice));
    }

    /// Removes confirmations that have been shown long enough, and asks for a frame when the next one has.
    pub(super) fn forget_said(&mut self, now_s: f64) {
        self.notices.retain(|notice| match notice.kind {
            Kind::Done { until_s } => now_s < until_s,
            Kind::Warning | Kind::Error(_) => true,
        });
        for notice in &self.notices {
            if let Kind::Done { until_s } = notice.kind {
                let left = Duration::from_secs_f64(until_s - now_s);
                self.context.request_repaint_after(left);
            }
        }
    }

    /// Wakes the host once a job has a result.
    pub(super) fn waker(&self) -> impl Fn() + Send + use<> {
        let wake = self.wake.clone();
        move || wake(Wake::Look)
    }

    /// Begins to build the trees of what is shown.
    pub fn build_trees(&mut self) {
        self.trees = Some(jobs::build_trees(self.state.scene(), self.waker()));
    }

    /// The window's title. A dot before it marks unsaved edits.
    pub fn title(&self) -> String {
        let unsaved = self.state.unsaved();
        let mark = if unsaved { "\u{2022} " } else { "" };
        format!("{mark}{} \u{2013} Sightline", plain(self.state.name()))
    }

    /// Logs, once for each scene, that it is on screen.
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
