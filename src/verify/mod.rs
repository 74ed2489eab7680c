//! Drawn against picked: every pixel's (object, triangle) as the GPU drew it and as a ray through the pixel's centre
//! hits it; each difference is put down to geometry, or is a defect.
//!
//! A rasteriser moves vertices to a grid of 1/256 pixel and computes in `f32`; the pick does neither. Where the two
//! differ, one of these has to hold, each by a bound that is derived and never by trying pixels nearby:
//!
//! * **edge**: one side's surface has its outline (projected edges, the cut of the near plane, a sphere's rim) so near
//!   the pixel's centre that the grid, and what `f32` moves the outline by ([`render::transform`], [`render::sphere`]),
//!   carry it across, and its depth there is one that the answer needs;
//! * **depth**: both surfaces cover the centre, as deep as the depth buffer can tell; the empty buffer counts as a
//!   surface;
//! * **f32 limit**: an edge, but `f32` moves the outline by more than the grid does;
//! * **unexplained**: anything else. Somebody is wrong.
//!
//! [`compare`] is pure: whatever answers for a pixel can be put to the test.

mod flat;
mod picture;
mod round;
mod surface;

pub use picture::{COLOURS, marks, paint};

use crate::{
    camera::{View, pixel_centre},
    image::{Id, Image},
    render::{self, transform::VertexToView},
    scene::{Scene, Shape},
};
use glam::DVec2;
use serde::Serialize;
use std::collections::HashMap;
use surface::Surface;

/// The rasteriser's grid for vertices, in pixels: what Vulkan, Metal and Direct3D devices have.
pub const GRID_PX: f64 = 1.0 / 256.0;

/// Why a pixel is drawn as one thing and picked as another, from harmless to not.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Class {
    /// The centre lies on an outline, to the rasteriser's grid.
    Edge,
    /// Both surfaces are as deep, to the depth buffer's steps.
    Depth,
    /// The centre lies on an outline, to what `f32` can tell, which here is less than the grid.
    F32Limit,
    /// A defect.
    Unexplained,
}

impl Class {
    /// All, in order.
    pub const ALL: [Self; 4] = [Self::Edge, Self::Depth, Self::F32Limit, Self::Unexplained];

    /// The word for it.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Edge => "edge",
            Self::Depth => "depth",
            Self::F32Limit => "f32 limit",
            Self::Unexplained => "unexplained",
        }
    }
}

/// A pixel that is drawn as one thing and picked as another.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Disagreement {
    /// Column and row.
    pub pixel: [u32; 2],
    /// What the GPU drew.
    pub drawn: Id,
    /// What the ray hit.
    pub picked: Id,
    /// Why they differ.
    pub class: Class,
    /// What the nearest explanation takes over what it may take: up to 1 it holds. Infinite where none comes into
    /// question.
    pub strain: f64,
    /// From the centre to the nearer of the two outlines that could make the difference, in pixels; infinite for none.
    pub outline_px: f64,
    /// How far drawing may move that outline, in pixels.
    pub outline_error_px: f64,
    /// View depth at the centre of what was drawn and of what was picked; NaN where there is none.
    pub depth: [f64; 2],
}

/// What a comparison of two pictures found.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Report {
    /// Pixels compared.
    pub pixels: usize,
    /// Pixels that show something, drawn or picked.
    pub shown: usize,
    /// Drawn pixels with another id above, below, left or right of them: where differences can be expected.
    pub outline: usize,
    /// Every pixel that differs, row by row from the top.
    pub disagreements: Vec<Disagreement>,
}

impl Report {
    /// Pixels of one class.
    #[must_use]
    pub fn count(&self, class: Class) -> usize {
        let of_class = |at: &&Disagreement| at.class == class;
        self.disagreements.iter().filter(of_class).count()
    }

    /// Pixels on which both agree.
    #[must_use]
    pub fn same(&self) -> usize {
        self.pixels - self.disagreements.len()
    }

    /// Pixels that differ over pixels on outlines; 0 where nothing differs.
    #[must_use]
    pub fn share_of_outline(&self) -> f64 {
        #[expect(clippy::cast_precision_loss, reason = "pixels are counted in millions")]
        let share = self.disagreements.len() as f64 / self.outline as f64;
        if self.disagreements.is_empty() {
            0.0
        } else {
            share
        }
    }

