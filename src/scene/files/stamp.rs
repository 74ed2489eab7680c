//! Tells whether a file is still the one that was read.

use super::{FileError, file};
use std::{fs::Metadata, path::Path, time::SystemTime};

/// Properties of a file that show whether it was changed.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Stamp {
    bytes: u64,
    modified: Option<SystemTime>,
    /// The system's number of the file, because another file may have the same name, size and time.
    number: u64,
}

impl Stamp {
    /// The stamp of a file as it is now.
    ///
    /// # Errors
    /// When the path is no regular file, or nothing is there.
    pub fn of(path: &Path) -> Result<Self, FileError> {
        let about = file::about(path)?;
        Ok(Self {
            bytes: about.len(),
            modified: about.modified().ok(),
            number: number(&about),
        })
    }
}

/// The number by which the system identifies a file; 0 if the system has no such number.
#[cfg(unix)]
fn number(about: &Metadata) -> u64 {
    std::os::unix::fs::MetadataExt::ino(about)
}

#[cfg(not(unix))]
fn number(_: &Metadata) -> u64 {
    0
}
