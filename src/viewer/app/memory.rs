//! What is remembered from one run to the next: the window, the panels, what was opened.

use crate::viewer::ui::{Arrangement, Look};
use etcetera::BaseStrategy;
use serde::{Deserialize, Deserializer, Serialize, de::DeserializeOwned};
use std::{
    fs,
    io::Read,
    path::{Path, PathBuf},
};

/// Where the window stood.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub(in crate::viewer) struct WindowPlace {
    /// Width and height in points.
    pub size: [f64; 2],
    /// Top left corner in pixels of the desktop, where the system tells it.
    pub corner_px: Option<[i32; 2]>,
    /// Whether it was maximised.
    pub maximised: bool,
}

/// All that is remembered.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub(in crate::viewer) struct Memory {
    /// The files of scenes, the last first.
    #[serde(deserialize_with = "or_default")]
    pub recent: Vec<Vec<PathBuf>>,
    /// Whether panels are dark or light.
    #[serde(deserialize_with = "or_default")]
    pub look: Look,
    /// Whether the user has taken the tour, or said no to it.
    pub toured: bool,
    #[serde(deserialize_with = "or_default")]
    pub window: Option<WindowPlace>,
    #[serde(deserialize_with = "or_default")]
    pub panels: Arrangement,
}

/// The longest file that is read, in bytes.
const MOST_BYTES: u64 = 1 << 20;

impl Memory {
    /// Reads a file. The default if there is none, or if it is broken.
    pub fn read(file: Option<&Path>) -> Self {
        let Some(file) = file.filter(|file| file.exists()) else {
            return Self::default();
        };
        text_of(file)
            .and_then(|text| toml::from_str(&text).map_err(|error| error.message().to_owned()))
            .unwrap_or_else(|reason| {
                let file = file.display();
                log::warn!("{file}: {reason}: defaults are used instead");
                Self::default()
            })
    }
}

/// A part of what is remembered. Where it is of another version, or broken, its default: the rest is kept.
fn or_default<'de, D: Deserializer<'de>, T: Default + DeserializeOwned>(
    of: D,
) -> Result<T, D::Error> {
    let value = toml::Value::deserialize(of)?;
    Ok(value.try_into().unwrap_or_default())
}

/// The text of a file, or why it is not read.
fn text_of(path: &Path) -> Result<String, String> {
    let about = fs::metadata(path).map_err(|error| error.to_string())?;
    // A pipe or a device may never end, so it is not even opened.
    if !about.is_file() || about.len() > MOST_BYTES {
        return Err("is not a regular file of at most 1 MiB".to_owned());
    }
    let file = fs::File::open(path).map_err(|error| error.to_string())?;
    let mut text = String::new();
    let read = file.take(about.len()).read_to_string(&mut text);
    read.map_err(|error| error.to_string())?;
    Ok(text)
}

/// The file that remembers a user's window; `None` where the system has no place for it.
pub fn memory_file() -> Option<PathBuf> {
    let places = etcetera::choose_base_strategy().ok()?;
    let folder = places.state_dir().unwrap_or_else(|| places.config_dir());
    Some(folder.join("sightline").join("window.toml"))
}

#[cfg(all(test, target_os = "linux"))]
mod tests {
    use super::text_of;
    use std::path::Path;

    /// A file of the system that is longer than its size says.
    #[test]
    fn no_more_is_read_than_the_size_that_was_found() {
        assert_eq!(text_of(Path::new("/proc/self/status")).as_deref(), Ok(""));
    }
}
