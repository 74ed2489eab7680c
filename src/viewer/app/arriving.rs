//! What is prepared before it is shown: the scene in NDC.

use super::program::App;
use crate::viewer::jobs::{self, Job, finished};

impl App {
    /// Takes a finished projection to NDC and begins the next if one is needed. They run one at a time, so that the
    /// picture follows a camera that never stops.
    pub(super) fn take_projected(&mut self) {
        let done = finished(&mut self.projecting, Job::poll);
        if let Some((_, made)) = done {
            // Work that has failed is begun again at the next event, not at once.
            let Some((scene, of)) = made else { return };
            self.state.take_projected(scene, &of);
            self.context.request_repaint();
        }
        if self.projecting.is_none()
            && let Some(what) = self.state.to_project()
        {
            self.projecting = Some(jobs::project(what, self.waker()));
        }
    }
}
