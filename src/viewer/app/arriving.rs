//! What is made ready beside the window before it is shown: NDC, and scenes on their way into graphics memory.

use super::{
    program::{App, Arrival},
    wake::Wake,
};
use crate::{
    render::GpuError,
    viewer::{
        jobs::{InNdc, LITTLE, Making, Projecting, Upload},
        model::{Made, Stage},
        ui::Underway,
    },
};

impl App {
    /// Begins to project the scene for NDC where that takes long, and takes what is there: one at a time, so that what is
    /// shown follows a camera that goes on and on.
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
            let wake = self.wake.clone();
            self.projecting = Some(Projecting::start(what, self.gpu.clone(), move || {
                wake(Wake::Look);
            }));
        }
    }

    /// Shows what has come, when its scene is in graphics memory: at once, where that is little or nothing was drawn yet.
    pub(super) fn arrive(&mut self, making: Making, what: Arrival) {
        match &self.gpu {
            Some((gpu, meshes)) if making.size() >= LITTLE => {
                let wake = self.wake.clone();
                let wake = move || wake(Wake::Look);
                let upload = Upload::start(gpu.clone(), making, meshes.clone(), wake);
                self.arriving = Some((upload, what));
            }
            _ => self.arrived(what, None),
        }
    }

    /// Takes a scene that is in graphics memory, or does not fit.
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
            // What else there is to say of the device, the next picture says.
            Err(_) => self.arrived(what, None),
        }
        self.context.request_repaint();
    }

    fn arrived(&mut self, what: Arrival, made: Option<Made>) {
        match what {
            Arrival(loaded, paths, purpose) => {
                match self.show_scene(*loaded, paths, purpose, made) {
                    Ok(()) => self.build_trees(),
                    Err(text) => self.complain(text),
                }
            }
        }
    }

    /// Gives up what is on its way. Returns whether there was anything.
    pub(super) fn stop_arriving(&mut self) -> bool {
        let was = self.underway().is_some();
        (self.loading, self.arriving) = (None, None);
        was
    }

    /// What is on its way, to be told.
    pub(super) fn underway(&self) -> Option<Underway> {
        let unknown = |what| Underway {
            what,
            fraction: None,
        };
        let loading = self.loading.as_ref().map(|(load, ..)| Underway {
            what: "loading",
            fraction: Some(load.fraction()),
        });
        let arriving = self.arriving.as_ref().map(|_| unknown("getting ready"));
        loading.or(arriving)
    }
}
