//! The question for a path, where the desktop shows no file dialog.

use crate::scene;
use std::path::{Path, PathBuf};

/// What the path is for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::viewer) enum PathFor {
    /// To open the file.
    Open,
    /// To save the scene to it.
    Save,
}

/// The question and what was typed so far.
#[derive(Clone, Debug)]
pub(in crate::viewer) struct PathQuestion {
    /// What the path is for.
    pub what: PathFor,
    /// The text in the field.
    pub text: String,
    /// Why this text was not taken, or what taking it once more will do.
    pub said: Option<String>,
    /// The file that is replaced if its path is taken once more.
    pub replaces: Option<PathBuf>,
}

impl PathQuestion {
    /// The question, with this path in the field.
    pub fn new(what: PathFor, path: &Path) -> Self {
        Self {
            what,
            text: path.display().to_string(),
            said: None,
            replaces: None,
        }
    }

    /// The text has changed: nothing is agreed any more.
    pub fn edited(&mut self) {
        (self.said, self.replaces) = (None, None);
    }

    /// Takes the path in the field. `None` if it cannot be taken, or not yet: then [`Self::said`] says why. A file that
    /// is there already is replaced only if its path is taken twice.
    pub fn take(&mut self) -> Option<PathBuf> {
        let mut path = in_home(self.text.trim());
        if path.as_os_str().is_empty() || path.is_dir() {
            self.said = Some("This is not the path of a file.".into());
            return None;
        }
        if self.what == PathFor::Save && !scene::is_scene_file(&path) {
            path.add_extension("toml");
        }
        let name = path.display();
        match self.what {
            PathFor::Open if !path.exists() => {
                self.said = Some(format!("{name} does not exist."));
                None
            }
            PathFor::Save if path.exists() && self.replaces.as_ref() != Some(&path) => {
                let text = format!("{name} exists already. Enter once more replaces it.");
                (self.said, self.replaces) = (Some(text), Some(path));
                None
            }
            _ => Some(path),
        }
    }
}

/// A typed path. A leading `~/` is the home folder, as in a shell.
fn in_home(typed: &str) -> PathBuf {
    match (typed.strip_prefix("~/"), std::env::home_dir()) {
        (Some(rest), Some(home)) => home.join(rest),
        _ => PathBuf::from(typed),
    }
}
