//! Opens and reads files named by the user, and makes their paths absolute. Refuses what is not a regular file or is
//! too large.

use std::{
    fs::{self, File, Metadata},
    io::{self, Read},
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
    /// Longer than the size that was found on opening, so it may never end.
    #[error("{}: is longer than its size says ({bytes} bytes): copy it and open the copy", file.display())]
    Longer {
        /// The file.
        file: PathBuf,
        /// The size that was found on opening.
        bytes: u64,
    },
    /// Changed by another program while it was read. What was read may be cut off inside a number.
    #[error("{}: changed while it was read: open it again once it is complete", file.display())]
    Changed {
        /// The file.
        file: PathBuf,
    },
    /// Not text in UTF-8.
    #[error("{}: is not text in UTF-8: save it in that encoding", file.display())]
    NotUtf8 {
        /// The file.
        file: PathBuf,
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

/// Refuses a file whose reading takes more memory than there is, in bytes.
pub(super) fn check_memory(path: &Path, bytes: usize) -> Result<(), FileError> {
    let reserved = Vec::<u8>::new().try_reserve_exact(bytes);
    reserved.map_err(|source| FileError::Unreadable {
        file: path.to_owned(),
        source: source.into(),
    })
}

/// The whole text of a file of at most `most` bytes.
pub(super) fn text(path: &Path, most: u64) -> Result<String, FileError> {
    let file = || path.to_owned();
    let (opened, bytes) = open(path, most)?;
    // One byte more shows whether the file is longer.
    let read = up_to(opened, bytes + 1).map_err(|source| FileError::Unreadable {
        file: file(),
        source,
    })?;
    if read.len() as u64 > bytes {
        return Err(FileError::Longer {
            file: file(),
            bytes,
        });
    }
    String::from_utf8(read).map_err(|_| FileError::NotUtf8 { file: file() })
}

/// Whether a regular file holds exactly these bytes. Nothing is read of a file of another size.
pub(super) fn holds(path: &Path, bytes: &[u8]) -> bool {
    let size = bytes.len() as u64;
    open(path, size)
        .ok()
        .filter(|(_, there)| *there == size)
        .and_then(|(opened, _)| up_to(opened, size).ok())
        .is_some_and(|there| there == bytes)
}

/// The first bytes of a file, at most `bytes`. Too little memory is an error.
fn up_to(file: File, bytes: u64) -> io::Result<Vec<u8>> {
    let mut read = Vec::new();
    read.try_reserve_exact(usize::try_from(bytes).unwrap_or(usize::MAX))?;
    file.take(bytes).read_to_end(&mut read)?;
    Ok(read)
}

/// The path as an absolute one.
pub(crate) fn absolute(path: &Path) -> PathBuf {
    std::path::absolute(path).unwrap_or_else(|_| path.to_owned())
}
