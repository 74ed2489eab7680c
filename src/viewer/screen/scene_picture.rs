//! The picture of the scene: the one on screen, and the next one, which is drawn in pieces.

use super::{
    brush::Brush,
    by_rays::Patience,
    finish::Finish,
    pace::Pace,
    picture_progress::PictureProgress,
    place::SceneRect,
    scenes_on_gpu::ScenesOnGpu,
    wanted::{Drawn, Motion},
};
use crate::{
    image::{Id, Image},
    render::{Destination, Drawing, Gpu, GpuError, Marks, Piece, Targets},
    viewer::model::{OnScreen, Subject},
};
use std::{
    mem,
    time::{Duration, Instant},
};

/// A pass that has worked for this long begins no further piece.
const WORKED: Duration = Duration::from_millis(4);
/// How soon a busy adapter is polled again. To poll at once would only keep a processor busy.
const WAIT: Duration = Duration::from_millis(4);

/// A scene on the GPU, and pictures of it.
pub(super) struct ScenePicture {
    pub scenes: ScenesOnGpu,
    pub(super) shown: Option<Picture>,
    pub(super) next: Option<UnderWay>,
    /// Targets of earlier pictures, to be used again.
    pub(super) spare: Vec<Targets>,
    /// One pace for coarse pictures, and one for others.
    pub(super) paces: [Pace; 2],
    /// Decides when a moving picture's rays are tried.
    pub(super) patience: Patience,
    /// Counts the changes of what is shown.
    pub(super) changes: u64,
    /// The object that is outlined, and since which change.
    outlined: Option<(usize, u64)>,
}

/// What was begun in a pass.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Begun {
    /// Nothing, or what is drawn in pieces.
    Pieces,
    /// What is drawn in pieces, since rays were late.
    Late,
    /// A picture by rays, which is shown already.
    Shown,
}

/// A finished picture.
pub(super) struct Picture {
    pub targets: Targets,
    pub of: Drawn,
    pub finish: Finish,
}

/// What a scene's picture looks like: two pictures with equal looks are the same to the eye.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Look {
    change: u64,
    marks: Marks,
}

/// An unfinished picture.
pub(super) struct UnderWay {
    pub drawing: Drawing,
    pub of: Drawn,
    /// `None` where only smooth colours are drawn, onto the picture that is shown.
    pub targets: Option<Targets>,
    /// Small enough for one pass.
    pub at_once: bool,
    pub finish: Finish,
    /// It only improves the picture that is shown, so nobody waits for it.
    pub refines: bool,
}

impl ScenePicture {
    pub fn new(gpu: &Gpu) -> Self {
        Self {
            scenes: ScenesOnGpu::default(),
            shown: None,
            next: None,
            spare: Vec::new(),
            paces: [Pace::new(gpu), Pace::new(gpu)],
            patience: Patience::default(),
            changes: 0,
            outlined: None,
        }
    }

    /// The ids on screen, when they are those of `wanted`.
    pub fn read_ids(&self, gpu: &Gpu, wanted: &OnScreen) -> Result<Option<Image<Id>>, GpuError> {
        let shown = self.shown.as_ref();
        let is_exact =
            |shown: &&Picture| shown.finish.is_exact() && shown.of.on_screen() == *wanted;
        let shown = shown.filter(is_exact);
        shown.map(|shown| shown.targets.read_ids(gpu)).transpose()
    }

    /// Brings the picture nearer to what the state wants: all the way if that is little work, else by a piece. A
    /// picture that was begun is finished first, unless it is of another scene, too slow for a moving picture, or only
    /// an improvement that is not wanted now. A moving picture may be coarse. At rest it gets exact, and then its edges
    /// get smooth; nobody waits for either.
    pub fn advance(
        &mut self,
        brush: &mut Brush,
        subject: &Subject,
        motion: Motion,
    ) -> Result<PictureProgress, GpuError> {
        let (gpu, revision) = (brush.gpu, subject.revision);
        self.scenes.forget_unused();
        let wanted = Drawn::wanted(subject);
        let unwanted = self.next.take_if(|next| {
            let is_of_another = next.of.revision != revision;
            let moves = motion != Motion::Rests;
            // A software adapter begins a moving picture anew, coarse and maybe by rays: an exact one could take
            // seconds.
            let is_slow = gpu.is_software()
                && motion == Motion::Goes
                && next.finish.is_exact()
                && (next.targets.is_some() || next.of != wanted);
            is_of_another || is_slow || (next.refines && (next.of != wanted || moves))
        });
        self.spare.extend(unwanted.and_then(|next| next.targets));
        if motion == Motion::Rests {
            self.patience.rest();
        }
        let mut begun = Begun::Pieces;
        if self.next.is_none() {
            self.scenes.upload(gpu, subject)?;
            begun = self.begin(brush, subject, &wanted, motion)?;
        }
        if self.next.is_none() && motion == Motion::Rests {
            self.begin_to_smooth(subject, &wanted);
        }
        let is_at_once = self.next.as_ref().is_some_and(|next| next.at_once);
        let ([anew, waits], drawn) = if begun == Begun::Late && !is_at_once {
            // Waiting for late rays has used up the time of this pass.
            Default::default()
        } else {
            self.proceed(brush)?
        };
        let shown = self.shown.as_ref().filter(|shown| shown.of == wanted);
        let is_whole = shown.is_some() && self.next.as_ref().is_none_or(|next| next.refines);
        Ok(PictureProgress {
            anew: anew || begun == Begun::Shown,
            behind: (!is_whole).then_some(if waits { WAIT } else { Duration::ZERO }),
            rough: is_whole && shown.is_some_and(|shown| shown.finish < Finish::Smooth),
            drawn,
        })
    }

