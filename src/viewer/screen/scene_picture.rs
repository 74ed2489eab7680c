//! The picture of the scene: what is on screen of it, what is being drawn in pieces to come after that, and when.

use super::{frozen, overlay_lines, pace::Pace, surroundings};
use crate::{
    camera::{UpAxis, View, Viewport},
    image::{Id, Image},
    render::{
        Destination, Drawing, Gpu, GpuError, Line, Marks, MeshStore, Piece, Renderer, SceneBuffers,
        Targets, Wireframe,
    },
    scene::{Scene, SceneKey},
    viewer::{
        jobs::Uploaded,
        model::{Frozen, OnScreen, Overlay, Overlays, State},
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
}

/// A picture that is not.
struct UnderWay {
    drawing: Drawing,
    of: Drawn,
    /// `None` where only the selection is drawn, onto the picture that is shown.
    targets: Option<Targets>,
    /// Little enough for one pass.
    at_once: bool,
}

/// All that colours and ids depend on, and then the selection, on which its outline depends.
#[derive(Clone, Copy, PartialEq)]
struct Drawn {
    view: View,
    revision: u64,
    visibility: u64,
    grid: Option<UpAxis>,
    frozen: Option<Frozen>,
    /// What is drawn with the scene, about which object, and whether the trees that it may show are there.
    overlays: Option<(Overlays, Option<usize>, bool)>,
    selection: Option<usize>,
}

impl Drawn {
    /// The picture that a state is to have.
    fn wanted(state: &State, viewport: Viewport) -> Self {
        let selection = state.selection().map(|selection| selection.object);
        let overlays = state.overlays();
        Self {
            overlays: (overlays.in_scene())
                .then(|| (overlays, selection, state.scene().trees_are_built())),
            view: View {
                viewport,
                ..*state.view()
            },
            revision: state.scene_revision(),
            visibility: state.visibility_revision(),
            grid: state.grid().then_some(state.shown_up_axis()),
            frozen: state.frozen().copied(),
            selection,
        }
    }

    /// Without what is drawn over colours and ids.
    fn unmarked(self) -> Self {
        Self {
            selection: None,
            ..self
        }
    }

    fn on_screen(&self) -> OnScreen {
        OnScreen {
            view: self.view,
            scene_revision: self.revision,
            visibility_revision: self.visibility,
        }
    }
}

/// How far the picture has come in a pass.
#[derive(Clone, Copy, Debug, Default)]
pub(in crate::viewer) struct Progress {
    /// Whether another picture of the scene is shown than before.
    pub anew: bool,
    /// Whether it is not yet the one that is wanted: another pass is needed.
    pub behind: bool,
}

impl ScenePicture {
    pub fn new(gpu: &Gpu) -> Self {
        Self {
            renderer: Renderer::new(gpu, gpu.colour_samples()),
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
    /// is finished first, unless the scene is another by now.
    pub fn advance(
        &mut self,
        gpu: &Gpu,
        state: &State,
        viewport: Viewport,
    ) -> Result<Progress, GpuError> {
        let revision = state.scene_revision();
        if self
            .before
            .take_if(|before| !before.key.is_in_use())
            .is_some()
        {
            self.meshes.forget_dropped();
        }
        self.next.take_if(|next| next.of.revision != revision);
        if self.next.is_none() {
            self.upload(gpu, state)?;
            self.begin(gpu, state, viewport)?;
        }
        let anew = self.proceed(gpu)?;
        let shown = self.shown.as_ref().map(|shown| shown.of);
        Ok(Progress {
            anew,
            behind: self.next.is_some() || shown != Some(Drawn::wanted(state, viewport)),
        })
    }

    /// Begins what the picture on screen lacks, if anything.
    fn begin(&mut self, gpu: &Gpu, state: &State, viewport: Viewport) -> Result<(), GpuError> {
        let Some(scene) = &self.scene else {
            return Ok(());
        };
        let wanted = Drawn::wanted(state, viewport);
        let most = self.pace.most();
        let shown = self.shown.as_mut();
        if let Some(shown) = shown.filter(|shown| shown.of.unmarked() == wanted.unmarked()) {
            let other = wanted.selection.filter(|_| shown.of != wanted);
            shown.of.selection = wanted.selection.and(shown.of.selection);
            self.next = other.map(|object| {
                let drawing = Drawing::of_selection(&scene.buffers, &wanted.view, object);
                UnderWay {
                    at_once: most.holds(&drawing.whole(&scene.buffers)),
                    drawing,
                    of: wanted,
                    targets: None,
                }
            });
            return Ok(());
        }
        let overlays = state.overlays();
        self.renderer.wireframe = overlays
            .shows(Overlay::Wireframe)
            .then(|| wanted.selection.map_or(Wireframe::OfAll, Wireframe::Of));
        let samples = gpu.colour_samples();
        let drawing = Drawing::of_scene(samples, &wanted.view, lines(state, &wanted));
        let at_once = most.holds(&drawing.whole(&scene.buffers));
        let fits = |targets: &mut Targets| targets.viewport() == viewport;
        let mut old = self.spare.take();
        if at_once {
            // Nothing is shown between the beginning and the end.
            old = self.shown.take().map(|shown| shown.targets);
        }
        let targets = match old.take_if(fits) {
            Some(targets) => targets,
            None => Targets::new(gpu, viewport, samples)?,
        };
        self.next = Some(UnderWay {
            drawing,
            of: wanted,
            targets: Some(targets),
            at_once,
        });
        Ok(())
    }

    /// Draws on. Returns whether another picture of the scene is shown than before.
    fn proceed(&mut self, gpu: &Gpu) -> Result<bool, GpuError> {
        let (start, mut anew, mut done) = (Instant::now(), false, 0);
        let most = self.pace.most();
        let is_free = self.pace.is_free(gpu);
        while let (Some(next), Some(scene)) = (&mut self.next, &self.scene) {
            let piece = if next.at_once {
                Piece::WHOLE
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
                anew |= self.finish();
            }
        }
        if done > 0 {
            self.pace.began(gpu, done);
        }
        Ok(anew)
    }

    /// What was under way is drawn: it is shown, or the selection comes next. Returns whether the scene is shown anew.
    fn finish(&mut self) -> bool {
        let (Some(mut next), Some(scene)) = (self.next.take(), &self.scene) else {
            return false;
        };
        if let Some(object) = next.of.selection
            && !next.drawing.is_of_selection()
        {
            next.drawing = Drawing::of_selection(&scene.buffers, &next.of.view, object);
            self.next = Some(next);
            return false;
        }
        match (next.targets, &mut self.shown) {
            (Some(targets), shown) => {
                let before = shown.replace(Picture {
                    targets,
                    of: next.of,
                });
                self.spare = before.map(|before| before.targets);
                true
            }
            (None, Some(shown)) => {
                shown.of = next.of;
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

/// The lines that are drawn with a scene.
fn lines(state: &State, wanted: &Drawn) -> Vec<Line> {
    let scene = state.scene();
    let floor = |up_axis| surroundings::floor(&scene.visible_bounds(), up_axis);
    let floor = wanted.grid.map(floor);
    let frozen = wanted.frozen.map(|frozen| frozen::lines(&frozen, scene));
    let stage = surroundings::of(state.stage());
    let all = floor.into_iter().chain(frozen);
    all.chain([stage, overlay_lines::lines(state)])
        .flatten()
        .collect()
}
