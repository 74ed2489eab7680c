//! The picture of the scene: what is on screen of it, what is being drawn in pieces to come after that, and when.

use super::{
    pace::Pace,
    wanted::{Drawn, lines},
};
use crate::{
    camera::Viewport,
    image::{Id, Image},
    render::{
        Destination, Drawing, Gpu, GpuError, Marks, MeshStore, Piece, Renderer, SMOOTH_SAMPLES,
        SceneBuffers, Targets, Wireframe,
    },
    scene::{Scene, SceneKey},
    viewer::{
        jobs::Uploaded,
        model::{OnScreen, Overlay, State},
    },
};
use std::{
    mem,
    time::{Duration, Instant},
};

/// No further piece is begun in a pass that has worked for as long as this.
const WORKED: Duration = Duration::from_millis(4);

/// The scene on the GPU, and pictures of it.
pub(super) struct ScenePicture {
    pub renderer: Renderer,
    scene: Option<OnGpu>,
    /// What came ahead of its scene.
    ready: Option<Uploaded>,
    /// The scene before this one, as long as it may come back.
    before: Option<OnGpu>,
    meshes: MeshStore,
    /// The scene that does not fit, and why: it is not tried again.
    unfit: Option<(u64, GpuError)>,
    shown: Option<Picture>,
    next: Option<UnderWay>,
    /// Of the picture before, for the one after the next.
    spare: Option<Targets>,
    pace: Pace,
}

/// A scene on the GPU and which one it is.
struct OnGpu {
    buffers: SceneBuffers,
    key: SceneKey,
    revision: u64,
    visibility: u64,
}

/// A picture that is whole.
struct Picture {
    targets: Targets,
    of: Drawn,
    /// Whether its edges are.
    is_smooth: bool,
}

/// A picture that is not.
struct UnderWay {
    drawing: Drawing,
    of: Drawn,
    /// `None` where only the selection or smooth colours are drawn, onto the picture that is shown.
    targets: Option<Targets>,
    /// Little enough for one pass.
    at_once: bool,
    /// It is the picture that is shown, with smooth edges.
    smooths: bool,
}

/// How far the picture has come in a pass.
#[derive(Clone, Copy, Debug, Default)]
pub(in crate::viewer) struct Progress {
    /// Whether another picture of the scene is shown than before.
    pub anew: bool,
    /// Whether it is not yet the one that is wanted: another pass is needed.
    pub behind: bool,
    /// Whether it is, but for its edges, which are not smooth yet: another pass is needed once it rests.
    pub rough: bool,
}

impl ScenePicture {
    pub fn new(gpu: &Gpu) -> Self {
        Self {
            renderer: Renderer::new(gpu, SMOOTH_SAMPLES),
            scene: None,
            ready: None,
            before: None,
            meshes: MeshStore::default(),
            unfit: None,
            shown: None,
            next: None,
            spare: None,
            pace: Pace::new(gpu),
        }
    }

    /// Takes a scene that is to be shown next.
    pub fn take_uploaded(&mut self, mut uploaded: Uploaded) {
        self.meshes = mem::take(&mut uploaded.meshes);
        self.ready = Some(uploaded);
    }

    /// The meshes on the GPU.
    pub fn meshes(&self) -> &MeshStore {
        &self.meshes
    }

    /// What is on screen.
    pub fn on_screen(&self) -> Option<OnScreen> {
        self.shown.as_ref().map(|shown| shown.of.on_screen())
    }

    /// The ids on screen, when they are those of `wanted`.
    pub fn read_ids(&self, gpu: &Gpu, wanted: &OnScreen) -> Result<Option<Image<Id>>, GpuError> {
        let shown = self.shown.as_ref();
        let shown = shown.filter(|shown| shown.of.on_screen() == *wanted);
        shown.map(|shown| shown.targets.read_ids(gpu)).transpose()
    }

