//! Writes a small file that is kept from run to run: atomically, in the background.

use super::job::Job;
use crate::{replace::replace, scene::Progress};
use std::{fs, io, path::PathBuf};

/// Writes the file, and makes its folder if there is none. Waits for the write before, so that an older text never
/// replaces a newer one.
pub(in crate::viewer) fn keep(before: Option<Job<()>>, path: PathBuf, text: String) -> Job<()> {
    let keep = move |_: &Progress| {
        if let Some(before) = before {
            before.wait();
        }
        let write = || -> io::Result<()> {
            if let Some(folder) = path.parent() {
                fs::create_dir_all(folder)?;
            }
            replace(&path, |out| out.write_all(text.as_bytes()))
        };
        if let Err(error) = write() {
            log::warn!("{}: {error}: not remembered", path.display());
        }
    };
    Job::start(keep, || (), || ())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_was_said_last_stays() {
        let folder = tempfile::tempdir().expect("a folder");
        let path = folder.path().join("kept");
        let mut last = None;
        for i in 0..100 {
            last = Some(keep(last, path.clone(), i.to_string()));
        }
        last.and_then(|last| last.wait()).expect("it is written");
        assert_eq!(fs::read_to_string(&path).expect("a file"), "99");
    }
}
