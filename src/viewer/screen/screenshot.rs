//! Writes a screenshot as a PNG file, under a name that is free.

use crate::image::Picture;
use std::path::{Path, PathBuf};

/// The path of `sightline-N` with this extension, N the first number that is free.
pub(in crate::viewer) fn free_file(folder: &Path, extension: &str) -> Result<PathBuf, String> {
    let mut names = (1..).map(|number| folder.join(format!("sightline-{number}.{extension}")));
    let free = names.find(|path| !path.exists());
    let free = free.ok_or("no number is left for a file's name")?;
    std::path::absolute(free).map_err(|error| error.to_string())
}

/// Writes `sightline-N.png`.
pub(in crate::viewer) fn write_screenshot(
    folder: &Path,
    picture: &Picture,
) -> Result<PathBuf, String> {
    let path = free_file(folder, "png")?;
    let written = picture.write_png(&path);
    written.map_err(|error| error.to_string())?;
    Ok(path)
}