    /// Brings the picture nearer to what the state wants: all the way where that is little, else by a piece. What is begun
    /// is finished first, unless the scene is another by now. A picture `at_rest` gets smooth edges, which nothing waits
    /// for.
    pub fn advance(
        &mut self,
        gpu: &Gpu,
        state: &State,
        viewport: Viewport,
        at_rest: bool,
    ) -> Result<Progress, GpuError> {
        let revision = state.scene_revision();
        if self
            .before
            .take_if(|before| !before.key.is_in_use())
            .is_some()
        {
            self.meshes.forget_dropped();
        }
        let wanted = Drawn::wanted(state, viewport);
        self.next.take_if(|next| {
            let is_of_another = next.of.revision != revision;
            is_of_another || (next.smooths && (next.of != wanted || !at_rest))
        });
        if self.next.is_none() {
            self.upload(gpu, state)?;
            self.begin(gpu, state, &wanted)?;
        }
        if self.next.is_none() && at_rest {
            self.begin_to_smooth(state, &wanted);
        }
        let anew = self.proceed(gpu)?;
        let shown = self.shown.as_ref().filter(|shown| shown.of == wanted);
        let is_whole = shown.is_some() && self.next.as_ref().is_none_or(|next| next.smooths);
        Ok(Progress {
            anew,
            behind: !is_whole,
            rough: is_whole && shown.is_some_and(|shown| !shown.is_smooth),
        })
    }

    /// Begins what the picture on screen lacks, if anything.
    fn begin(&mut self, gpu: &Gpu, state: &State, wanted: &Drawn) -> Result<(), GpuError> {
        let Some(scene) = &self.scene else {
            return Ok(());
        };
        let most = self.pace.most();
        let shown = self.shown.as_mut();
        if let Some(shown) = shown.filter(|shown| shown.of.unmarked() == wanted.unmarked()) {
            let other = wanted.selection.filter(|_| shown.of != *wanted);
            shown.of.selection = wanted.selection.and(shown.of.selection);
            self.next = other.map(|object| {
                let drawing = Drawing::of_selection(&scene.buffers, &wanted.view, object);
                UnderWay {
                    at_once: most.holds(&drawing.whole(&scene.buffers)),
                    drawing,
                    of: *wanted,
                    targets: None,
                    smooths: false,
                }
            });
            return Ok(());
        }
        let overlays = state.overlays();
        self.renderer.wireframe = overlays
            .shows(Overlay::Wireframe)
            .then(|| wanted.selection.map_or(Wireframe::OfAll, Wireframe::Of));
        let samples = gpu.samples_in_motion();
        let viewport = wanted.view.viewport;
        let drawing = Drawing::of_scene(samples, &wanted.view, lines(state, wanted));
        let at_once = most.holds(&drawing.whole(&scene.buffers));
        let fits = |targets: &mut Targets| targets.viewport() == viewport;
        let mut old = self.spare.take();
        if at_once {
            // Nothing is shown between the beginning and the end.
            old = self.shown.take().map(|shown| shown.targets);
        }
        let targets = match old.take_if(fits) {
            Some(targets) => targets,
            None => Targets::new(gpu, viewport, SMOOTH_SAMPLES)?,
        };
        self.next = Some(UnderWay {
            drawing,
            of: *wanted,
            targets: Some(targets),
            at_once,
            smooths: false,
        });
        Ok(())
    }

    /// Begins to draw the picture on screen with smooth edges, where it has none.
    fn begin_to_smooth(&mut self, state: &State, wanted: &Drawn) {
        let shown = (self.shown.as_ref()).filter(|shown| shown.of == *wanted && !shown.is_smooth);
        let (Some(_), Some(scene)) = (shown, &self.scene) else {
            return;
        };
        let lines = lines(state, wanted);
        let bare = Drawing::of_smooth_colours(&wanted.view, Vec::new(), 1);
        let mut each = bare.whole(&scene.buffers);
        each.work += lines.len() as u64;
        let bands = self.pace.bands(wanted.view.viewport, each);
        self.next = Some(UnderWay {
            drawing: Drawing::of_smooth_colours(&wanted.view, lines, bands),
            of: *wanted,
            targets: None,
            at_once: false,
            smooths: true,
        });
    }

