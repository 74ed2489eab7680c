//! Writes a screenshot as a PNG file.

use crate::image::{Image, Rgb};
use std::path::{Path, PathBuf};

/// Writes `sightline-N.png`, N the first number that is free.
pub(in crate::viewer) fn write_screenshot(
    folder: &Path,
    picture: &Image<Rgb>,
) -> Result<PathBuf, String> {
    let mut names = (1..).map(|number| folder.join(format!("sightline-{number}.png")));
    let free = names.find(|path| !path.exists());
    let free = free.ok_or("no number is left for a screenshot")?;
    let path = std::path::absolute(free).map_err(|error| error.to_string())?;
    let written = picture.write_png(&path);
    written.map_err(|error| error.to_string())?;
    Ok(path)
}
