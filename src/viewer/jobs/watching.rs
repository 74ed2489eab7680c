//! Watches files that other programs may change.

use crate::scene;
use notify::{RecommendedWatcher, RecursiveMode, Watcher};
use std::{
    collections::{BTreeMap, BTreeSet},
    fs, mem,
    path::{Path, PathBuf},
    sync::mpsc::{Receiver, channel},
    thread,
    time::{Duration, SystemTime},
};

/// Files that nothing has happened to for this long count as completely written.
const QUIET: Duration = Duration::from_millis(300);
/// A program that writes a file anew may take it away for a moment. A file that has been away for longer is gone.
const AWAY: Duration = Duration::from_secs(1);

/// When a file was changed last, and its length; `None` while it is not there.
type Stamp = Option<(SystemTime, u64)>;

/// Files, and how each of them was at some time.
#[derive(Clone, Debug, Default, PartialEq)]
pub(in crate::viewer) struct Stamps(BTreeMap<PathBuf, Stamp>);

impl Stamps {
    /// How files are now, by their absolute paths.
    pub fn of<'a>(files: impl IntoIterator<Item = &'a PathBuf>) -> Self {
        let stamped = files
            .into_iter()
            .map(|file| (scene::absolute(file), stamp(file)));
        Self(stamped.collect())
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
    _watcher: RecommendedWatcher,
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
    /// read: they may have changed since. `None` if the system cannot watch.
    pub fn start(
        files: &BTreeSet<PathBuf>,
        read: &Stamps,
        wake: impl Fn() + Send + 'static,
    ) -> Option<Self> {
        let (told, events) = channel();
        // A first event, so that the thread looks once at the start.
        let _ = told.send(());
        let mut watcher = notify::recommended_watcher(move |_: notify::Result<notify::Event>| {
            // Sending fails once the watch has ended.
            let _ = told.send(());
        })
        .ok()?;
        // When a file is replaced, only its folder gets the event.
        let folders: BTreeSet<_> = files.iter().filter_map(|file| folder_of(file)).collect();
        for folder in folders {
            if let Err(error) = watcher.watch(folder, RecursiveMode::NonRecursive) {
                log::info!("{}: {error}: not watched", folder.display());
            }
        }
        // Taken now, before the thread runs, so that no change is missed.
        let known = files.iter().map(|file| {
            let read = read.0.get(file).copied();
            (file.clone(), read.unwrap_or_else(|| stamp(file)))
        });
        let known = Stamps(known.collect());
        let mut last = known.clone();
        let (sender, changed) = channel();
        thread::spawn(move || {
            while events.recv().is_ok() {
                while events.recv_timeout(QUIET).is_ok() {}
                let mut now = Stamps::of(last.0.keys());
                if !last.gone(&now).is_empty() {
                    thread::sleep(AWAY);
                    now = Stamps::of(last.0.keys());
                }
                if now != last {
                    last = now.clone();
                    if sender.send(now).is_err() {
                        return;
                    }
                    wake();
                }
            }
        });
        Some(Self {
            _watcher: watcher,
            changed,
            read: known.clone(),
            known,
            is_due: false,
            gone: Vec::new(),
        })
    }

    /// Whether a file has changed, and that is still to be read. While a file is gone there is nothing to read.
    pub fn is_due(&mut self) -> bool {
        for now in self.changed.try_iter() {
            self.gone.extend(self.known.gone(&now));
            let is_gone = |file: &PathBuf| now.0.get(file).is_some_and(Option::is_none);
            self.gone.retain(is_gone);
            self.is_due = self.read.gone(&now).is_empty();
            self.known = now;
        }
        self.is_due
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

fn folder_of(file: &Path) -> Option<&Path> {
    let folder = file.parent()?;
    Some(if folder.as_os_str().is_empty() {
        Path::new(".")
    } else {
        folder
    })
}

fn stamp(file: &PathBuf) -> Stamp {
    let about = fs::metadata(file).ok()?;
    Some((about.modified().ok()?, about.len()))
}
