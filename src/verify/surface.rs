//! One surface at a pixel, and whether two of them explain a difference.

use super::{Class, GRID_PX};
use crate::{
    camera::{DepthMapping, Projection, View},
    geometry::Placement,
    render::transform::{U, VertexToView, depth_origin},
};
use glam::{DVec2, DVec3};

/// An outline near a pixel's centre; lengths in pixels.
#[derive(Clone, Copy, Debug)]
#[expect(clippy::struct_field_names, reason = "the unit")]
pub(super) struct Outline {
    /// From the centre, in pixels; never more than it really is.
    pub distance_px: f64,
    /// What the rasteriser's grid moves it by, in pixels: nothing where no vertices make it.
    pub grid_px: f64,
    /// What `f32` moves it by, in pixels.
    pub f32_px: f64,
}

/// What an id may have shown at a pixel.
#[derive(Clone, Copy, Debug)]
pub(super) struct Surface {
    /// Its outlines: edges or rim, and where the near plane cuts it.
    pub outlines: [Outline; 2],
    /// Whether it really covers the centre, behind the near plane.
    pub covers: bool,
    /// View depth at the centre, of the surface or its continuation.
    pub depth: f64,
    /// What the depth buffer stores for that, or its negative: more is nearer.
    pub nearness: f64,
    /// How far that may be off.
    pub nearness_error: f64,
    /// What the GPU makes it from.
    pub source: Source,
}

/// What the GPU makes a surface from. From the same it makes the same, to the bit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Source {
    /// Nothing.
    Empty,
    /// Vertices in this order (of a face the first three).
    Vertices(VertexToView, [DVec3; 3]),
    /// A sphere's equations.
    Sphere(Placement),
}

impl Outline {
    /// None there.
    pub const NONE: Self = Self {
        distance_px: f64::INFINITY,
        grid_px: 0.0,
        f32_px: 0.0,
    };

    /// Where the near plane cuts a surface of this depth and slope (depth for a pixel) at the centre, when drawing may
    /// see the depth wrong by `depth_error`; `moved_px` is what grid and `f32` move the surface aside by.
    pub fn cut(
        view: &View,
        depth: f64,
        slope: DVec2,
        depth_error: f64,
        moved_px: [f64; 2],
    ) -> Self {
        // A surface along the near plane is cut nowhere or everywhere: what counts is the depths, and their ratio stays.
        let slope = slope.length().max(f64::EPSILON * depth_error);
        Self {
            distance_px: (depth - view.camera.lens().near).abs() / slope,
            grid_px: moved_px[0],
            f32_px: moved_px[1] + depth_error / slope,
        }
    }

    /// The one of two that explains more: of the better class, with less strain.
    pub fn or(self, other: Self) -> Self {
        if (other.class(), other.strain()) < (self.class(), self.strain()) {
            other
        } else {
            self
        }
    }

    /// How far drawing may move it, in pixels.
    pub fn error_px(&self) -> f64 {
        self.grid_px + self.f32_px
    }

    /// Its distance over how far drawing may move it.
    fn strain(&self) -> f64 {
        let strain = self.distance_px / self.error_px();
        // Exactly on an outline that nothing moves.
        if strain.is_nan() { 0.0 } else { strain }
    }

    fn class(&self) -> Class {
        if !(self.strain() <= 1.0) {
            Class::Unexplained
        } else if self.f32_px <= GRID_PX {
            Class::Edge
        } else {
            Class::F32Limit
        }
    }
}

impl Surface {
    /// The empty depth buffer.
    pub fn background(view: &View) -> Self {
        Self {
            outlines: [Outline::NONE; 2],
            covers: true,
            depth: f64::NAN,
            nearness: match view.camera.lens().depth {
                DepthMapping::Reversed => 0.0,
                DepthMapping::Standard => -1.0,
            },
            nearness_error: 0.0,
            source: Source::Empty,
        }
    }

    fn outline(&self) -> Outline {
        self.outlines[0].or(self.outlines[1])
    }

    /// Whether it may come before `other` in the depth buffer; true where either depth makes no sense, as for the
    /// continuation of a triangle that is seen edge-on.
    fn may_hide(&self, other: &Self) -> bool {
        !(self.nearness + self.nearness_error < other.nearness - other.nearness_error)
    }
}

