//! What is made ready beside the window before it is shown: stages, and scenes on their way into graphics memory.

use super::{
    program::{App, Arrival},
    wake::Wake,
};
use crate::{
    render::GpuError,
    scene::Scene,
    viewer::{
        jobs::{Staging, Upload},
        model::{Action, Stage},
        ui::Underway,
    },
};

/// Of so many objects and triangles a scene is there as soon as a job would have begun.
const LITTLE: usize = 20_000;

impl App {
    /// Begins to make a stage that takes long; it is shown when it is ready. Returns whether that is so.
    pub(super) fn begin_stage(&mut self, stage: Stage) -> bool {
        self.staging = None;
        self.arriving
            .take_if(|(_, what)| matches!(what, Arrival::Stage(_)));
        let (scene, through) = self.state.stage_source();
        let is_there = stage == Stage::World || stage == self.state.stage();
        if is_there || is_little(scene) || self.state.is_prepared(stage) {
            return false;
        }
        let wake = self.wake.clone();
        let wake = move || wake(Wake::Look);
        self.staging = Some(Staging::start(stage, scene.clone(), through, wake));
        true
    }

    /// Takes a stage that is made.
    pub(super) fn take_staged(&mut self) {
        let Some(made) = self.staging.as_ref().and_then(Staging::poll) else {
            return;
        };
        self.staging = None;
        if let Ok(prepared) = made {
            let (stage, scene) = (prepared.stage, prepared.scene.clone());
            self.state.prepare(prepared);
            self.arrive(&scene, Arrival::Stage(stage));
        }
    }

    /// Shows what has come, when its scene is in graphics memory: at once, where that is little or nothing was drawn yet.
    pub(super) fn arrive(&mut self, scene: &Scene, what: Arrival) {
        match &self.gpu {
            Some((gpu, meshes)) if !is_little(scene) => {
                let wake = self.wake.clone();
                let wake = move || wake(Wake::Look);
                let upload = Upload::start(gpu.clone(), scene.clone(), meshes.clone(), wake);
                self.arriving = Some((upload, what));
            }
            _ => self.arrived(what),
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
            Ok(uploaded) => {
                self.uploaded = uploaded;
                self.arrived(what);
            }
            Err(error @ GpuError::SceneTooLarge { .. }) => self.complain(error.to_string()),
            // What else there is to say of the device, the next picture says.
            Err(_) => self.arrived(what),
        }
        self.context.request_repaint();
    }

    fn arrived(&mut self, what: Arrival) {
        match what {
            Arrival::Stage(stage) => self.act(Action::Stage(stage)),
            Arrival::Loaded(loaded, paths, purpose) => {
                match self.show_scene(*loaded, paths, purpose) {
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

fn is_little(scene: &Scene) -> bool {
    scene.objects().len() + scene.triangle_count() < LITTLE
}
