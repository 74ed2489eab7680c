//! Which objects were changed, for those who keep something made of a scene: they take over these and no others.

/// A log of changed objects.
#[derive(Clone, Debug, Default)]
pub(super) struct Changes {
    /// Entries that are no longer there.
    forgotten: u64,
    /// Indices of objects, in the order of their changes.
    objects: Vec<usize>,
}

impl Changes {
    /// An object was changed in a scene of `count` objects. What is so long ago that all of them may have changed since is
    /// forgotten.
    pub fn push(&mut self, object: usize, count: usize) {
        if self.objects.len() > 2 * count {
            let old = self.objects.len() - count;
            self.objects.drain(..old);
            self.forgotten += old as u64;
        }
        self.objects.push(object);
    }

    /// More was changed than single objects.
    pub fn everything(&mut self) {
        // One more, so that who knew all of it knows too little now.
        self.forgotten = self.now() + 1;
        self.objects.clear();
    }

    /// The number of changes until now.
    pub fn now(&self) -> u64 {
        self.forgotten + self.objects.len() as u64
    }

    /// The objects that were changed since there were `then` changes; `None` where that is not known.
    pub fn since(&self, then: u64) -> Option<&[usize]> {
        let then = then.checked_sub(self.forgotten)?;
        self.objects.get(usize::try_from(then).ok()?..)
    }
}
