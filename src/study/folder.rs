//! The study as files in a folder.

use super::{
    charts::{Chart, DrawError},
    csv::{csv, summary_csv},
    run::Report,
};
use crate::{
    camera::{CameraError, Viewport},
    image::{Image, ImageError},
    replace::replace,
};
use std::path::{Path, PathBuf};

/// Why a report was not written.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum SaveError {
    /// The drawing library refused.
    #[error(transparent)]
    Draw(#[from] DrawError),
    /// A text file could not be written.
    #[error("cannot write {}: {source}", file.display())]
    Write {
        /// Which file.
        file: PathBuf,
        /// What the file system said.
        source: std::io::Error,
    },
    /// A PNG file could not be written.
    #[error(transparent)]
    Image(#[from] ImageError),
    /// A picture without pixels.
    #[error(transparent)]
    Size(#[from] CameraError),
}

/// Writes a report's tables and charts into a folder. Each file is written whole or not at all: where there is no room,
/// an earlier run's files stay.
///
/// # Errors
/// When a file cannot be written.
pub fn save(folder: &Path, report: &Report) -> Result<(), SaveError> {
    text(folder.join("study.csv"), &csv(report))?;
    text(folder.join("summary.csv"), &summary_csv(report))?;
    for chart in Chart::ALL {
        save_chart(folder, chart, report)?;
    }
    Ok(())
}

/// Writes a report's chart as SVG and PNG into a folder.
///
/// # Errors
/// When a file cannot be written.
pub fn save_chart(folder: &Path, chart: Chart, report: &Report) -> Result<(), SaveError> {
    let file = folder.join(chart.stem());
    text(file.with_extension("svg"), &chart.svg(report)?)?;
    let (width, height) = Chart::SIZE;
    let size = Viewport::new(width / 2, height / 2)?;
    let image = Image::new(size, chart.pixels(report)?);
    image.write_png(&file.with_extension("png"))?;
    Ok(())
}

fn text(file: PathBuf, text: &str) -> Result<(), SaveError> {
    let written = replace(&file, |out| out.write_all(text.as_bytes()));
    written.map_err(|source| SaveError::Write { file, source })
}
