//! A picture under way: drawn at once, or in pieces between which something else may be shown.

use super::{
    Renderer,
    gpu::{Gpu, GpuError},
    lines::{self, Line},
    outline,
    pipelines::{Drawn, Pass},
    raster::begin,
    scene_buffers::{Draw, DrawnShape, Needed, SceneBuffers},
    slices::{Cursor, Piece, Slice, whole},
    targets::Targets,
};
use crate::camera::View;
use std::collections::VecDeque;
use wgpu::BufferUsages;

/// A scene, or what is selected of it, on its way into targets.
#[derive(Debug)]
pub struct Drawing {
    view: View,
    /// Those that are left, of which the first may be under way.
    passes: VecDeque<Pass>,
    cursor: Cursor,
    lines: Vec<Line>,
    selection: Option<(usize, Option<Draw>)>,
    done: u64,
}

impl Drawing {
    /// Colours, at so many samples a pixel, and ids of a scene as `view` shows it, with lines that are in the colours
    /// only.
    #[must_use]
    pub fn of_scene(samples: u32, view: &View, lines: Vec<Line>) -> Self {
        let passes: &[Pass] = match samples {
            1 => &[Pass::ColourAndIds],
            _ => &[Pass::Colour, Pass::Ids],
        };
        Self {
            view: *view,
            passes: passes.iter().copied().collect(),
            cursor: Cursor::default(),
            lines,
            selection: None,
            done: 0,
        }
    }

    /// The outline of an object, as it would be seen with nothing else in the scene, and its tint, where it is seen.
    #[must_use]
    pub fn of_selection(scene: &SceneBuffers, view: &View, object: usize) -> Self {
        let place = scene.places.get(object).filter(|place| place.visible);
        let alone = place.map(|place| {
            let draw = &scene.draws[place.draw];
            Draw {
                shape: draw.shape.only(place.triangles.clone()),
                mirrors: draw.mirrors,
                instances: place.instance..place.instance + 1,
            }
        });
        Self {
            view: *view,
            passes: VecDeque::from([Pass::Mask]),
            cursor: Cursor::default(),
            lines: Vec::new(),
            selection: Some((object, alone)),
            done: 0,
        }
    }

    /// Whether it is of a selection.
    #[must_use]
    pub fn is_of_selection(&self) -> bool {
        self.selection.is_some()
    }

    /// How much of its work is done; see [`Piece`].
    #[must_use]
    pub fn done(&self) -> u64 {
        self.done
    }

    /// What is drawn.
    fn draws<'a>(&'a self, scene: &'a SceneBuffers) -> &'a [Draw] {
        match &self.selection {
            Some((_, alone)) => alone.as_slice(),
            None => &scene.draws,
        }
    }

    /// All that it comes to.
    #[must_use]
    pub fn whole(&self, scene: &SceneBuffers) -> Piece {
        let each = whole(self.draws(scene));
        Piece {
            work: each.work.saturating_mul(self.passes.len() as u64),
            ..each
        }
    }
}

impl Renderer {
    /// Draws a piece more of a picture. Returns whether that is the whole.
    ///
    /// # Errors
    /// When memory runs out.
    ///
    /// # Panics
    /// When `targets` have another size than the view, or other samples than this renderer.
    pub fn advance(
        &mut self,
        gpu: &Gpu,
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
        let mut cursor = drawing.cursor;
        let is_first = cursor == Cursor::default();
        let slices = cursor.take(drawing.draws(scene), piece);
        let is_last = cursor.is_at_end(drawing.draws(scene));
        let needed = Needed::of(drawing.draws(scene), &slices);
        scene.prepare(gpu, &view, &needed);
        self.write_frame(gpu, &view);
        let bindings = self.bind(gpu, scene);
        let draws = drawing.draws(scene);
        begin_at(gpu, scene, draws, &slices, |slice, _| slice.triangles.start);
        let vertices = if is_last {
            lines::vertices(&view, &drawing.lines)
        } else {
            Vec::new()
        };
        let line_buffer = gpu.buffer("lines", BufferUsages::VERTEX, &vertices)?;
        let ends = 0..u32::try_from(vertices.len()).unwrap_or(u32::MAX);
        let mut encoder = gpu
            .device
            .create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
        {
            let depth = view.camera.lens().depth;
            let has_colours = matches!(pass, Pass::ColourAndIds | Pass::Colour);
            let mut render_pass = match pass {
                Pass::Mask => outline::begin(&mut encoder, &targets.mask_view, is_first),
                _ => begin(&mut encoder, targets, &view, pass, [is_first, is_last]),
            };
            render_pass.set_bind_group(0, &bindings.triangles, &[]);
            if is_first && has_colours {
                render_pass.set_pipeline(&self.pipelines.get(gpu, pass, Drawn::Background, depth));
                render_pass.draw(0..3, 0..1);
            }
            for slice in &slices {
                self.draw_slice(gpu, &mut render_pass, pass, &view, &bindings, draws, slice);
            }
            if is_last && has_colours {
                if let Some(wireframe) = self.wireframe.filter(|_| gpu.draws_wireframes()) {
                    self.draw_edges(
                        gpu,
                        &mut render_pass,
                        pass,
                        &view,
                        scene,
                        &bindings,
                        wireframe,
                    );
                }
                if !ends.is_empty() {
                    render_pass.set_pipeline(&self.pipelines.get(gpu, pass, Drawn::Lines, depth));
                    render_pass.set_vertex_buffer(0, line_buffer.slice(..));
                    render_pass.draw(ends, 0..1);
                }
            }
        }
        gpu.queue.submit([encoder.finish()]);
        begin_at(gpu, scene, draws, &slices, |_, draw| draw.triangles().start);
        drawing.done += slices.iter().map(Slice::work).sum::<u64>();
        drawing.cursor = cursor;
        if is_last {
            drawing.passes.pop_front();
            drawing.cursor = Cursor::default();
            if let Some((object, _)) = drawing.selection {
                self.draw_outline(gpu, scene, targets, &view, object);
            }
        }
        Ok(drawing.passes.is_empty())
    }
}

/// Says of slices that are part of an instance which triangle they begin with: a draw numbers its triangles from 0.
fn begin_at(
    gpu: &Gpu,
    scene: &SceneBuffers,
    draws: &[Draw],
    slices: &[Slice],
    triangle: impl Fn(&Slice, &Draw) -> u32,
) {
    for slice in slices {
        let draw = &draws[slice.draw];
        let is_part = slice.triangles != draw.triangles();
        if is_part && matches!(draw.shape, DrawnShape::Triangles { .. }) {
            scene.begin_at(gpu, slice.instances.start, triangle(slice, draw));
        }
    }
}
