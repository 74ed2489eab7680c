//! What is remembered from one run to the next: the window, the panels, what was opened.

use crate::viewer::ui::{Docks, Look};
use etcetera::BaseStrategy;
use serde::{Deserialize, Serialize};
use std::{
    fs,
    path::{Path, PathBuf},
};

/// Where the window stood.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub(in crate::viewer) struct WindowPlace {
    /// Width and height in points.
    pub size: [f64; 2],
    /// Top left corner in pixels of the desktop, where the system tells it.
    pub corner_px: Option<[i32; 2]>,
    /// Whether it filled its screen, but for the desktop's own bars.
    pub maximised: bool,
}

/// All of it.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub(in crate::viewer) struct Memory {
    /// The files of scenes, the last first.
    pub recent: Vec<Vec<PathBuf>>,
    /// Whether panels are dark or light.
    pub look: Look,
    /// Whether the user has taken the tour, or said no to it.
    pub toured: bool,
    pub window: Option<WindowPlace>,
    pub panels: Docks,
}

impl Memory {
    /// What a file holds; nothing where there is none, or where it is broken.
    pub fn read(file: Option<&Path>) -> Self {
        let Some(text) = file.and_then(|file| fs::read_to_string(file).ok()) else {
            return Self::default();
        };
        toml::from_str(&text).unwrap_or_else(|error| {
            let file = file.unwrap_or(Path::new("")).display();
            let reason = error.message();
            log::warn!("{file}: {reason}: what was remembered is not used");
            Self::default()
        })
    }
}

/// The file that a user's window is remembered in; `None` where the system has no place for it.
#[must_use]
pub fn memory_file() -> Option<PathBuf> {
    let places = etcetera::choose_base_strategy().ok()?;
    let folder = places.state_dir().unwrap_or_else(|| places.config_dir());
    Some(folder.join("sightline").join("window.toml"))
}
