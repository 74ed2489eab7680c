//! Begins what is drawn next: a picture of the scene, by rays or in pieces, or smooth edges.

use super::{
    brush::Brush,
    by_rays::{self, MUCH},
    finish::Finish,
    scene_picture::{Begun, Picture, ScenePicture, UnderWay},
    wanted::{Drawn, Motion, lines},
};
use crate::{
    camera::Viewport,
    image::{Image, Pixel},
    render::{Drawing, Gpu, GpuError, SMOOTH_SAMPLES, Targets},
    viewer::model::Subject,
};

/// Triangles with their edges take this many times the work of triangles.
const EDGES_COST: u64 = 4;

impl ScenePicture {
    /// Begins what the picture on screen lacks, if anything.
    pub(super) fn begin(
        &mut self,
        brush: &mut Brush,
        subject: &Subject,
        wanted: &Drawn,
        motion: Motion,
    ) -> Result<Begun, GpuError> {
        let shown = (self.shown.as_ref()).filter(|shown| shown.of == *wanted);
        let refines = shown.is_some();
        let is_good = |shown: &Picture| shown.finish.is_exact() || motion != Motion::Rests;
        if shown.is_some_and(is_good) {
            return Ok(Begun::Pieces);
        }
        self.begin_scene(brush, subject, wanted, motion, refines)
    }

    /// Begins a new picture of the scene, or shows it at once if it moves and rays find it in time. `refines`: the
    /// picture on screen shows the same.
    fn begin_scene(
        &mut self,
        brush: &mut Brush,
        subject: &Subject,
        wanted: &Drawn,
        motion: Motion,
        refines: bool,
    ) -> Result<Begun, GpuError> {
        let gpu = brush.gpu;
        let Some(scene) = &self.scenes.now else {
            return Ok(Begun::Pieces);
        };
        let samples = gpu.samples_in_motion();
        let finish = if gpu.is_software() && motion == Motion::Goes {
            Finish::coarse(wanted.view.viewport)
        } else if samples == SMOOTH_SAMPLES {
            Finish::Smooth
        } else {
            Finish::Rough
        };
        let view = finish.drawn(&wanted.view);
        let mut begun = Begun::Pieces;
        if !finish.is_exact()
            && wanted.wireframe().is_none()
            && scene.buffers.whole.work >= MUCH
            && by_rays::can_cast(subject.scene, brush.began)
            && self.patience.tries()
        {
            let pixels = by_rays::cast(subject.scene, &view, brush.began);
            self.patience.came(pixels.is_some());
            if let Some(pixels) = pixels {
                self.show_pixels(brush, subject, wanted, finish, &pixels)?;
                return Ok(Begun::Shown);
            }
            begun = Begun::Late;
        }
        let drawing = Drawing::of_scene(samples, &view, lines(subject));
        let most = self.paces[usize::from(finish.is_exact())].most();
        let mut whole = drawing.whole(&scene.buffers);
        if wanted.wireframe().is_some() {
            whole.work *= EDGES_COST;
        }
        let at_once = most.holds(&whole);
        if at_once {
            // No frame shows the old picture in between.
            self.spare
                .extend(self.shown.take().map(|shown| shown.targets));
        }
        self.next = Some(UnderWay {
            drawing,
            of: *wanted,
            targets: Some(self.targets(gpu, wanted.view.viewport, view.viewport)?),
            at_once,
            finish,
            refines,
        });
        Ok(begun)
    }

    /// Shows a picture by rays.
    fn show_pixels(
        &mut self,
        brush: &mut Brush,
        subject: &Subject,
        wanted: &Drawn,
        finish: Finish,
        pixels: &Image<Pixel>,
    ) -> Result<(), GpuError> {
        let (gpu, view) = (brush.gpu, finish.drawn(&wanted.view));
        let targets = self.targets(gpu, wanted.view.viewport, view.viewport)?;
        let Some(scene) = &self.scenes.now else {
            return Ok(());
        };
        brush.scale_for(finish);
        let onto = (&scene.buffers, &targets, &view);
        (brush.renderer).take_pixels(onto, pixels, &lines(subject))?;
        self.changes += 1;
        let before = self.shown.replace(Picture {
            targets,
            of: *wanted,
            finish,
        });
        self.spare.extend(before.map(|before| before.targets));
        Ok(())
    }

    /// Targets of a size, from the spare ones if possible. If none fit, only spare ones of the window's size are kept.
    fn targets(
        &mut self,
        gpu: &Gpu,
        window: Viewport,
        size: Viewport,
    ) -> Result<Targets, GpuError> {
        let mut spare = self.spare.iter();
        let at = spare.position(|targets| targets.viewport == size);
        let found = at.map(|at| self.spare.swap_remove(at));
        self.spare
            .retain(|targets| targets.viewport == window || found.is_some());
        self.spare.truncate(2);
        found.map_or_else(|| Targets::new(gpu, size, SMOOTH_SAMPLES), Ok)
    }

    /// Begins to draw the picture on screen with smooth edges, if it has none.
    pub(super) fn begin_to_smooth(&mut self, subject: &Subject, wanted: &Drawn) {
        let shown = (self.shown.as_ref())
            .filter(|shown| shown.of == *wanted && shown.finish == Finish::Rough);
        let (Some(_), Some(scene)) = (shown, &self.scenes.now) else {
            return;
        };
        let lines = lines(subject);
        let bare = Drawing::of_smooth_colours(&wanted.view, Vec::new(), 1);
        let mut each = bare.whole(&scene.buffers);
        each.work += lines.len() as u64;
        let bands = self.paces[1].bands(wanted.view.viewport, each);
        self.next = Some(UnderWay {
            drawing: Drawing::of_smooth_colours(&wanted.view, lines, bands),
            of: *wanted,
            targets: None,
            at_once: false,
            finish: Finish::Smooth,
            refines: true,
        });
    }
}
