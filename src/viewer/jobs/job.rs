//! Work on a thread of its own, and its result.

use std::{
    sync::mpsc::{Receiver, RecvError, TryRecvError, channel},
    thread,
};

/// Work in the background. Dropping it drops the result, but does not stop the work.
pub(super) struct Job<T>(Receiver<T>);

impl<T: Send + 'static> Job<T> {
    /// Begins; calls `wake` when done.
    pub fn start(
        work: impl FnOnce() -> T + Send + 'static,
        wake: impl FnOnce() + Send + 'static,
    ) -> Self {
        let (sender, result) = channel();
        thread::spawn(move || {
            // The receiver is gone if nobody wants the result any more.
            let _ = sender.send(work());
            wake();
        });
        Self(result)
    }

    /// A job that is done already.
    pub fn done(result: T) -> Self {
        let (sender, receiver) = channel();
        // This cannot fail: the receiver is still here.
        let _ = sender.send(result);
        Self(receiver)
    }

    /// The result, once it is there; an error if it never will be.
    pub fn poll(&self) -> Option<Result<T, RecvError>> {
        match self.0.try_recv() {
            Ok(result) => Some(Ok(result)),
            Err(TryRecvError::Empty) => None,
            Err(TryRecvError::Disconnected) => Some(Err(RecvError)),
        }
    }

    /// The result, waited for; `None` if it never will be there.
    pub fn wait(&self) -> Option<T> {
        self.0.recv().ok()
    }
}
