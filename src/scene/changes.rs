//! Which objects were changed, for those who keep something made of a scene: they take over these and no others.

/// That an object was shown, hidden or moved.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Change {
    /// Its index.
    pub object: usize,
    /// Whether it has another placement.
    pub moved: bool,
    /// Whether it is shown since.
    pub visible: bool,
}

/// A log of changed objects.
#[derive(Clone, Debug, Default)]
pub(super) struct Changes {
    /// Entries that are no longer there.
    forgotten: u64,
    /// In their order.
    log: Vec<Change>,
}

impl Changes {
    /// An object was changed in a scene of `count` objects. What is so long ago that all of them may have changed since is
    /// forgotten.
    pub fn push(&mut self, change: Change, count: usize) {
        if self.log.len() > 2 * count {
            let old = self.log.len() - count;
            self.log.drain(..old);
            self.forgotten += old as u64;
        }
        self.log.push(change);
    }

    /// More was changed than single objects.
    pub fn everything(&mut self) {
        // One more, so that who knew all of it knows too little now.
        self.forgotten = self.now() + 1;
        self.log.clear();
    }

    /// The number of changes until now.
    pub fn now(&self) -> u64 {
        self.forgotten + self.log.len() as u64
    }

    /// What was changed since there were `then` changes; `None` where that is not known.
    pub fn since(&self, then: u64) -> Option<&[Change]> {
        let then = then.checked_sub(self.forgotten)?;
        self.log.get(usize::try_from(then).ok()?..)
    }
}
