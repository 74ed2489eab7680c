//! The picture of a scene: drawn whole, and only when what it shows has changed.

use super::{
    scenes_on_gpu::ScenesOnGpu,
    wanted::{Drawn, lines},
};
use crate::{
    camera::{View, Viewport},
    image::{Id, Image, Pixel},
    look::Background,
    pick::{raycast_ndc_until, raycast_until},
    render::{Gpu, GpuError, Marks, MeshStore, Renderer, SMOOTH_SAMPLES, Targets},
    viewer::model::{OnScreen, Subject},
};
use egui::TextureId;
use std::{
    collections::BTreeSet,
    sync::Arc,
    time::{Duration, Instant},
};

/// A software adapter smooths a picture at rest if the last one of one sample was drawn within this time.
const QUICK: Duration = Duration::from_millis(100);
/// Pixels of the window, along each side, that a ray of a moving picture stands for.
const COARSENESS: u32 = 3;
/// How long the rays of a picture may take, for each of them. On two cores most take a quarter of this.
const RAY_TAKES: Duration = Duration::from_micros(2);
/// The longest that the rays of a picture may take.
const LONGEST: Duration = Duration::from_secs(2);
/// After rays that were late, this many pictures are drawn before rays are tried again.
const DRAWN_AFTER_LATE: u32 = 30;
/// What an object costs besides its triangles, in triangles.
const OBJECT: usize = 32;

/// What pictures are drawn with.
pub(super) struct Brush {
    pub gpu: Gpu,
    pub renderer: Renderer,
    /// Paints the panels, and the pictures among them.
    pub panels: egui_wgpu::Renderer,
    pub meshes: MeshStore,
}

/// A scene on the GPU, and the picture of it.
#[derive(Default)]
pub(super) struct ScenePicture {
    scenes: ScenesOnGpu,
    targets: Option<Targets>,
    /// The picture's name among egui's textures.
    texture: Option<TextureId>,
    /// What the targets show.
    held: Option<Held>,
    /// What is marked on the picture.
    marked: Option<Marked>,
    /// The scene that was drawn with one sample last, and how long that took. The first picture of a scene says nothing:
    /// it waits for uploads and shaders.
    took: Option<(u64, Option<Duration>)>,
    /// Pictures that are drawn before rays are tried again.
    to_draw: u32,
}

/// What the texture holds, and how well it shows it.
struct Held {
    of: Drawn,
    finish: Finish,
    is_by_rays: bool,
}

/// What is selected and lit in a picture, and outlined.
struct Marked {
    first: Option<usize>,
    others: Option<Arc<BTreeSet<usize>>>,
    hover: Option<usize>,
}

/// How good a picture is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Finish {
    /// One ray for several pixels.
    Coarse,
    /// Each pixel by its centre.
    Fine,
    /// The edges are smooth, too.
    Smooth,
}

/// What an update of a picture did.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(in crate::viewer) struct Updated {
    /// Whether a scene was drawn anew.
    pub anew: bool,
    /// Whether another update, at rest, would improve the picture.
    pub rough: bool,
}

impl ScenePicture {
    /// Brings the picture up to date: draws the scene if what it shows has changed, or if the picture rests and can be
    /// better; then marks what is selected and lit. While it `moves` it may be coarse.
    pub fn update(
        &mut self,
        brush: &mut Brush,
        subject: &Subject,
        moves: bool,
    ) -> Result<Updated, GpuError> {
        let wanted = Drawn::wanted(subject, &brush.renderer);
        let finish = self.finish(brush, subject, &wanted, moves);
        let held = self.held.as_ref().filter(|held| held.of == wanted);
        let anew = held.is_none_or(|held| held.finish < finish);
        if anew {
            self.draw(brush, subject, &wanted, finish)?;
        }
        self.mark(brush, subject);
        let best = self.finish(brush, subject, &wanted, false);
        let rough = self.held.as_ref().is_some_and(|held| held.finish < best);
        Ok(Updated { anew, rough })
    }

    /// The picture's name among egui's textures, once there was one.
    pub fn name(&self) -> Option<TextureId> {
        self.texture
    }

    /// The same, if the picture has this size.
    pub fn texture(&self, size: Viewport) -> Option<TextureId> {
        let fits = |targets: &Targets| targets.viewport == size;
        let is_shown = self.held.is_some() && self.targets.as_ref().is_some_and(fits);
        self.texture.filter(|_| is_shown)
    }

    /// What it shows.
    pub fn on_screen(&self) -> Option<OnScreen> {
        self.held.as_ref().map(|held| held.of.on_screen())
    }