    /// The pixel hardest to explain: of the gravest class the one with the most strain.
    #[must_use]
    pub fn worst(&self) -> Option<&Disagreement> {
        let gravity = |a: &&Disagreement, b: &&Disagreement| {
            (a.class.cmp(&b.class)).then(a.strain.total_cmp(&b.strain))
        };
        self.disagreements.iter().max_by(gravity)
    }
}

/// Compares two id pictures of a scene, pixel by pixel.
///
/// # Panics
/// When either has another size than the view.
#[must_use]
pub fn compare(scene: &Scene, view: &View, drawn: &Image<Id>, picked: &Image<Id>) -> Report {
    assert_eq!(
        drawn.size(),
        view.viewport,
        "the drawn picture is the view's"
    );
    assert_eq!(
        picked.size(),
        view.viewport,
        "the picked picture is the view's"
    );
    let mut explainer = Explainer {
        scene,
        view,
        to_view: HashMap::new(),
    };
    let mut report = Report {
        pixels: drawn.pixels().len(),
        ..Report::default()
    };
    for (x, y) in drawn.positions() {
        let ids = [drawn.at(x, y), picked.at(x, y)];
        report.shown += usize::from(ids != [Id::default(); 2]);
        report.outline += usize::from(on_outline(drawn, x, y));
        if ids[0] != ids[1] {
            report.disagreements.push(explainer.explain([x, y], ids));
        }
    }
    report
}

/// Whether a neighbour to the left, right, top or bottom shows something else.
fn on_outline(ids: &Image<Id>, x: u32, y: u32) -> bool {
    // Past the border the last pixel goes on.
    let (right, bottom) = (ids.size().width() - 1, ids.size().height() - 1);
    let around = [
        (x.saturating_sub(1), y),
        ((x + 1).min(right), y),
        (x, y.saturating_sub(1)),
        (x, (y + 1).min(bottom)),
    ];
    around
        .into_iter()
        .any(|(i, j)| ids.at(i, j) != ids.at(x, y))
}

/// Puts differences down to geometry.
struct Explainer<'a> {
    scene: &'a Scene,
    view: &'a View,
    /// What the vertex shader does to a batch, by the batch's first object.
    to_view: HashMap<usize, VertexToView>,
}

impl Explainer<'_> {
    fn explain(&mut self, pixel: [u32; 2], [drawn, picked]: [Id; 2]) -> Disagreement {
        let px = pixel_centre(DVec2::from(pixel.map(f64::from)));
        let sides = [drawn, picked].map(|id| self.surfaces(px, id));
        let pairs = sides[0]
            .iter()
            .flat_map(|of_drawn| sides[1].iter().map(move |of_picked| (of_drawn, of_picked)));
        let explained = pairs.map(|(of_drawn, of_picked)| {
            let (class, strain, outline) = surface::explain(of_drawn, of_picked);
            Disagreement {
                pixel,
                drawn,
                picked,
                class,
                strain,
                outline_px: outline.distance_px,
                outline_error_px: outline.error_px(),
                depth: [of_drawn.depth, of_picked.depth],
            }
        });
        let best =
            explained.min_by(|a, b| (a.class.cmp(&b.class)).then(a.strain.total_cmp(&b.strain)));
        // An object without a surface here was never to be seen.
        best.unwrap_or(Disagreement {
            pixel,
            drawn,
            picked,
            class: Class::Unexplained,
            strain: f64::INFINITY,
            outline_px: f64::INFINITY,
            outline_error_px: 0.0,
            depth: [f64::NAN; 2],
        })
    }

    /// The surfaces that an id may stand for at a pixel: one, or the faces of a cube, or a sphere's front and back.
    fn surfaces(&mut self, px: DVec2, id: Id) -> Vec<Surface> {
        let Some(index) = (id.object as usize).checked_sub(1) else {
            return vec![Surface::background(self.view)];
        };
        let (scene, view) = (self.scene, self.view);
        let Some(object) = scene.objects().get(index).filter(|object| object.visible) else {
            return Vec::new();
        };
        match object.shape {
            Shape::Sphere => return round::surfaces(view, &object.placement, px),
            Shape::Cube | Shape::Square | Shape::Mesh { .. } => {}
        }
        let batches = scene.batches();
        let batch = &batches[batches.partition_point(|batch| batch.end <= index)];
        let to_view = self.to_view.entry(batch.start).or_insert_with(|| {
            let (origin, bounds) = render::transform::vertex_space(scene, batch);
            VertexToView::new(view, &object.placement, origin, &bounds)
        });
        flat::surfaces(view, object, to_view, px, id.triangle)
    }
}
