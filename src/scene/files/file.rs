//! Opens files named by the user, and makes their paths absolute. Refuses what is not a regular file or is too large.

use std::{
    fs::{self, File, Metadata},
    path::{Path, PathBuf},
};

/// Why a file was not read.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum FileError {
    /// It cannot be opened or read.
    #[error("{}: cannot be read: {source}", file.display())]
    Unreadable {
        /// The file.
        file: PathBuf,
        /// What the system says.
        source: std::io::Error,
    },
    /// Not a regular file: a directory, a device or a pipe.
    #[error("{}: is not a file", file.display())]
    NotAFile {
        /// The file.
        file: PathBuf,
    },
    /// Too large: probably not a file of this kind, or more than memory can hold.
    #[error("{}: is too large: more than {} GiB", file.display(), most >> 30)]
    TooLarge {
        /// The file.
        file: PathBuf,
        /// The most bytes that are allowed.
        most: u64,
    },
}

/// The metadata of a regular file.
pub(super) fn about(path: &Path) -> Result<Metadata, FileError> {
    let file = path.to_owned();
    match fs::metadata(path) {
        Err(source) => Err(FileError::Unreadable { file, source }),
        // Not opened: opening a pipe would wait for a writer.
        Ok(about) if !about.is_file() => Err(FileError::NotAFile { file }),
        Ok(about) => Ok(about),
    }
}

/// Opens a file of at most `most` bytes. Returns it with its size.
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

/// The path as an absolute one.
pub(super) fn absolute(path: &Path) -> PathBuf {
    std::path::absolute(path).unwrap_or_else(|_| path.to_owned())
}