/// The best explanation for one surface having been drawn and the other picked: class, strain and the outline it rests
/// on or would have to.
///
/// A surface whose outline is far covers the centre, or not, for both sides alike; then the other one is there for one
/// side only, and has to come first there. Two surfaces made from the same cover the same pixels at the same depths:
/// which of them shows is settled by their order, and nothing excuses another answer.
pub(super) fn explain(drawn: &Surface, picked: &Surface) -> (Class, f64, Outline) {
    if drawn.source == picked.source {
        return (Class::Unexplained, f64::INFINITY, Outline::NONE);
    }
    let [of_drawn, of_picked] = [drawn.outline(), picked.outline()];
    let (loose_drawn, loose_picked) = (of_drawn.strain() <= 1.0, of_picked.strain() <= 1.0);
    // Each outline counts if its surface would win the pixel, or the other one is loose as well.
    let counts = [
        (
            of_drawn,
            loose_picked || picked.covers && drawn.may_hide(picked),
        ),
        (
            of_picked,
            loose_drawn || drawn.covers && picked.may_hide(drawn),
        ),
    ];
    let by_outline = (counts.into_iter().filter(|(_, counts)| *counts))
        .map(|(outline, _)| (outline.class(), outline.strain(), outline));
    let gap = (drawn.nearness - picked.nearness).abs();
    let strain = gap / (drawn.nearness_error + picked.nearness_error);
    let by_depth = (drawn.covers && picked.covers).then(|| {
        let class = if gap <= drawn.nearness_error + picked.nearness_error {
            Class::Depth
        } else {
            Class::Unexplained
        };
        (class, if gap == 0.0 { 0.0 } else { strain }, Outline::NONE)
    });
    let best = by_outline
        .chain(by_depth)
        .min_by(|a, b| a.0.cmp(&b.0).then(a.1.total_cmp(&b.1)));
    best.unwrap_or((Class::Unexplained, f64::INFINITY, Outline::NONE))
}

/// The ray through a pixel position in view space: where it starts at depth 0 and its step for one unit of depth; and
/// the change of whichever moves for one pixel right and down.
pub(super) struct ViewRay {
    pub origin: DVec3,
    pub direction: DVec3,
    pub steps: [DVec3; 2],
}

impl ViewRay {
    pub fn new(view: &View, px: DVec2) -> Self {
        let half = view.camera.lens().half_extent(view.viewport.aspect());
        let aside = (view.viewport.px_to_ndc(px) * half).extend(0.0);
        let (origin, direction) = match view.camera.lens().projection {
            Projection::Perspective { .. } => (DVec3::ZERO, aside + DVec3::Z),
            Projection::Orthographic { .. } => (aside, DVec3::Z),
        };
        let step = 2.0 * half / view.viewport.size_px();
        Self {
            origin,
            direction,
            steps: [DVec3::X * step.x, DVec3::NEG_Y * step.y],
        }
    }

    /// Depth at which it meets the plane through `point` across `normal`.
    pub fn depth_on(&self, point: DVec3, normal: DVec3) -> f64 {
        normal.dot(point - self.origin) / normal.dot(self.direction)
    }

    /// Change of that depth for one pixel right and down. From `N . (o + z d - P) = 0`, where o or d moves.
    pub fn slope(&self, view: &View, depth: f64, normal: DVec3) -> DVec2 {
        let [right, down] = self.steps;
        -view.camera.lens().w(depth) * DVec2::new(normal.dot(right), normal.dot(down))
            / normal.dot(self.direction)
    }
}

/// What the depth buffer holds for a depth, by nearness, and how far that may be off for a wrong depth.
///
/// Rounded are the two numbers of the projection's third row, their product and sum, the division and what is stored.
pub(super) fn nearness(view: &View, depth: f64, depth_error: f64) -> (f64, f64) {
    let lens = view.camera.lens();
    let (a, b) = lens.depth_row();
    let (terms, per_depth) = match lens.projection {
        Projection::Perspective { .. } => (a.abs() + (b / depth).abs(), b.abs() / (depth * depth)),
        Projection::Orthographic { .. } => ((a * (depth - depth_origin(view))).abs(), a.abs()),
    };
    let ndc = lens.ndc_depth(depth);
    let error = 4.0 * U * (ndc.abs() + terms) + per_depth * depth_error;
    match lens.depth {
        DepthMapping::Reversed => (ndc, error),
        DepthMapping::Standard => (-ndc, error),
    }
}
