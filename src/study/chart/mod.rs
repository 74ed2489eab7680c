//! The study's charts, each as SVG and PNG.

mod axis;
mod measure;
mod outlines;
mod page;
mod pareto;
pub mod picture;
mod resolution;
mod stability;
mod style;
mod wrong_picks;

pub use outlines::{dashes, outlines};
pub use stability::family;

use super::run::{Report, SCENE};
use crate::{
    camera::{CameraError, Viewport},
    image::{Image, ImageError},
};
use picture::{DrawError, Picture};
use std::path::{Path, PathBuf};

/// Why a chart was not written.
#[derive(Debug, thiserror::Error)]
pub enum ChartError {
    /// The drawing library refused.
    #[error(transparent)]
    Draw(#[from] DrawError),
    /// The SVG file could not be written.
    #[error("cannot write {}: {source}", file.display())]
    Write {
        /// Which file.
        file: PathBuf,
        /// What the file system said.
        source: std::io::Error,
    },
    /// The PNG file could not be written.
    #[error(transparent)]
    Image(#[from] ImageError),
    /// A picture without a pixel.
    #[error(transparent)]
    Size(#[from] CameraError),
}

/// Every chart of a report with its file's stem.
#[must_use]
pub fn charts(report: &Report) -> Vec<(&'static str, Picture)> {
    let all = "Speed against the worst error over every workload";
    let mut charts = vec![
        (
            "pareto",
            pareto::chart(report, all, |row| row.family != SCENE),
        ),
        (
            "stability",
            stability::chart(report, "Where each method breaks"),
        ),
        (
            "depth",
            resolution::chart("What the depth buffer tells apart"),
        ),
        ("wrong_picks", wrong_picks::chart("A map of wrong picks")),
    ];
    if report.has_scene {
        let own = "Speed against the worst error on this scene's own rays";
        charts.push((
            "pareto_scene",
            pareto::chart(report, own, |row| row.family == SCENE),
        ));
    }
    charts
}

/// Writes a chart as `stem.svg` and `stem.png` into a folder.
///
/// # Errors
/// When a file cannot be written.
pub fn write(folder: &Path, stem: &str, picture: &Picture) -> Result<(), ChartError> {
    let file = folder.join(stem).with_extension("svg");
    let written = std::fs::write(&file, picture.svg()?);
    written.map_err(|source| ChartError::Write { file, source })?;
    let size = Viewport::new(picture.width, picture.height)?;
    let image = Image::new(size, picture.pixels()?);
    image.write_png(&folder.join(stem).with_extension("png"))?;
    Ok(())
}