    /// The ids as they are drawn. Where the picture on screen was not drawn, but found by rays, it is drawn.
    pub fn drawn_ids(
        &mut self,
        brush: &mut Brush,
        subject: &Subject,
    ) -> Result<Option<Image<Id>>, GpuError> {
        let wanted = Drawn::wanted(subject, &brush.renderer);
        let is_drawn = |held: &Held| held.of == wanted && !held.is_by_rays;
        if !self.held.as_ref().is_some_and(is_drawn) {
            self.to_draw = self.to_draw.max(1);
            self.draw(brush, subject, &wanted, Finish::Fine)?;
        }
        let targets = self.targets.as_ref();
        targets
            .map(|targets| targets.read_ids(&brush.gpu))
            .transpose()
    }

    /// How good the picture is to be.
    fn finish(&self, brush: &Brush, subject: &Subject, wanted: &Drawn, moves: bool) -> Finish {
        let took = self.took.filter(|(of, _)| *of == subject.revision);
        let is_quick = took
            .and_then(|(_, took)| took)
            .is_none_or(|took| took < QUICK);
        let is_little = !is_much(subject, &subject.view);
        if !brush.gpu.is_software() || (!moves && is_little && is_quick) {
            Finish::Smooth
        } else if moves && self.casts(subject, wanted, &coarse(&subject.view)) {
            Finish::Coarse
        } else {
            Finish::Fine
        }
    }

    /// Whether a software adapter's picture is found by rays through a view. They need trees, and see no edges of
    /// triangles.
    fn casts(&self, subject: &Subject, wanted: &Drawn, through: &View) -> bool {
        let sees_all = wanted.wireframe().is_none();
        let is_ready = sees_all && subject.scene.trees_are_built();
        self.to_draw == 0 && is_ready && is_much(subject, through)
    }

    fn draw(
        &mut self,
        brush: &mut Brush,
        subject: &Subject,
        wanted: &Drawn,
        finish: Finish,
    ) -> Result<(), GpuError> {
        let (view, lines) = (&wanted.view, lines(subject));
        if self.scenes.forget_unused() {
            brush.meshes.forget_dropped();
        }
        // A scene that does not fit leaves the picture before it on screen.
        self.scenes.upload(&brush.gpu, subject, &mut brush.meshes)?;
        let before = self.held.take();
        self.marked = None;
        self.fit(brush, view.viewport)?;
        let (Some(scene), Some(targets)) = (&self.scenes.now, &self.targets) else {
            return Ok(());
        };
        let onto = (&scene.buffers, targets, view);
        let through = match finish {
            Finish::Coarse => coarse(view),
            Finish::Fine | Finish::Smooth => *view,
        };
        let is_software = brush.gpu.is_software();
        let mut by_rays = None;
        if is_software && finish < Finish::Smooth && self.casts(subject, wanted, &through) {
            by_rays = cast(subject, &through, wanted.background);
            if by_rays.is_none() {
                self.to_draw = DRAWN_AFTER_LATE;
            }
        }
        brush.renderer.wireframe = wanted.wireframe();
        if let Some(pixels) = &by_rays {
            let pixels = enlarged(pixels, view.viewport);
            brush.renderer.take_pixels(onto, &pixels, &lines)?;
        } else if finish == Finish::Smooth {
            let has_ids = |held: Held| held.of == *wanted && held.finish == Finish::Fine;
            if before.is_some_and(has_ids) {
                brush.renderer.draw_colours(onto, &lines)?;
            } else {
                brush.renderer.draw(onto, &lines)?;
            }
        } else {
            let began = Instant::now();
            brush.renderer.draw_rough(onto, &lines)?;
            if is_software {
                brush.gpu.wait()?;
            }
            let again = self.took.filter(|(of, _)| *of == subject.revision);
            self.took = Some((subject.revision, again.map(|_| began.elapsed())));
            self.to_draw = self.to_draw.saturating_sub(1);
        }
        self.held = Some(Held {
            of: *wanted,
            // Pictures that are drawn are never coarse.
            finish: match by_rays {
                Some(_) => finish,
                None => finish.max(Finish::Fine),
            },
            is_by_rays: by_rays.is_some(),
        });
        Ok(())
    }

    /// Makes targets of a size, unless there are.
    fn fit(&mut self, brush: &mut Brush, size: Viewport) -> Result<(), GpuError> {
        if self
            .targets
            .as_ref()
            .is_some_and(|targets| targets.viewport == size)
        {
            return Ok(());
        }
        let targets = Targets::new(&brush.gpu, size, SMOOTH_SAMPLES)?;
        let (device, nearest) = (&brush.gpu.device, wgpu::FilterMode::Nearest);
        let (panels, shown) = (&mut brush.panels, &targets.shown_view);
        match self.texture {
            Some(id) => panels.update_egui_texture_from_wgpu_texture(device, shown, nearest, id),
            None => self.texture = Some(panels.register_native_texture(device, shown, nearest)),
        }
        self.targets = Some(targets);
        Ok(())
    }

