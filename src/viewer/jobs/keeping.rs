//! Writes a small file that is kept from run to run: atomically, in the background.

use crate::replace::replace;
use std::{
    fs, io,
    path::{Path, PathBuf},
    sync::{Arc, Mutex, PoisonError},
    thread,
};

/// Writes the file. An older text never replaces a newer one, however slow its thread is.
#[derive(Default)]
pub(in crate::viewer) struct Keeping {
    latest: u64,
    written: Arc<Mutex<u64>>,
}

impl Keeping {
    /// Writes the file now, and makes its folder if there is none.
    pub fn keep(&mut self, path: &Path, text: &str) {
        self.latest += 1;
        write_unless_later(&self.written, self.latest, path, text);
    }

    /// Writes the file in the background.
    pub fn keep_beside(&mut self, path: PathBuf, text: String) {
        self.latest += 1;
        let (written, number) = (Arc::clone(&self.written), self.latest);
        thread::spawn(move || write_unless_later(&written, number, &path, &text));
    }
}

fn write_unless_later(written: &Mutex<u64>, number: u64, path: &Path, text: &str) {
    let mut written = written.lock().unwrap_or_else(PoisonError::into_inner);
    if *written > number {
        return;
    }
    *written = number;
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_was_said_last_stays() {
        let folder = tempfile::tempdir().expect("a folder");
        let path = folder.path().join("kept");
        let mut keeping = Keeping::default();
        for i in 0..100 {
            keeping.keep_beside(path.clone(), "before".into());
            keeping.keep(&path, &i.to_string());
        }
        // Late threads get the lock, and find their number too low.
        while Arc::strong_count(&keeping.written) > 1 {
            thread::yield_now();
        }
        assert_eq!(fs::read_to_string(&path).expect("a file"), "99");
    }
}
