//! What background threads prepare before it is shown: the scene in NDC, and uploads to graphics memory.

use super::program::{App, Arrival};
use crate::{
    render::GpuError,
    viewer::{
        jobs::{InNdc, LITTLE, Making, Projecting, Upload},
        model::{Made, Stage},
        ui::Underway,
    },
};

impl App {
    /// Takes a finished projection to NDC and begins the next if one is needed. They run one at a time, so that the
    /// picture follows a camera that never stops.
    pub(super) fn take_projected(&mut self) {
        if let Some(made) = self.projecting.as_ref().and_then(Projecting::poll) {
            self.projecting = None;
            if let Ok(InNdc {
                scene,
                of,
                uploaded,
            }) = made
            {
                (self.uploaded).extend(uploaded.map(|uploaded| (Some(Stage::Ndc), uploaded)));
                self.state.take_projected(scene, &of);
                self.context.request_repaint();
            }
        }
        if self.projecting.is_none()
            && let Some(what) = self.state.to_project()
        {
            self.projecting = Some(Projecting::start(what, self.gpu.clone(), self.waker()));
        }
    }

    /// Uploads a loaded scene in the background, then shows it. A small scene is shown at once, and so is any before
    /// the first frame.
    pub(super) fn arrive(&mut self, making: Making, what: Arrival) {
        match &self.gpu {
            Some((gpu, meshes)) if making.size() >= LITTLE => {
                let upload = Upload::start(gpu.clone(), making, meshes.clone(), self.waker());
                self.arriving = Some((upload, what));
            }
            _ => self.arrived(what, None),
        }
    }

    /// Takes the outcome of an upload: shows the scene, or says why it does not fit.
    pub(super) fn take_uploaded(&mut self) {
        let Some(result) = self.arriving.as_ref().and_then(|(upload, _)| upload.poll()) else {
            return;
        };
        let Some((_, what)) = self.arriving.take() else {
            return;
        };
        match result {
            Ok(mut uploaded) => {
                let made = uploaded.as_mut().and_then(|uploaded| uploaded.made.take());
                (self.uploaded).extend(uploaded.map(|uploaded| (None, uploaded)));
                self.arrived(what, made);
            }
            Err(error @ GpuError::SceneTooLarge { .. }) => self.complain(error.to_string()),
            // The next frame reports other errors of the device.
            Err(_) => self.arrived(what, None),
        }
        self.context.request_repaint();
    }

    fn arrived(&mut self, Arrival(loaded, paths, purpose): Arrival, made: Option<Made>) {
        match self.show_scene(*loaded, paths, purpose, made) {
            Ok(()) => self.build_trees(),
            Err(text) => self.complain(text),
        }
    }

    /// Cancels loading and uploading. Returns whether there was anything to cancel.
    pub(super) fn stop_arriving(&mut self) -> bool {
        let was = self.underway().is_some();
        (self.loading, self.arriving) = (None, None);
        was
    }

    /// What is being loaded or uploaded, for the progress message.
    pub(super) fn underway(&self) -> Option<Underway> {
        let loading = self.loading.as_ref().map(|(load, ..)| Underway {
            what: "loading",
            fraction: Some(load.fraction()),
        });
        let arriving = self.arriving.as_ref().map(|_| Underway {
            what: "getting ready",
            fraction: None,
        });
        loading.or(arriving)
    }
}