    /// Marks what is selected and lit, unless it is marked already.
    fn mark(&mut self, brush: &mut Brush, subject: &Subject) {
        let (Some(scene), Some(targets)) = (&self.scenes.now, &self.targets) else {
            return;
        };
        let wanted = Marked {
            first: subject.selection,
            others: subject.others.cloned(),
            hover: subject.hover,
        };
        let marked = self.marked.as_ref();
        let is_outlined = marked.is_some_and(|marked| marked.selects_as(&wanted));
        if is_outlined && marked.is_some_and(|marked| marked.hover == wanted.hover) {
            return;
        }
        let onto = (&scene.buffers, targets, &subject.view);
        let marks = Marks {
            selection: subject.all_selected(),
            hover: subject.hover,
        };
        if !is_outlined && !marks.selection.is_empty() {
            brush.renderer.draw_outline(onto, &marks.selection);
        }
        brush.renderer.mark(onto, &marks);
        self.marked = Some(wanted);
    }
}

impl Marked {
    /// Whether another one marks the same selection. It looks at no list: there may be very many.
    fn selects_as(&self, other: &Self) -> bool {
        let is_same = match (&self.others, &other.others) {
            (Some(a), Some(b)) => Arc::ptr_eq(a, b),
            (a, b) => a.is_none() && b.is_none(),
        };
        self.first == other.first && is_same
    }
}

/// Whether a scene has more triangles than a view has pixels. A software adapter takes about as long for a triangle as
/// for a ray.
fn is_much(subject: &Subject, through: &View) -> bool {
    let scene = subject.scene;
    scene.triangle_count() + OBJECT * scene.objects().len() > pixels(through)
}

fn pixels(view: &View) -> usize {
    view.viewport.width() as usize * view.viewport.height() as usize
}

/// The view of a coarse picture.
fn coarse(view: &View) -> View {
    let of = |side: u32| side.div_ceil(COARSENESS);
    let size = Viewport::new(of(view.viewport.width()), of(view.viewport.height()));
    View {
        viewport: size.unwrap_or(view.viewport),
        ..*view
    }
}

/// A picture by rays; `None` if they are late, as where each of them meets thousands of objects.
fn cast(subject: &Subject, through: &View, background: Background) -> Option<Image<Pixel>> {
    let rays = u32::try_from(pixels(through)).unwrap_or(u32::MAX);
    let most = (RAY_TAKES * rays).min(LONGEST);
    let deadline = Instant::now() + most;
    match subject.ndc() {
        Some(ndc) => raycast_ndc_until(subject.scene, &ndc, through, background, deadline),
        None => raycast_until(subject.scene, through, background, deadline),
    }
}

/// A picture in which each pixel of another stands for several, up to this size.
fn enlarged(pixels: &Image<Pixel>, size: Viewport) -> Image<Pixel> {
    let times = if pixels.size() == size { 1 } else { COARSENESS };
    let row = |y| (0..size.width()).map(move |x| pixels.at(x / times, y / times));
    Image::new(size, (0..size.height()).flat_map(row).collect())
}

#[cfg(test)]
mod tests {
    use super::{COARSENESS, enlarged};
    use crate::{
        camera::Viewport,
        image::{Id, Image, Pixel},
    };

    /// Pictures of any size are covered by whole pixels of a coarse one, also those that are narrower than these.
    #[test]
    fn a_coarse_picture_covers_one_of_any_size() {
        for (width, height) in (1..12).flat_map(|w| (1..12).map(move |h| (w, h))) {
            let size = Viewport::new(width, height).expect("a size");
            let few = [width, height].map(|side| side.div_ceil(COARSENESS));
            let coarse = Viewport::new(few[0], few[1]).expect("a size");
            let pixel = |object| Pixel {
                id: Id {
                    object,
                    ..Id::default()
                },
                ..Pixel::default()
            };
            let pixels = (0..few[0] * few[1]).map(pixel).collect();
            let fine = enlarged(&Image::new(coarse, pixels), size);
            assert_eq!(fine.size(), size);
            for (x, y) in fine.positions() {
                let expected = y / COARSENESS * few[0] + x / COARSENESS;
                assert_eq!(fine.at(x, y).id.object, expected, "{x}, {y} of {size:?}");
            }
        }
    }
}
