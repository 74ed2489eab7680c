//! Work on a thread of its own, its progress and its result.

use crate::scene::Progress;
use std::{
    panic::{self, AssertUnwindSafe},
    sync::{
        Arc, Mutex, PoisonError,
        mpsc::{Receiver, channel},
    },
    thread,
};

/// Work in the background. Dropping it drops the result and cancels the progress; work that reports none goes on.
pub(in crate::viewer) struct Job<T> {
    progress: Arc<Progress>,
    result: Receiver<T>,
}

impl<T: Send + 'static> Job<T> {
    /// Begins; calls `wake` when done. The result of work that panics is `lost`: nobody waits for ever. Where the
    /// system gives no more threads, the work is done before this returns.
    pub fn start(
        work: impl FnOnce(&Progress) -> T + Send + 'static,
        wake: impl FnOnce() + Send + 'static,
        lost: impl FnOnce() -> T + Send + 'static,
    ) -> Self {
        let (sender, result) = channel();
        let progress = Arc::new(Progress::default());
        let shared = Arc::clone(&progress);
        let run = move || {
            let done = panic::catch_unwind(AssertUnwindSafe(|| work(&shared)));
            // The receiver is gone if nobody wants the result any more.
            let _ = sender.send(done.unwrap_or_else(|_| lost()));
            wake();
        };
        let run = Arc::new(Mutex::new(Some(run)));
        let run_once = {
            let run = Arc::clone(&run);
            move || {
                if let Some(run) = take(&run) {
                    run();
                }
            }
        };
        let spawned = thread::Builder::new().spawn(run_once);
        if spawned.is_err()
            && let Some(run) = take(&run)
        {
            run();
        }
        Self { progress, result }
    }

    /// A job that is done already.
    pub fn done(done: T) -> Self {
        let (sender, result) = channel();
        // This cannot fail: the receiver is still here.
        let _ = sender.send(done);
        Self {
            progress: Arc::default(),
            result,
        }
    }

    /// The share that is done, in [0, 1].
    pub fn fraction(&self) -> f32 {
        self.progress.fraction()
    }

    /// The result, once it is there. It is given once.
    pub fn poll(&self) -> Option<T> {
        self.result.try_recv().ok()
    }

    /// The result, waited for; `None` if it was given already.
    pub fn wait(&self) -> Option<T> {
        self.result.recv().ok()
    }
}

/// What is kept for whoever comes first.
fn take<F>(kept: &Mutex<Option<F>>) -> Option<F> {
    kept.lock().unwrap_or_else(PoisonError::into_inner).take()
}

impl<T> Drop for Job<T> {
    fn drop(&mut self) {
        self.progress.cancel();
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn work_that_reports_ends_once_its_job_is_dropped() {
        let (sender, ended) = channel();
        let work = |progress: &Progress| while progress.advance(0).is_ok() {};
        let wake = move || sender.send(()).unwrap_or_default();
        drop(Job::start(work, wake, || ()));
        ended.recv().expect("an end");
    }

    #[test]
    fn work_that_panics_wakes_its_caller_and_has_a_result() {
        let start = || {
            let (sender, woken) = channel();
            let wake = move || sender.send(()).unwrap_or_default();
            let job = Job::start(|_| panic!("on purpose"), wake, || "lost");
            woken.recv().expect("it wakes");
            job
        };
        assert_eq!(start().poll(), Some("lost"));
        assert_eq!(start().wait(), Some("lost"));
    }
}
