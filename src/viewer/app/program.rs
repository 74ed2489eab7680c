//! The program behind the window: all that outlives frames, devices and windows, and what it says.

use super::{
    memory::Memory,
    numbers::Numbers,
    rest::Rest,
    wake::{Wake, Waker},
};
use crate::{
    camera::{CameraChoice, View, Viewport},
    render::{Gpu, MeshStore},
    scene::{Loaded, Warning},
    viewer::{
        jobs::{
            Chart, Checking, Keeping, Loading, Projecting, Saving, TreeBuild, Typefaces, Upload,
            Uploaded, Watching,
        },
        model::{Action, Snapshot, Stage, State},
        options::Options,
        screen::{Progress, Textures},
        ui::{
            self, Docks, Drag, Filter, Floating, Intent, Kind, Letters, Notice, Notices,
            Statistics, Tour,
        },
    },
};
use std::{
    path::PathBuf,
    time::{Duration, Instant},
};

/// How long what is done is said, in seconds.
const SAID_S: f64 = 4.0;

/// What a load is for.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Purpose {
    /// In place of what is shown.
    Open,
    /// The files of what is shown, again: view, selection and visibility stay.
    Reload,
    /// The same, since they have changed.
    Follow,
    /// Beside what is shown.
    Add,
}

/// What is shown once it is in graphics memory.
pub(super) struct Arrival(pub Box<Loaded>, pub Vec<PathBuf>, pub Purpose);

/// How much of the screen the window has.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(in crate::viewer) enum Extent {
    /// What the desktop gives it.
    Window,
    /// All of it.
    Screen,
}

/// What a screenshot shows.
#[derive(Clone, Copy)]
pub(in crate::viewer) struct Shot {
    /// The picture without the panels.
    pub alone: bool,
}

/// Screenshots that are asked for.
#[derive(Default)]
pub(in crate::viewer) struct Screenshots {
    /// Of the next frame.
    pub wanted: Option<Shot>,
    /// Where they go: the folder that the program runs in, at first.
    pub folder: PathBuf,
}

/// Who shows the program.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(in crate::viewer) enum Host {
    /// A window: the system's dialogs are asked, and the status line tells times and the adapter.
    Window,
    /// Pictures that are compared: nobody is asked, and what differs by machine is not told.
    Picture,
}

/// All that outlives frames, devices and windows.
pub(in crate::viewer) struct App {
    pub options: Options,
    /// Wakes whoever shows this.
    pub wake: Waker,
    pub context: egui::Context,
    pub textures: Textures,
    pub state: State,
    /// The device that pictures are drawn with, once one was, and the meshes that it has.
    pub(super) gpu: Option<(Gpu, MeshStore)>,
    /// The scene that is being projected for NDC.
    pub(super) projecting: Option<Projecting>,
    /// What is on its way into graphics memory, to be shown then.
    pub(super) arriving: Option<(Upload, Arrival)>,
    /// What is there, for the next picture, and of which stage that is: of none, what the camera sees.
    pub(super) uploaded: Vec<(Option<Stage>, Uploaded)>,
    /// The load under way, of which files, and what for.
    pub(super) loading: Option<(Loading, Vec<PathBuf>, Purpose)>,
    /// The scene as it was when somebody asked where to save it, and what is to be done once it is saved.
    pub(super) to_save: Option<(Snapshot, Option<Intent>)>,
    /// What is being written, and what is to be done then.
    pub(super) saving: Vec<(Saving, Option<Intent>)>,
    /// What would drop edits, and waits for an answer.
    pub(super) question: Option<Intent>,
    /// What is being built for the scene on screen.
    pub trees: Option<TreeBuild>,
    /// Nothing was shown yet: the first scene takes the command line's camera.
    pub first: bool,
    pub notices: Notices,
    pub floating: Floating,
    /// Where in the tour the user is.
    pub tour: Option<Tour>,
    pub docks: Docks,
    /// What is remembered from one run to the next.
    pub memory: Memory,
    /// What writes it down.
    pub(super) keeping: Keeping,
    /// The files of what is shown, as somebody else may change them.
    pub(super) watching: Option<Watching>,
    /// The system's, for names that the panels' own do not have.
    pub(super) typefaces: Typefaces,
    /// What panels that are not open yet are written in.
    pub letters: Letters,
    /// Questions to the files of meshes.
    pub(super) numbers: Numbers,
    pub filter: Filter,
    pub checking: Checking,
    /// The pixels in which a comparison found differences.
    pub marks: Option<egui::TextureHandle>,
    pub chart: Option<Chart>,
    pub screenshots: Screenshots,
    pub reveal_selection: bool,
    pub drag: Option<Drag>,
    /// The scene that the log spoke of last; none for the empty one before the first.
    announced: u64,
    pub host: Host,
    pub statistics: Statistics,
    /// What is to go on the clipboard.
    pub copied: Option<String>,
    /// A click, and through which view, that waits for trees.
    pub(super) waiting: Option<(Action, View)>,
    pub extent: Extent,
    /// How far the scene's picture has come.
    pub picture: Progress,
    /// Since when it rests.
    pub rest: Rest,
    /// The user is done.
    pub quit: bool,
}

