//! A small file that is kept from run to run: written whole, beside the window.

use crate::replace::replace;
use std::{fs, io, path::Path, thread};

/// Writes it; a folder that is not there yet is made.
pub(in crate::viewer) fn keep(path: &Path, text: &str) {
    let write = || -> io::Result<()> {
        if let Some(folder) = path.parent() {
            fs::create_dir_all(folder)?;
        }
        replace(path, |out| out.write_all(text.as_bytes()))
    };
    if let Err(error) = write() {
        log::warn!("{}: {error}: not remembered", path.display());
    }
}

/// Writes it in its own time.
pub(in crate::viewer) fn keep_beside(path: &Path, text: String) {
    let path = path.to_owned();
    thread::spawn(move || keep(&path, &text));
}
