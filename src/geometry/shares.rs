//! Work that is shared out to all cores.

use std::{
    num::NonZero,
    ops::Range,
    panic::resume_unwind,
    thread::{self, ScopedJoinHandle},
};

/// The results of `work` on equal shares of `0..count`, in order, from a thread a core.
pub(super) fn in_shares<T: Send>(count: usize, work: impl Fn(Range<usize>) -> T + Sync) -> Vec<T> {
    let threads = thread::available_parallelism().map_or(1, NonZero::get);
    let share = count.div_ceil(threads).max(1);
    thread::scope(|scope| {
        let work = &work;
        let started: Vec<_> = (0..count)
            .step_by(share)
            .map(|first| first..(first + share).min(count))
            .map(|share| scope.spawn(move || work(share)))
            .collect();
        let finish = |thread: ScopedJoinHandle<_>| {
            thread.join().unwrap_or_else(|panic| resume_unwind(panic))
        };
        started.into_iter().map(finish).collect()
    })
}
