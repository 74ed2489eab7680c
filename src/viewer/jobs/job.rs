//! Work on a thread of its own, its progress and its result.

use crate::scene::Progress;
use std::{
    sync::{
        Arc,
        mpsc::{Receiver, RecvError, TryRecvError, channel},
    },
    thread,
};

/// Work in the background. Dropping it drops the result and cancels the progress; work that reports none goes on.
pub(super) struct Job<T> {
    pub progress: Arc<Progress>,
    result: Receiver<T>,
}

impl<T: Send + 'static> Job<T> {
    /// Begins; calls `wake` when done.
    pub fn start(
        work: impl FnOnce(&Progress) -> T + Send + 'static,
        wake: impl FnOnce() + Send + 'static,
    ) -> Self {
        let (sender, result) = channel();
        let progress = Arc::new(Progress::default());
        let shared = Arc::clone(&progress);
        thread::spawn(move || {
            // The receiver is gone if nobody wants the result any more.
            let _ = sender.send(work(&shared));
            wake();
        });
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

    /// The result, once it is there; an error if it never will be.
    pub fn poll(&self) -> Option<Result<T, RecvError>> {
        match self.result.try_recv() {
            Ok(result) => Some(Ok(result)),
            Err(TryRecvError::Empty) => None,
            Err(TryRecvError::Disconnected) => Some(Err(RecvError)),
        }
    }

    /// The result, waited for; `None` if it never will be there.
    pub fn wait(&self) -> Option<T> {
        self.result.recv().ok()
    }
}

impl<T> Drop for Job<T> {
    fn drop(&mut self) {
        self.progress.cancel();
    }
}
