//! Draws a picture at once, or in pieces with other frames in between.

use super::{
    Onto, Renderer, Wireframe,
    gpu::GpuError,
    lines::{self, Line},
    pipelines::{BATCHES, Drawn, Pass},
    raster::begin,
    resolve::Resolve,
    scene_buffers::SceneBuffers,
    seen::Tables,
    slices::{Piece, Slice},
    steps::{LINE, Parts, Steps},
    targets::Targets,
    view_rows::Draw,
};
use crate::camera::View;
use std::{collections::VecDeque, ops::Range};
use wgpu::BufferUsages;

/// The drawing of a scene into targets.
#[derive(Debug)]
pub struct Drawing {
    view: View,
    /// The passes that are left; the first may have begun.
    passes: VecDeque<Pass>,
    steps: Steps,
    /// The draw of the object whose edges are drawn, if it is a single one.
    edged: Option<Draw>,
    /// Bands of equally many rows, drawn one after the other.
    bands: u32,
    band: u32,
    lines: Vec<Line>,
    /// How much of its work is done; see [`Piece`].
    pub done: u64,
}

impl Drawing {
    /// Draws colours, with this many samples per pixel, and ids of a scene as `view` shows it. Lines are in the colours
    /// only.
    pub fn of_scene(samples: u32, view: &View, lines: Vec<Line>) -> Self {
        let passes: &[Pass] = match samples {
            1 => &[Pass::ColourAndIds],
            _ => &[Pass::Colour, Pass::Ids],
        };
        Self::of(passes, view, lines)
    }

    /// Draws smooth colours alone, for targets that have the ids already. Their samples are resolved after the last
    /// piece, and only then seen. The rows are drawn in this many bands, at least 1; a piece lies within one band.
    pub fn of_smooth_colours(view: &View, lines: Vec<Line>, bands: u32) -> Self {
        Self {
            bands: bands.clamp(1, view.viewport.height()),
            ..Self::of(&[Pass::Colour], view, lines)
        }
    }

    fn of(passes: &[Pass], view: &View, lines: Vec<Line>) -> Self {
        Self {
            view: *view,
            passes: passes.iter().copied().collect(),
            steps: Steps::default(),
            edged: None,
            bands: 1,
            band: 0,
            lines,
            done: 0,
        }
    }

    /// All of its work if the whole scene is in view, not counting edges of triangles.
    pub fn whole(&self, scene: &SceneBuffers) -> Piece {
        let each = scene.whole;
        let lines = LINE * self.lines.len() as u64;
        let passes = self.passes.iter();
        let of_pass = passes.map(|pass| each.work + if pass.has_colours() { lines } else { 0 });
        Piece {
            work: of_pass.sum::<u64>().saturating_mul(self.bands.into()),
            ..each
        }
    }

    /// Notes what was drawn: `work`, and whether that ends the band or the pass.
    fn drew(&mut self, work: u64, band: bool, pass: bool) {
        self.done += work;
        if band {
            (self.steps, self.band) = (Steps::default(), self.band + 1);
        }
        if pass {
            self.passes.pop_front();
            self.band = 0;
        }
    }

    /// The rows of the current band.
    fn rows(&self) -> Range<u32> {
        let height = u64::from(self.view.viewport.height());
        let top = |band: u32| {
            let row = height * u64::from(band) / u64::from(self.bands);
            u32::try_from(row).unwrap_or(u32::MAX)
        };
        top(self.band)..top(self.band + 1)
    }
}

impl Renderer {
    /// Draws colours and ids of the scene as `view` shows it. Lines are in the colours only. Needed when scene, view or
    /// lines changed; [`Renderer::composite`] then puts the picture on screen. Draws all at once; [`Renderer::advance`]
    /// draws in pieces.
    ///
    /// With one colour sample per pixel, one pass draws both.
    ///
    /// # Errors
    /// When memory runs out.
    ///
    /// # Panics
    /// When `targets` have another size than the view, or other samples than this renderer.
    pub fn draw(
        &mut self,
        (scene, targets, view): Onto<'_>,
        lines: &[Line],
    ) -> Result<(), GpuError> {
        let mut drawing = Drawing::of_scene(targets.samples, view, lines.to_vec());
        while !self.advance(scene, targets, &mut drawing, Piece::WHOLE)? {}
        Ok(())
    }