impl App {
    /// With nothing to show yet.
    pub(super) fn new(options: Options, wake: Waker, host: Host) -> Self {
        let state = State::new(
            Loaded::default(),
            CameraChoice::default(),
            Viewport::DEFAULT,
            options.sides,
        );
        let memory = Memory::read(options.memory.as_deref());
        let (context, typefaces) = (ui::context(), Typefaces::default());
        memory.look.apply(&context);
        ui::note_missing(&context, typefaces.missing.clone());
        Self {
            gpu: None,
            projecting: None,
            arriving: None,
            uploaded: Vec::new(),
            loading: None,
            to_save: None,
            saving: Vec::new(),
            question: None,
            trees: None,
            first: true,
            notices: Notices::new(),
            floating: Floating::default(),
            tour: options.tour.then(Tour::default),
            docks: memory.panels,
            memory,
            keeping: Keeping::default(),
            watching: None,
            typefaces,
            letters: Letters::default(),
            numbers: Numbers::default(),
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
            copied: None,
            waiting: None,
            extent: Extent::Window,
            picture: Progress::default(),
            rest: Rest::default(),
            quit: false,
            context,
            textures: Textures::default(),
            state: state.expect("nothing is framed by default"),
            wake,
            options,
        }
    }

    /// Whether something is under way that will change what is shown.
    pub fn is_busy(&self) -> bool {
        let checks = matches!(&self.checking, Checking::On(check) if check.found.is_none());
        let studies = self
            .chart
            .as_ref()
            .is_some_and(|chart| chart.rows.is_none());
        let files = self.underway().is_some() || !self.saving.is_empty();
        files
            || checks
            || studies
            || self.typefaces.is_busy()
            || self.projecting.is_some()
            || self.numbers.is_busy()
            || !self.state.scene().trees_are_built()
    }

    /// Says what went wrong, to whoever looks at the window and to whoever looks at the terminal. What stands there
    /// already is not said again.
    pub fn complain(&mut self, text: String) {
        if self.notices.iter().any(|notice| notice.text == text) {
            return;
        }
        log::error!("{text}");
        self.notices.push(Notice::new(text, Kind::Error));
        self.context.request_repaint();
    }

    /// Says that something is done. It goes away by itself.
    pub fn say(&mut self, text: String) {
        log::info!("{text}");
        let until_s = self.context.input(|input| input.time) + SAID_S;
        self.notices.retain(|notice| notice.text != text);
        self.notices.push(Notice::new(text, Kind::Done { until_s }));
        self.context.request_repaint();
        (self.wake)(Wake::RepaintAt(
            Instant::now() + Duration::from_secs_f64(SAID_S),
        ));
    }

    /// Says something that is to be read.
    pub fn remind(&mut self, text: String) {
        log::warn!("{text}");
        self.notices.retain(|notice| notice.text != text);
        self.notices.push(Notice::new(text, Kind::Warning));
        self.context.request_repaint();
    }

    /// Says what was left out of files or mended: the first few to whoever looks at the window.
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

    /// Takes away what was said long enough.
    pub(super) fn forget_said(&mut self, now_s: f64) {
        self.notices.retain(|notice| match notice.kind {
            Kind::Done { until_s } => now_s < until_s,
            Kind::Warning | Kind::Error => true,
        });
    }

    /// Begins to build the trees of what is shown.
    pub fn build_trees(&mut self) {
        let wake = self.wake.clone();
        self.trees = Some(TreeBuild::start(self.state.scene(), move || {
            wake(Wake::Look);
        }));
    }

    /// The window's title, with a mark before it while there are edits that no file has.
    pub fn title(&self) -> String {
        let mark = if self.state.unsaved() {
            "\u{2022} "
        } else {
            ""
        };
        format!("{mark}{} \u{2013} Sightline", self.state.name())
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

#[cfg(test)]
mod tests {
    use super::{App, Host};
    use crate::viewer::{jobs::Answer, options::Options};
    use std::sync::Arc;

    #[test]
    fn where_no_dialog_can_be_shown_the_advice_is_about_what_was_asked() {
        let mut app = App::start(Options::default(), Arc::new(drop), Host::Picture);
        app.answered(Answer::NoneToOpen);
        app.answered(Answer::NoneToSave);
        let told: Vec<_> = app
            .notices
            .iter()
            .map(|notice| notice.text.as_str())
            .collect();
        assert_eq!(told.len(), 2, "{told:?}");
        assert!(told[0].contains("drop files"), "{told:?}");
        assert!(
            told[1].starts_with("nothing is saved") && !told[1].contains("drop files"),
            "{told:?}"
        );
    }
}
