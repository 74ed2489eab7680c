//! What is made ready beside the window before it is shown: stages, and scenes on their way into graphics memory.

use super::{
    program::{App, Arrival},
    wake::Wake,
};
use crate::{
    render::GpuError,
    scene::Scene,
    viewer::{
        jobs::{Making, Staging, Upload},
        model::{Action, Made, Stage},
        ui::Underway,
    },
};

/// Of so many objects and triangles a scene is there as soon as a job would have begun.
const LITTLE: usize = 20_000;

impl App {
    /// Begins to make a stage that takes long; the action that shows it is done when it is ready. Returns whether that is
    /// so.
    pub(super) fn begin_stage(&mut self, stage: Stage, then: Action) -> bool {
        self.staging = None;
        self.arriving
            .take_if(|(_, what)| matches!(what, Arrival::Stage(..)));
        let (scene, through) = self.state.stage_source();
        let is_there = stage == Stage::World || stage == self.state.stage();
        if is_there || size(scene) < LITTLE || self.state.is_prepared(stage) {
            return false;
        }
        let wake = self.wake.clone();
        let wake = move || wake(Wake::Look);
        let staging = Staging::start(stage, scene.clone(), through, wake);
        self.staging = Some((staging, then));
        true
    }

    /// Takes a stage that is made.
    pub(super) fn take_staged(&mut self) {
        let made = self.staging.as_ref();
        let Some((made, then)) = made.and_then(|(job, then)| Some((job.poll()?, *then))) else {
            return;
        };
        self.staging = None;
        if let Ok(prepared) = made {
            let (stage, scene) = (prepared.stage, prepared.scene.clone());
            self.state.prepare(prepared);
            self.arrive(Making::Scene(scene), Arrival::Stage(stage, then));
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
                self.uploaded = uploaded;
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
            // What would lead elsewhere by now is not what was asked for.
            Arrival::Stage(stage, then) if self.state.stage_after(then) != Some(stage) => {}
            Arrival::Stage(_, then) => self.act(then),
            Arrival::Loaded(loaded, paths, purpose) => {
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
        (self.loading, self.staging, self.arriving) = (None, None, None);
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
        let staging = self.staging.as_ref().map(|_| unknown("multiplying"));
        let arriving = self.arriving.as_ref().map(|_| unknown("getting ready"));
        loading.or(staging).or(arriving)
    }
}

fn size(scene: &Scene) -> usize {
    scene.objects().len() + scene.triangle_count()
}