    /// Draws the next piece of a picture. Returns whether the picture is finished.
    ///
    /// # Errors
    /// When memory runs out.
    ///
    /// # Panics
    /// When `targets` have another size than the view, or other samples than this renderer.
    pub fn advance(
        &mut self,
        scene: &SceneBuffers,
        targets: &Targets,
        drawing: &mut Drawing,
        piece: Piece,
    ) -> Result<bool, GpuError> {
        self.check(targets, &drawing.view);
        let Some(&pass) = drawing.passes.front() else {
            return Ok(true);
        };
        let view = drawing.view;
        let gpu = &self.gpu;
        let begins = drawing.steps == Steps::default();
        let has_colours = pass.has_colours();
        let wireframe = self.wireframe.filter(|_| has_colours);
        if begins {
            drawing.edged = match wireframe {
                Some(Wireframe::Of(object)) => scene.alone(&view, object),
                _ => None,
            };
        }
        let seen = scene.seen_in(&view);
        let draws = seen.draws.as_slice();
        let parts = Parts {
            surfaces: draws,
            edged: match wireframe {
                Some(Wireframe::OfAll) => draws,
                Some(Wireframe::Of(_)) => drawing.edged.as_slice(),
                None => &[],
            },
            lines: if has_colours { drawing.lines.len() } else { 0 },
        };
        let step = drawing.steps.take(&parts, piece);
        let is_first = begins && drawing.band == 0;
        let is_last = step.ends && drawing.band + 1 == drawing.bands;
        self.write_frame(&view);
        let tables = &scene.tables;
        // Smooth colours carry no numbers of triangles.
        let numbered: &[Slice] = match pass {
            Pass::ColourAndIds | Pass::Ids => &step.surfaces,
            Pass::Colour => &[],
        };
        begin_at(tables, draws, numbered, |slice, _| slice.triangles.start);
        let bindings = self.bind(scene, &tables.spheres);
        let vertices = lines::vertices(&view, &drawing.lines[step.lines.clone()]);
        let line_buffer = gpu.buffer("lines", BufferUsages::VERTEX, &vertices)?;
        let line_ends = 0..u32::try_from(vertices.len()).unwrap_or(u32::MAX);
        gpu.submit(|encoder| {
            let mut render_pass = begin(gpu, encoder, targets, &view, pass, [is_first, is_last]);
            render_pass.set_bind_group(0, &bindings, &[]);
            render_pass.set_vertex_buffer(BATCHES, tables.triangles.slice(..));
            // Smooth colours are seen only when they are finished, so their background is drawn last, where nothing
            // else is.
            let has_background = match pass {
                Pass::Colour => is_last,
                Pass::ColourAndIds => is_first,
                Pass::Ids => false,
            };
            if has_background {
                render_pass.set_pipeline(&self.pipelines.get(gpu, pass, Drawn::Background, &view));
                render_pass.draw(0..3, 0..1);
            }
            // Drivers may draw past the scissor: the next band then draws the same pixels again.
            let rows = drawing.rows();
            let (width, height) = (view.viewport.width(), rows.end - rows.start);
            render_pass.set_scissor_rect(0, rows.start, width, height);
            (self.pipelines).draw_step(gpu, &mut render_pass, pass, &view, &parts, &step);
            if !line_ends.is_empty() {
                render_pass.set_pipeline(&self.pipelines.get(gpu, pass, Drawn::Lines, &view));
                render_pass.set_vertex_buffer(0, line_buffer.slice(..));
                render_pass.draw(line_ends, 0..1);
            }
            drop(render_pass);
            if is_last && pass == Pass::Colour && !gpu.resolves() {
                let resolve = self.resolve.get_or_init(|| Resolve::new(gpu));
                resolve.encode(gpu, encoder, targets);
            }
        });
        begin_at(tables, draws, numbered, |_, draw| draw.kind.triangles.start);
        drawing.drew(step.work(), step.ends, is_last);
        Ok(drawing.passes.is_empty())
    }
}

/// Tells the shader the first triangle of each slice that is only part of an instance, since a draw call numbers its
/// triangles from 0.
fn begin_at(
    tables: &Tables,
    draws: &[Draw],
    slices: &[Slice],
    triangle: impl Fn(&Slice, &Draw) -> u32,
) {
    for slice in slices {
        let draw = &draws[slice.draw];
        if slice.triangles != draw.kind.triangles {
            tables.begin_at(slice.instances.start, triangle(slice, draw));
        }
    }
}
