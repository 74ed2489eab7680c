//! A small file that is kept from run to run: written whole, beside the window.

use crate::replace::replace;
use std::{
    fs, io,
    path::{Path, PathBuf},
    sync::{Arc, Mutex, PoisonError},
    thread,
};

/// Writes the file. What was said before never comes after what was said later, however long it took.
#[derive(Default)]
pub(in crate::viewer) struct Keeping {
    said: u64,
    written: Arc<Mutex<u64>>,
}

impl Keeping {
    /// Writes it; a folder that is not there yet is made.
    pub fn keep(&mut self, path: &Path, text: &str) {
        self.said += 1;
        write_unless_later(&self.written, self.said, path, text);
    }

    /// Writes it in its own time.
    pub fn keep_beside(&mut self, path: PathBuf, text: String) {
        self.said += 1;
        let (written, number) = (Arc::clone(&self.written), self.said);
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
        // Threads that are late find the lock taken by nobody, and their number too low.
        while Arc::strong_count(&keeping.written) > 1 {
            thread::yield_now();
        }
        assert_eq!(fs::read_to_string(&path).expect("a file"), "99");
    }
}
