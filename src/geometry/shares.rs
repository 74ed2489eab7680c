//! Shares work among all cores.

use std::{
    convert::Infallible,
    iter,
    num::NonZero,
    ops::Range,
    panic::resume_unwind,
    sync::{Mutex, OnceLock, PoisonError},
    thread,
};

/// What long work calls now and then. It is told the share of the work that was done since the last call; all shares
/// add up to 1. An error stops the work.
pub(crate) type GoOn<'a, E> = dyn Fn(f64) -> Result<(), E> + Sync + 'a;

/// Never stops the work.
pub(crate) const ALWAYS: &GoOn<Infallible> = &|_| Ok(());

/// The results of `work` on each item, in order; each free core takes the next item.
pub(crate) fn on_all_cores<T, R: Send>(
    items: impl Iterator<Item = T> + Send,
    work: impl Fn(T) -> R + Sync,
) -> Vec<R> {
    let threads = cores().min(items.size_hint().1.unwrap_or(usize::MAX));
    let items = Mutex::new(items.enumerate());
    let next = || items.lock().unwrap_or_else(PoisonError::into_inner).next();
    let take_all = || -> Vec<_> {
        iter::from_fn(next)
            .map(|(index, item)| (index, work(item)))
            .collect()
    };
    let mut done = thread::scope(|scope| {
        let others: Vec<_> = (1..threads).map(|_| scope.spawn(take_all)).collect();
        let mut done = take_all();
        for other in others {
            done.extend(other.join().unwrap_or_else(|panic| resume_unwind(panic)));
        }
        done
    });
    done.sort_unstable_by_key(|&(index, _)| index);
    done.into_iter().map(|(_, result)| result).collect()
}

/// Items in one piece of work that can be stopped: a few milliseconds, if an item takes less than a tenth of a
/// microsecond.
pub(super) const PIECE: usize = 1 << 15;

/// The results of `work` on the pieces of `0..count`, in order, on all cores, for as long as `go_on` lets it. `weight`
/// is the share of all these pieces in the work that `go_on` knows.
pub(crate) fn in_pieces<T: Send, E: Send>(
    count: usize,
    weight: f64,
    go_on: &GoOn<E>,
    work: impl Fn(Range<usize>) -> T + Sync,
) -> Result<Vec<T>, E> {
    let pieces = (0..count).step_by(PIECE);
    let pieces = pieces.map(|first| first..(first + PIECE).min(count));
    let done = on_all_cores(pieces, |piece| {
        go_on(weight * share(piece.len(), count))?;
        Ok(work(piece))
    });
    done.into_iter().collect()
}

/// A count as a share of another, which is not 0.
#[expect(clippy::cast_precision_loss, reason = "a share")]
pub(crate) fn share(done: usize, of: usize) -> f64 {
    done as f64 / of as f64
}

/// The fewest items that are worth a thread.
pub(crate) const LEAST: usize = 1 << 12;

/// The results of `work` on equal shares of `0..count`, in order; at most one share a core.
pub(crate) fn in_shares<T: Send>(count: usize, work: impl Fn(Range<usize>) -> T + Sync) -> Vec<T> {
    let share = count.div_ceil(cores()).max(LEAST);
    let shares = (0..count).step_by(share);
    on_all_cores(shares.map(|first| first..(first + share).min(count)), work)
}

/// Threads that run at once; 1 where the system does not tell. It is asked once: on Linux, the answer takes reading
/// files.
pub(crate) fn cores() -> usize {
    static CORES: OnceLock<usize> = OnceLock::new();
    *CORES.get_or_init(|| thread::available_parallelism().map_or(1, NonZero::get))
}
