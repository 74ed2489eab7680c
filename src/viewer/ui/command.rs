//! What the user asks for through keys, buttons or menus.

use crate::{
    camera::Viewport,
    look::Backdrop,
    scene::gallery::Exhibit,
    viewer::model::{Action, State},
};
use std::{
    collections::BTreeSet,
    path::{Path, PathBuf},
};

/// Something the user asks for: a change of what is shown, or else something that the program does.
#[expect(
    clippy::large_enum_variant,
    reason = "few at a time, and a camera is most of one"
)]
#[derive(Clone, Debug, PartialEq)]
pub(in crate::viewer) enum Command {
    /// A change of what is shown.
    Act(Action),
    /// Ask for files.
    OpenDialog,
    /// Ask for a file and write the scene to it.
    SaveDialog,
    /// Load these in place of what is shown.
    Open(Vec<PathBuf>),
    /// Load these beside what is shown.
    Add(Vec<PathBuf>),
    /// Load the files on screen again.
    Reload,
    /// Open the file after the one on show in its folder, or before it.
    NextFile {
        /// After it.
        forward: bool,
    },
    /// Put the pick, or the view where nothing is picked, on the clipboard as a command line.
    CopyCommandLine,
    /// Put the camera on the clipboard, as a scene file writes it.
    CopyCamera,
    /// Take over the camera in this text from the clipboard.
    Paste(String),
    /// Show or hide the card that screenshots are taken from.
    ToggleScreenshot,
    /// Take a screenshot.
    Shoot(Shot, ShotTo),
    /// Put this text on the clipboard.
    Copy(String),
    /// Select the object of the next row in the list, or of the one before.
    SelectRow {
        /// The next.
        down: bool,
    },
    /// Select all of these objects.
    SelectObjects(BTreeSet<usize>),
    /// Enter or leave full screen.
    ToggleFullScreen,
    /// Put the pick as JSON on the clipboard.
    CopyPick,
    /// Compare the picture with its picks, or close the comparison.
    ToggleCheck,
    /// Open the gallery's scene after the present one, or before it.
    NextExhibit {
        /// After it.
        forward: bool,
    },
    /// Open again what was open before the gallery.
    LeaveGallery,
    /// An answer to the question about unsaved edits and measures.
    Reply(Reply),
    /// The first of these that applies: keep the edits that are asked about, stop measuring, stop loading, close the
    /// help, close the latest warning or error, pick by Sightline's own method again, close the comparison, select
    /// nothing, close the four views, leave the gallery.
    Escape,
    /// Show or hide the help.
    ToggleHelp,
    /// Show or hide where the selected object stands, and the arrows that move it.
    ToggleMoving,
    /// Show or hide the matrices.
    TogglePipeline,
    /// Show the four views with the matrices beside them, or the camera's picture again.
    ToggleFour,
    /// The panel shows the depth buffer's steps at the pick. Sent in each pass while it does, for the tour.
    ShowsDepthSteps,
    /// Begin the tour, go on in it, or end it.
    Tour(TourMove),
    /// Show one pick of the demo in the four views, worked out.
    ShowOnePick,
    /// Give the panels the next look.
    NextLook,
    /// Close the window.
    Quit,
}

impl From<Action> for Command {
    fn from(action: Action) -> Self {
        Self::Act(action)
    }
}

impl Command {
    /// Whether it opens, adds, reloads, saves or closes. A number that is still being typed is to count before that.
    pub fn ends_typing(&self) -> bool {
        use Command::{Add, NextFile, Open, OpenDialog, Quit, Reload, SaveDialog};
        matches!(
            self,
            OpenDialog | SaveDialog | Open(_) | Add(_) | NextFile { .. } | Reload | Quit
        )
    }
}

/// What a screenshot shows.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(in crate::viewer) struct Shot {
    /// Whether it shows the whole window, in place of the picture alone.
    pub has_panels: bool,
    /// What is behind the scene; `None` for what is there on screen.
    pub backdrop: Option<Backdrop>,
    /// Its size. The four views and the panels always have that on screen.
    pub size: ShotSize,
}

/// The size of a screenshot.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::viewer) enum ShotSize {
    /// As many times that on screen, whatever that is then.
    OnScreen(u32),
    /// This size.
    Fixed(Viewport),
}

impl ShotSize {
    /// The size where the picture on screen has this one; `None` if it would be larger than a picture may be.
    pub fn of(self, on_screen: Viewport) -> Option<Viewport> {
        let times = match self {
            Self::OnScreen(times) => times,
            Self::Fixed(size) => return Some(size),
        };
        let sides = [on_screen.width(), on_screen.height()].map(|side| side.checked_mul(times));
        let [width, height] = sides.map(|side| side.filter(|side| *side <= Viewport::LARGEST_SIDE));
        Viewport::new(width?, height?).ok()
    }
}

impl Default for ShotSize {
    fn default() -> Self {
        Self::OnScreen(1)
    }
}

/// Where a screenshot goes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::viewer) enum ShotTo {
    /// A new PNG file.
    File,
    /// The clipboard.
    Clipboard,
}

/// Something that would drop unsaved edits or measures.
#[derive(Clone, Debug, PartialEq)]
pub(in crate::viewer) enum Intent {
    /// Open these.
    Open(Vec<PathBuf>),
    /// Read the files again.
    Reload,
    /// Go back to what was open before the gallery.
    LeaveGallery,
    /// Close the window.
    Quit,
}

impl Intent {
    /// Whether it would drop edits of a scene on show. Going to the gallery drops none: it leads back.
    pub fn drops_edits(&self, of: &State) -> bool {
        match self {
            Self::Reload => of.edited(),
            _ => of.has_edits() && !self.enters_gallery(of),
        }
    }

    /// Whether it would drop measures of a scene on show. Reading files again keeps them.
    pub fn drops_measures(&self, of: &State) -> bool {
        of.has_measures() && *self != Self::Reload && !self.enters_gallery(of)
    }

    /// Whether it would drop nothing of a scene on show.
    pub fn drops_nothing(&self, of: &State) -> bool {
        !self.drops_edits(of) && !self.drops_measures(of)
    }

    /// Whether it closes the gallery for good, and with it what was left for it.
    pub fn closes(&self) -> bool {
        match self {
            Self::Open(paths) => !is_exhibit(paths),
            Self::Quit => true,
            Self::Reload | Self::LeaveGallery => false,
        }
    }

    fn enters_gallery(&self, from: &State) -> bool {
        matches!(self, Self::Open(paths) if is_exhibit(paths)) && !from.is_in_gallery()
    }
}

/// Whether files are a single scene of the gallery.
fn is_exhibit(paths: &[impl AsRef<Path>]) -> bool {
    matches!(paths, [only] if matches!(Exhibit::at(only.as_ref()), Ok(Some(_))))
}

/// The user's answer to the question about unsaved edits and measures.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::viewer) enum Reply {
    /// Save first.
    Save,
    /// Go on, and drop the edits and the measures.
    GoOn,
    /// Open the files beside what is shown.
    Add,
    /// Do nothing.
    Stay,
}

/// A move in the tour.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::viewer) enum TourMove {
    /// From the first step.
    Begin,
    /// To the step before.
    Back,
    /// To the next step, whether this one is done or not; at the last one, end.
    Next,
    /// End the tour, or decline it.
    End,
}
