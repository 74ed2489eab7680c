//! Shares work among all cores.

use std::{
    iter,
    num::NonZero,
    ops::Range,
    panic::resume_unwind,
    sync::{Mutex, OnceLock, PoisonError},
    thread,
};

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
        // Where the system gives no more threads, those that are there do it all.
        let others =
            (1..threads).map_while(|_| thread::Builder::new().spawn_scoped(scope, take_all).ok());
        let others: Vec<_> = others.collect();
        let mut done = take_all();
        for other in others {
            done.extend(other.join().unwrap_or_else(|panic| resume_unwind(panic)));
        }
        done
    });
    done.sort_unstable_by_key(|&(index, _)| index);
    done.into_iter().map(|(_, result)| result).collect()
}

/// The results of `work` on pieces of `0..count`, in order; each free core takes the next piece.
pub(crate) fn in_pieces<T: Send>(count: usize, work: impl Fn(Range<usize>) -> T + Sync) -> Vec<T> {
    const PIECE: usize = 1 << 15;
    let pieces = (0..count).step_by(PIECE);
    on_all_cores(pieces.map(|first| first..(first + PIECE).min(count)), work)
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