    /// Draws the next pieces. Returns whether a new picture of the scene is shown, whether the picture waits for a busy
    /// adapter, and how much was drawn.
    fn proceed(&mut self, brush: &mut Brush) -> Result<([bool; 2], u64), GpuError> {
        let gpu = brush.gpu;
        let (start, mut anew, mut done) = (Instant::now(), false, 0);
        let is_free = self.paces.iter_mut().all(|pace| pace.is_free(gpu));
        let finish = self.next.as_ref().map(|next| next.finish);
        let of = usize::from(finish >= Some(Finish::Rough));
        let (most, most_smooth) = (self.paces[of].most(), self.paces[of].most_smooth());
        let mut smooths = false;
        while let (Some(next), Some(scene)) = (&mut self.next, &self.scenes.now) {
            let is_smooth = next.refines && next.finish == Finish::Smooth;
            let piece = if next.at_once {
                Piece::WHOLE
            } else if is_smooth {
                // One such piece a pass: nobody waits for it, but it delays everything else.
                if mem::replace(&mut smooths, true) || !is_free {
                    break;
                }
                most_smooth
            } else if is_free && done < most.work && start.elapsed() < WORKED {
                Piece::of_work(most.work - done)
            } else {
                break;
            };
            let shown = self.shown.as_ref().map(|shown| &shown.targets);
            let Some(targets) = next.targets.as_ref().or(shown) else {
                self.next = None;
                break;
            };
            let before = next.drawing.done;
            let (buffers, drawing) = (&scene.buffers, &mut next.drawing);
            brush.renderer.wireframe = next.of.wireframe();
            brush.scale_for(next.finish);
            let advanced = brush.renderer.advance(buffers, targets, drawing, piece);
            let is_whole = advanced.inspect_err(|_| self.next = None)?;
            let progress = self.next.as_ref().map_or(0, |next| next.drawing.done) - before;
            done += progress;
            if is_whole {
                anew |= self.finish();
            } else if progress == 0 && piece != Piece::WHOLE {
                // A background thread still composes the rows to be drawn.
                break;
            }
        }
        // The time of smooth pieces says nothing about others.
        if done > 0 && !smooths {
            self.paces[of].began(gpu, done);
        }
        Ok(([anew, !is_free && self.next.is_some()], done))
    }

    /// Ends what was under way: shows it. Returns whether a new picture of the scene is shown.
    fn finish(&mut self) -> bool {
        let Some(next) = self.next.take() else {
            return false;
        };
        self.changes += 1;
        match (next.targets, &mut self.shown) {
            (Some(targets), shown) => {
                let before = shown.replace(Picture {
                    targets,
                    of: next.of,
                    finish: next.finish,
                });
                self.spare.extend(before.map(|before| before.targets));
                true
            }
            (None, Some(shown)) => {
                shown.of = next.of;
                shown.finish = next.finish;
                false
            }
            (None, None) => false,
        }
    }

    /// The picture's look; `None` if there is no picture. The camera's picture does not stand in for a stage of the
    /// same scene, nor the reverse.
    pub fn look(&self, subject: &Subject) -> Option<Look> {
        let is_alike = |shown: &&Picture| shown.of.is_of_stage() == subject.lesson.is_some();
        let shown = self.shown.as_ref().filter(is_alike)?;
        let scene = self.scenes.now.as_ref()?;
        // An object's index holds in its own scene only.
        let is_of_scene = |of: &u64| *of == scene.revision;
        let is_marked = [subject.revision, shown.of.revision]
            .iter()
            .all(is_of_scene);
        Some(Look {
            change: self.changes,
            marks: Marks {
                selection: subject.selection.filter(|_| is_marked),
                hover: subject.hover.filter(|_| is_marked),
            },
        })
    }

    /// Draws the picture into its place on a page.
    pub fn composite(
        &mut self,
        brush: &mut Brush,
        look: &Look,
        page: &wgpu::Texture,
        place: SceneRect,
    ) -> Result<(), GpuError> {
        let (Some(scene), Some(shown)) = (&self.scenes.now, &self.shown) else {
            return Ok(());
        };
        let destination = Destination {
            texture: page,
            origin_px: place.origin_px,
            room_px: [place.viewport.width(), place.viewport.height()],
            coarseness: shown.finish.coarseness(),
        };
        let view = shown.finish.drawn(&shown.of.view);
        let onto = (&scene.buffers, &shown.targets, &view);
        brush.scale_for(shown.finish);
        let outlined = look.marks.selection.map(|object| (object, look.change));
        if let (Some((object, _)), true) = (outlined, self.outlined != outlined) {
            brush.renderer.draw_outline(onto, object);
        }
        self.outlined = outlined;
        (brush.renderer).composite(onto, &look.marks, &destination)
    }
}
