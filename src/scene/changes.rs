//! A log of changed objects, so that data derived from a scene is updated for these objects only.

/// An object was shown, hidden or moved.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Change {
    /// Its index.
    pub object: usize,
    /// Whether its placement changed.
    pub moved: bool,
    /// Whether it is visible after the change.
    pub visible: bool,
}

/// A log of changed objects.
#[derive(Clone, Debug, Default)]
pub(super) struct Changes {
    /// How many entries were dropped.
    forgotten: u64,
    /// The latest changes, oldest first.
    log: Vec<Change>,
}

impl Changes {
    /// Logs a change in a scene of `count` objects.
    pub fn push(&mut self, change: Change, count: usize) {
        self.room_for(1, count)[0] = change;
    }

    /// Adds `more` entries to the log and returns them, to be filled in. `count` is the number of objects in the scene.
    /// A log of more than `2 * count` entries is first cut to the latest `count`.
    pub fn room_for(&mut self, more: usize, count: usize) -> &mut [Change] {
        if self.log.len() > 2 * count {
            let old = self.log.len() - count;
            self.log.drain(..old);
            self.forgotten += old as u64;
        }
        let logged = self.log.len();
        self.log.resize(logged + more, Change::default());
        &mut self.log[logged..]
    }

    /// Logs a change of the whole scene: all readers have to start again.
    pub fn everything(&mut self) {
        // Plus 1, so that even a reader that was up to date gets `None`.
        self.forgotten = self.now() + 1;
        self.log.clear();
    }

    /// The number of changes until now.
    pub fn now(&self) -> u64 {
        self.forgotten + self.log.len() as u64
    }

    /// The changes after the first `then`; `None` where the log no longer has them all.
    pub fn since(&self, then: u64) -> Option<&[Change]> {
        let then = then.checked_sub(self.forgotten)?;
        self.log.get(usize::try_from(then).ok()?..)
    }
}