    /// Draws on. Returns whether another picture of the scene is shown than before.
    fn proceed(&mut self, gpu: &Gpu) -> Result<bool, GpuError> {
        let (start, mut anew, mut done) = (Instant::now(), false, 0);
        let most = self.pace.most();
        let is_free = self.pace.is_free(gpu);
        let mut smooths = false;
        while let (Some(next), Some(scene)) = (&mut self.next, &self.scene) {
            let piece = if next.at_once {
                Piece::WHOLE
            } else if next.smooths {
                // One a pass: nobody waits for it, and it makes everybody wait.
                if mem::replace(&mut smooths, true) || !is_free {
                    break;
                }
                self.pace.most_smooth()
            } else if is_free && done < most.work && start.elapsed() < WORKED {
                Piece {
                    work: most.work - done,
                    ..most
                }
            } else {
                break;
            };
            let shown = self.shown.as_ref().map(|shown| &shown.targets);
            let Some(targets) = next.targets.as_ref().or(shown) else {
                self.next = None;
                break;
            };
            let before = next.drawing.done();
            let drawing = &mut next.drawing;
            let buffers = &scene.buffers;
            let advanced = self.renderer.advance(gpu, buffers, targets, drawing, piece);
            let is_whole = advanced.inspect_err(|_| self.next = None)?;
            done += self.next.as_ref().map_or(0, |next| next.drawing.done()) - before;
            if is_whole {
                anew |= self.finish(gpu);
            }
        }
        // What smooth pieces take says nothing of others.
        if done > 0 && !smooths {
            self.pace.began(gpu, done);
        }
        Ok(anew)
    }

    /// What was under way is drawn: it is shown, or the selection comes next. Returns whether the scene is shown anew.
    fn finish(&mut self, gpu: &Gpu) -> bool {
        let (Some(mut next), Some(scene)) = (self.next.take(), &self.scene) else {
            return false;
        };
        if let Some(object) = next.of.selection
            && !next.drawing.is_of_selection()
            && !next.smooths
        {
            next.drawing = Drawing::of_selection(&scene.buffers, &next.of.view, object);
            self.next = Some(next);
            return false;
        }
        match (next.targets, &mut self.shown) {
            (Some(targets), shown) => {
                let before = shown.replace(Picture {
                    is_smooth: gpu.samples_in_motion() == SMOOTH_SAMPLES,
                    targets,
                    of: next.of,
                });
                self.spare = before.map(|before| before.targets);
                true
            }
            (None, Some(shown)) => {
                shown.of = next.of;
                shown.is_smooth |= next.smooths;
                false
            }
            (None, None) => false,
        }
    }

    /// Puts the picture on screen with its marks into a destination. Returns whether there is one.
    pub fn composite(&mut self, gpu: &Gpu, state: &State, destination: &Destination<'_>) -> bool {
        let (Some(scene), Some(shown)) = (&self.scene, &self.shown) else {
            return false;
        };
        // Objects of one scene are none of another's.
        let is_of_scene = |of: &u64| *of == scene.revision;
        let hover = Some(state.scene_revision()).filter(is_of_scene);
        let selection = Some(shown.of.revision).filter(is_of_scene);
        self.renderer.composite(
            gpu,
            &scene.buffers,
            &shown.targets,
            &shown.of.view,
            &Marks {
                selection: selection.and(shown.of.selection),
                hover: hover.and(selection).and(state.hover()),
            },
            destination,
        );
        true
    }

    fn upload(&mut self, gpu: &Gpu, state: &State) -> Result<(), GpuError> {
        let (revision, visibility) = (state.scene_revision(), state.visibility_revision());
        match &mut self.scene {
            Some(scene) if scene.revision == revision => {
                if scene.visibility != visibility {
                    scene.buffers.update(gpu, state.scene())?;
                    scene.visibility = visibility;
                    scene.key = state.scene().key();
                }
            }
            _ => {
                if let Some((_, error)) = self.unfit.as_ref().filter(|(of, _)| *of == revision) {
                    return Err(error.clone());
                }
                let buffers = match self.known(state.scene()) {
                    Some(buffers) => Ok(buffers),
                    None => SceneBuffers::upload_beside(gpu, state.scene(), &mut self.meshes),
                };
                let buffers = buffers.inspect_err(|error| {
                    self.unfit = Some((revision, error.clone()));
                })?;
                self.before = self.scene.replace(OnGpu {
                    buffers,
                    key: state.scene().key(),
                    revision,
                    visibility,
                });
            }
        }
        Ok(())
    }

    /// The buffers of a scene that came ahead of it, or stayed from before.
    fn known(&mut self, scene: &Scene) -> Option<SceneBuffers> {
        let ready = self.ready.take().filter(|ready| ready.key.is_of(scene));
        let before = self.before.take_if(|before| before.key.is_of(scene));
        ready
            .map(|ready| ready.buffers)
            .or(before.map(|before| before.buffers))
    }
}
