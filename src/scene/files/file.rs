//! Files that somebody names: opened only where they are files, and no larger than what they hold may be.

use std::{
    fs::{self, File, Metadata},
    path::{Path, PathBuf},
};

/// Why a file was not read.
#[derive(Debug, thiserror::Error)]
pub enum FileError {
    /// It cannot be opened or read.
    #[error("{}: cannot be read: {source}", file.display())]
    Unreadable {
        /// The file.
        file: PathBuf,
        /// What the system says.
        source: std::io::Error,
    },
    /// A directory, a device, a pipe.
    #[error("{}: is not a file", file.display())]
    NotAFile {
        /// The file.
        file: PathBuf,
    },
    /// Not what it says it is, or more than anybody's memory holds.
    #[error("{}: is too large: more than {} GiB", file.display(), most >> 30)]
    TooLarge {
        /// The file.
        file: PathBuf,
        /// How many bytes there may be.
        most: u64,
    },
}

/// What the system says of a file.
pub(super) fn about(path: &Path) -> Result<Metadata, FileError> {
    let file = path.to_owned();
    match fs::metadata(path) {
        Err(source) => Err(FileError::Unreadable { file, source }),
        // Not even opened: a pipe would wait for somebody to write into it.
        Ok(about) if !about.is_file() => Err(FileError::NotAFile { file }),
        Ok(about) => Ok(about),
    }
}

/// The file and its size, which is at most `most` bytes.
pub(super) fn open(path: &Path, most: u64) -> Result<(File, u64), FileError> {
    let file = || path.to_owned();
    let bytes = about(path)?.len();
    if bytes > most {
        return Err(FileError::TooLarge { file: file(), most });
    }
    let opened = File::open(path).map_err(|source| FileError::Unreadable {
        file: file(),
        source,
    })?;
    Ok((opened, bytes))
}
