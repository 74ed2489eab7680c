//! Watches files that other programs may change.
//!
//! It looks at them twice a second. What the system tells about changes would come sooner, but not about a folder that
//! is gone and comes again, about a folder above it that is renamed, or through links.

use crate::scene::{self, MeshFile, Stamp};
use std::{
    collections::{BTreeMap, BTreeSet},
    mem,
    path::{Path, PathBuf},
    sync::mpsc::{Receiver, RecvTimeoutError, Sender, channel},
    thread,
    time::Duration,
};

/// The time between two looks. Files that are the same in two looks count as completely written, or as gone.
const LOOK: Duration = Duration::from_millis(500);

/// Files, and how each of them was at some time; `None` while it is not there.
#[derive(Clone, Debug, Default, PartialEq)]
pub(in crate::viewer) struct Stamps(BTreeMap<PathBuf, Option<Stamp>>);

impl Stamps {
    /// How files are now, by their absolute paths.
    pub fn of<'a>(files: impl IntoIterator<Item = &'a PathBuf>) -> Self {
        let stamped = files
            .into_iter()
            .map(|file| (scene::absolute(file), Stamp::of(file).ok()));
        Self(stamped.collect())
    }

    /// How the files of meshes were when these were read from them.
    pub fn read(meshes: &[MeshFile]) -> Self {
        let read = meshes.iter().flat_map(MeshFile::read_from);
        Self(
            read.map(|(file, stamp)| (file.to_owned(), stamp.clone()))
                .collect(),
        )
    }

    /// These stamps with `others` added; where both have a file, its stamp is that of `others`.
    pub fn with(mut self, others: Self) -> Self {
        self.0.extend(others.0);
        self
    }

    /// The files that were there and are not there now.
    fn gone(&self, now: &Self) -> Vec<PathBuf> {
        let was_there = self.0.iter().filter(|(_, stamp)| stamp.is_some());
        let is_gone = |file: &&PathBuf| now.0.get(*file).is_some_and(Option::is_none);
        let files = was_there.map(|(file, _)| file);
        files.filter(is_gone).cloned().collect()
    }
}

/// Files that are watched.
pub(in crate::viewer) struct Watching {
    /// Dropping it ends the watch.
    _until: Sender<()>,
    changed: Receiver<Stamps>,
    /// How the files were when they were read.
    read: Stamps,
    /// How the files were when they last changed.
    known: Stamps,
    /// A change is still to be read.
    is_due: bool,
    /// Files that are gone, which nobody was told yet.
    gone: Vec<PathBuf>,
}

impl Watching {
    /// Watches files; calls `wake` whenever one of them has changed. `read` says how some of them were when they were
    /// read: they may have changed since.
    pub fn start(
        files: &BTreeSet<PathBuf>,
        read: &Stamps,
        wake: impl Fn() + Send + 'static,
    ) -> Self {
        let known = files.iter().map(|file| {
            let read = read.0.get(file).cloned();
            (file.clone(), read.unwrap_or_else(|| Stamp::of(file).ok()))
        });
        let known = Stamps(known.collect());
        let (until, end) = channel();
        let (sender, changed) = channel();
        let mut told = known.clone();
        let watch = move || {
            let mut before = Stamps::default();
            while end.recv_timeout(LOOK) == Err(RecvTimeoutError::Timeout) {
                let now = Stamps::of(told.0.keys());
                if now == before && now != told {
                    told = now.clone();
                    if sender.send(now.clone()).is_err() {
                        return;
                    }
                    wake();
                }
                before = now;
            }
        };
        if let Err(error) = thread::Builder::new().spawn(watch) {
            log::warn!("changed files are not followed: {error}");
        }
        Self {
            _until: until,
            changed,
            read: known.clone(),
            known,
            is_due: false,
            gone: Vec::new(),
        }
    }

    /// Whether a file has changed, and that is still to be read. While a file is gone there is nothing to read.
    pub fn is_due(&mut self) -> bool {
        while let Ok(now) = self.changed.try_recv() {
            self.take(now);
        }
        self.is_due
    }

    /// The same; looks at this moment whether a file that is about to be written has changed.
    pub fn look_at(&mut self, file: &Path) -> bool {
        let is_due = self.is_due();
        let file = scene::absolute(file);
        let known = self.known.0.get(&file);
        if known.is_some_and(|known| *known != Stamp::of(&file).ok()) {
            self.take(Stamps::of(self.known.0.keys()));
            return self.is_due;
        }
        is_due
    }

    fn take(&mut self, now: Stamps) {
        if now == self.known {
            return;
        }
        self.gone.extend(self.known.gone(&now));
        let is_gone = |file: &PathBuf| now.0.get(file).is_some_and(Option::is_none);
        self.gone.retain(is_gone);
        self.is_due = now != self.read && self.read.gone(&now).is_empty();
        self.known = now;
    }

    /// The same, by what was looked at so far.
    pub fn was_due(&self) -> bool {
        self.is_due
    }

    /// The files that are gone since this was asked last.
    pub fn take_gone(&mut self) -> Vec<PathBuf> {
        mem::take(&mut self.gone)
    }

    /// Sets whether a change is still to be read.
    pub fn set_due(&mut self, is_due: bool) {
        self.is_due = is_due;
    }

    /// How the files were when they last changed.
    pub fn known(&self) -> &Stamps {
        &self.known
    }

    /// Which files have changed since they were read.
    pub fn changed(&self) -> Vec<PathBuf> {
        let both = self.read.0.iter().zip(self.known.0.values());
        let differ = both.filter(|((_, read), known)| read != known);
        differ.map(|((file, _), _)| file.clone()).collect()
    }

    /// Whether it watches these files and no others.
    pub fn is_of(&self, files: &BTreeSet<PathBuf>) -> bool {
        self.known.0.keys().eq(files)
    }
}
