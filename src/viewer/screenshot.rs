//! What is on screen as a PNG file.

use super::{
    app::App,
    canvas::{Canvas, Laid},
};
use crate::image::{Image, Rgb};
use std::path::{Path, PathBuf};

/// Screenshots that are asked for.
#[derive(Default)]
pub(super) struct Screenshots {
    /// Of the next frame.
    pub wanted: bool,
    /// Where they go: the folder that the program runs in, at first.
    pub folder: PathBuf,
}

impl App {
    /// Writes the frame that was just drawn, where that was asked for.
    pub fn take_screenshot(&mut self, canvas: &mut Canvas, laid: &Laid) {
        if !std::mem::take(&mut self.screenshots.wanted) {
            return;
        }
        let picture = canvas.picture(&self.state, laid);
        let written = picture
            .map_err(|error| error.to_string())
            .and_then(|picture| write(&self.screenshots.folder, &picture));
        match written {
            Ok(path) => self.say(format!("saved {}", path.display())),
            Err(text) => self.complain(text),
        }
    }
}

/// Writes `sightline-N.png`, N the first number that is free.
fn write(folder: &Path, picture: &Image<Rgb>) -> Result<PathBuf, String> {
    let mut names = (1..).map(|number| folder.join(format!("sightline-{number}.png")));
    let free = names.find(|path| !path.exists());
    let free = free.ok_or("no number is left for a screenshot")?;
    let path = std::path::absolute(free).map_err(|error| error.to_string())?;
    picture
        .write_png(&path)
        .map_err(|error| error.to_string())?;
    Ok(path)
}
