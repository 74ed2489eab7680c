//! What the user asks for through keys, buttons or menus.

use crate::{
    scene::gallery::Exhibit,
    viewer::model::{Action, State},
};
use std::path::{Path, PathBuf};

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
    /// Put the view as a command line on the clipboard.
    CopyCommandLine,
    /// Put the camera on the clipboard, as a scene file writes it.
    CopyCamera,
    /// Take over the camera in this text from the clipboard.
    Paste(String),
    /// Show an object, or what its file calls by a number.
    GoTo(GoTo),
    /// Write what is on screen into a PNG file.
    Screenshot {
        /// Without the panels.
        alone: bool,
    },
    /// Put this text on the clipboard.
    Copy(String),
    /// Select the object of the next row in the list, or of the one before.
    SelectRow {
        /// The next.
        down: bool,
    },
    /// Fill the screen with the window, or no more.
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
    /// An answer to the question whether edits may go.
    Reply(Reply),
    /// Keep the edits that are asked about, else wait for no more picks of a section or a measure, else stop loading, else close the help, else pick by Sightline's own method
    /// again, else close the comparison, else select nothing, else close the four
    /// views, else leave the gallery.
    Escape,
    /// Show or hide the help.
    ToggleHelp,
    /// Show or hide the matrices.
    TogglePipeline,
    /// Show the four views with the matrices beside them, or the camera's picture again.
    ToggleFour,
    /// The panel shows the depth buffer's steps at the pick, in each pass that it does: the tour asks for it.
    ShowsDepthSteps,
    /// Begin the tour, or go on in it.
    Tour(TourMove),
    /// Give the panels the next of the looks that they can have.
    NextLook,
    /// Close the window.
    Quit,
}

/// What can be gone to by its number, from 1.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::viewer) enum GoTo {
    /// An object of the scene.
    Object(usize),
    /// A face of the file.
    Face(usize),
    /// A vertex of the file.
    Vertex(usize),
}

/// What would drop edits that no file has.
#[derive(Clone, Debug, PartialEq)]
pub(in crate::viewer) enum Intent {
    /// Open these.
    Open(Vec<PathBuf>),
    /// Read the files again.
    Reload,
    /// Close the window.
    Quit,
}

impl Intent {
    /// The scenes whose edits it would drop.
    pub fn drops<'a>(&self, state: &'a State) -> Vec<&'a State> {
        match self {
            // The gallery leaves the way back open.
            Self::Open(paths) if is_exhibit(paths) => Vec::new(),
            Self::Reload => state.edited().then_some(state).into_iter().collect(),
            Self::Open(_) | Self::Quit => state.unsaved_scenes(),
        }
    }
}

/// Whether files are a single scene of the gallery.
fn is_exhibit(paths: &[impl AsRef<Path>]) -> bool {
    match paths {
        [only] => matches!(Exhibit::at(only.as_ref()), Ok(Some(_))),
        _ => false,
    }
}

/// What the user answers to that.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::viewer) enum Reply {
    /// Save first.
    Save,
    /// Do it; the edits may go.
    GoOn,
    /// Open the files beside what is shown.
    Add,
    /// Do not.
    Stay,
}

/// What somebody on the tour asks for.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::viewer) enum TourMove {
    /// From the first step.
    Begin,
    /// To the step before.
    Back,
    /// To the next step, whether this one is done or not; from the last one out.
    Next,
    /// Out, or not even in.
    End,
}
