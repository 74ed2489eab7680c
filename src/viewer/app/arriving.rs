//! What background threads prepare before it is shown: the scene in NDC, and uploads to graphics memory.

use super::{
    errands::{Arrival, Pending, Purpose, finished},
    program::App,
};
use crate::{
    render::GpuError,
    viewer::{
        jobs::{self, Job, Upload},
        model::{LITTLE, Stage},
        ui::{Attempt, Underway},
    },
};

impl App {
    /// Takes a finished projection to NDC and begins the next if one is needed. They run one at a time, so that the
    /// picture follows a camera that never stops.
    pub(super) fn take_projected(&mut self) {
        let done = finished(&mut self.projecting, Job::poll);
        if let Some((_, made)) = done {
            // Work that has failed is begun again at the next event, not at once.
            let Some(made) = made else { return };
            let uploaded = made.uploaded.map(|uploaded| (Some(Stage::Ndc), uploaded));
            self.uploaded.extend(uploaded);
            self.state.take_projected(made.scene, &made.of);
            self.context.request_repaint();
        }
        if self.projecting.is_none()
            && let Some(what) = self.state.to_project()
        {
            self.projecting = Some(jobs::project(what, self.gpu.clone(), self.waker()));
        }
    }

    /// Uploads a loaded scene in the background, then shows it. A small scene is shown at once, and so is any before
    /// the first frame.
    pub(super) fn arrive(&mut self, arrival: Arrival) {
        let making = arrival.making(&self.state);
        match &self.gpu {
            Some((gpu, meshes)) if making.size() >= LITTLE => {
                let upload = Upload::start(gpu.clone(), making, meshes.clone(), self.waker());
                self.arriving = Some((upload, arrival));
            }
            _ => {
                self.ready = Some(arrival);
                self.take_ready();
            }
        }
    }

    /// Takes the outcome of an upload: shows the scene, or says why it does not fit.
    pub(super) fn take_uploaded(&mut self) {
        let done = finished(&mut self.arriving, |(upload, _)| upload.poll());
        let Some(((_, mut arrival), result)) = done else {
            return;
        };
        match result {
            Ok(uploaded) => {
                arrival.uploaded = uploaded;
                self.ready = Some(arrival);
            }
            Err(error @ GpuError::SceneTooLarge { .. }) => {
                self.give_up_change(&arrival.errand);
                self.failed(Attempt::Open, error.to_string());
            }
            // The next frame reports other errors of the device.
            Err(_) => self.ready = Some(arrival),
        }
        self.take_ready();
        self.context.request_repaint();
    }

    /// Shows what has arrived. If that would drop edits that were made while it was loaded, asks first. While a
    /// question waits for an answer, this waits too.
    pub(super) fn take_ready(&mut self) {
        if self.question.is_some() {
            return;
        }
        let Some(arrival) = self.ready.take() else {
            return;
        };
        let errand = &arrival.errand;
        let drops_more = !errand.is_stale(&self.state) && errand.drops_more(&self.state);
        match errand.intent().filter(|_| drops_more) {
            Some(_) if errand.purpose == Purpose::Follow => self.keep_edits(),
            Some(intent) => self.ask(Pending {
                intent,
                arrival: Some(Box::new(arrival)),
            }),
            None => self.show_arrival(arrival),
        }
    }

    /// Shows a loaded scene.
    pub(super) fn show_arrival(&mut self, arrival: Arrival) {
        if arrival.errand.is_stale(&self.state) {
            return;
        }
        let mut uploaded = arrival.uploaded;
        let made = uploaded.as_mut().and_then(|uploaded| uploaded.made.take());
        (self.uploaded).extend(uploaded.map(|uploaded| (None, uploaded)));
        match self.show_scene(*arrival.loaded, arrival.errand, made) {
            Ok(()) => self.build_trees(),
            Err(text) => self.failed(Attempt::Open, text),
        }
    }

    /// Cancels loading and uploading. Returns whether there was anything to cancel.
    pub(super) fn stop_arriving(&mut self) -> bool {
        let loading = self.loading.take().map(|(_, errand)| errand);
        let arriving = self.arriving.take().map(|(_, arrival)| arrival.errand);
        let errands: Vec<_> = loading.into_iter().chain(arriving).collect();
        for errand in &errands {
            self.give_up_change(errand);
        }
        !errands.is_empty()
    }

    /// What is being loaded or uploaded, for the progress message.
    pub(super) fn underway(&self) -> Option<Underway> {
        let loading = self.loading.as_ref();
        let loading = loading.map(|(load, _)| ("loading", Some(load.fraction())));
        let arriving = self.arriving.as_ref();
        let arriving = arriving.map(|(upload, _)| ("getting ready", Some(upload.fraction())));
        loading.or(arriving)
    }

    /// A picture that is late, for the progress message.
    pub(super) fn drawing(&self, now_s: f64) -> Option<Underway> {
        self.rest.is_late(now_s).then_some(("drawing", None))
    }
}
