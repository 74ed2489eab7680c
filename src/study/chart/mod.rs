//! The study's charts, each as SVG and PNG.

mod axis;
mod bounds;
mod depth;
mod front;
mod heat;
mod labels;
mod measure;
mod outlines;
mod overview;
mod page;
pub mod picture;
mod stability;
mod style;
mod tiles;

pub use outlines::outlines;
pub use stability::family;

use super::run::Report;
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

/// Each chart of a report with its file's stem.
#[must_use]
pub fn charts(report: &Report) -> Vec<(&'static str, Picture)> {
    let [general, own] = report.split();
    let report = &general.unwrap_or_default();
    let all = "Speed against the worst error over every workload";
    let mut charts = vec![
        ("front", front::chart(report)),
        ("heat", heat::chart(report)),
        ("smallest_steps", tiles::chart()),
        ("bounds", bounds::chart(report)),
        ("depth", depth::chart()),
        ("stability", stability::chart(report)),
        ("hit_rates", stability::hit_rates(report)),
        ("overview", overview::chart(report, all)),
    ];
    if let Some(own) = own {
        let title = "Speed against the worst error on this scene's own rays";
        charts.push(("overview_scene", overview::chart(&own, title)));
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
