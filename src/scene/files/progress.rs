//! The progress of a load and its cancellation, shared by the working thread and the window's.

use crate::geometry::shares::on_all_cores;
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};

/// Of steps that take less than a microsecond each, every 4096th reports.
const STEPS: usize = 1 << 12;

/// How far a load has come. Shared by reference; one side reports, the other reads or cancels.
#[derive(Debug, Default)]
pub struct Progress {
    done: AtomicU64,
    total: AtomicU64,
    /// Whether to stop, for work that asks more often than it reports.
    pub(crate) cancelled: AtomicBool,
    /// For tests: how often a load has reported, and the only report, from 1, that is told to stop.
    #[cfg(test)]
    pub(crate) reports: AtomicU64,
    #[cfg(test)]
    pub(crate) stopped_at: AtomicU64,
}

/// Somebody called [`Progress::cancel`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[error("loading was cancelled")]
pub struct Cancelled;

impl Progress {
    /// Adds to the work that is to be done, in bytes.
    pub fn expect(&self, bytes: u64) {
        self.total.fetch_add(bytes, Ordering::Relaxed);
    }

    /// Counts work as done.
    ///
    /// # Errors
    /// When the load was cancelled and should stop.
    pub fn advance(&self, bytes: u64) -> Result<(), Cancelled> {
        self.done.fetch_add(bytes, Ordering::Relaxed);
        #[cfg(test)]
        if self.reports.fetch_add(1, Ordering::Relaxed) + 1
            == self.stopped_at.load(Ordering::Relaxed)
        {
            return Err(Cancelled);
        }
        if self.cancelled.load(Ordering::Relaxed) {
            Err(Cancelled)
        } else {
            Ok(())
        }
    }

    /// Runs `work` on each item, on all cores; the results are in order. Each item counts as `bytes`.
    ///
    /// # Errors
    /// When the load was cancelled.
    pub(super) fn on_all_cores<T, R: Send>(
        &self,
        bytes: u64,
        items: impl Iterator<Item = T> + Send,
        work: impl Fn(T) -> R + Sync,
    ) -> Result<Vec<R>, Cancelled> {
        let done = on_all_cores(items, |item| self.advance(bytes).map(|()| work(item)));
        done.into_iter().collect()
    }

    /// Lets a load be cancelled between many small steps, numbered from 0: reports an advance of 0 before every
    /// `STEPS`th of them.
    ///
    /// # Errors
    /// When the load was cancelled.
    pub(super) fn go_on_at(&self, step: usize) -> Result<(), Cancelled> {
        if step.is_multiple_of(STEPS) {
            self.advance(0)
        } else {
            Ok(())
        }
    }

    /// Asks the load to stop at its next step.
    pub fn cancel(&self) {
        self.cancelled.store(true, Ordering::Relaxed);
    }

    /// The fraction of the expected work that is done, in [0, 1].
    #[expect(
        clippy::cast_precision_loss,
        clippy::cast_possible_truncation,
        reason = "a progress bar"
    )]
    pub fn fraction(&self) -> f32 {
        let total = self.total.load(Ordering::Relaxed);
        let done = self.done.load(Ordering::Relaxed);
        if total == 0 {
            0.0
        } else {
            (done as f64 / total as f64).min(1.0) as f32
        }
    }
}
