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

    /// Room in the log of a scene of `count` objects for the next `more` changes, to be filled in. If the log has more
    /// than twice as many entries as objects, only the latest `count` are kept before.
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

    /// Logs a change that is more than one of single objects.
    pub fn everything(&mut self) {
        // Plus 1, so that even a reader who was up to date gets `None`.
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
