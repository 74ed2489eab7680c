//! One surface at a pixel, and whether two of them explain a difference.

use super::{
    Class,
    bound::{Outline, Reason, Stored},
};
use crate::{
    camera::{DepthMapping, Projection, View},
    geometry::Placement,
    render::transform::{U, VertexToView, depth_origin},
};
use glam::{DVec2, DVec3};

/// What an id may have shown at a pixel.
#[derive(Clone, Copy, Debug)]
pub(super) struct Surface {
    /// Why it may be there for one side only: an outline or the near plane's cut is near enough.
    pub loose: Option<Reason>,
    /// Its nearest outline, near enough or not.
    pub outline: Outline,
    /// Whether it really covers the centre, behind the near plane.
    pub covers: bool,
    /// View depth at the centre; NaN where there is none.
    pub depth: f64,
    /// What the depth buffer may hold for that.
    pub stored: Stored,
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

impl Surface {
    /// The empty depth buffer.
    pub fn background(view: &View) -> Self {
        let nearness = match view.camera.lens().depth {
            DepthMapping::Reversed => 0.0,
            DepthMapping::Standard => -1.0,
        };
        Self {
            loose: None,
            outline: Outline::NONE,
            covers: true,
            depth: f64::NAN,
            stored: Stored {
                nearness,
                nearest: nearness,
                farthest: nearness,
                rounding: 0.0,
                beyond_f32: false,
            },
            source: Source::Empty,
        }
    }
}

/// The best explanation for one surface having been drawn and the other picked; `None` when nothing explains it.
///
/// A surface whose outline is far covers the centre, or not, for both sides alike; then the other one is there for one
/// side only, and has to come first there. Two surfaces made from the same cover the same pixels at the same depths:
/// which of them shows is settled by their order, and nothing excuses another answer.
pub(super) fn explain(drawn: &Surface, picked: &Surface) -> Option<Reason> {
    if drawn.source == picked.source {
        return None;
    }
    let missing = |surface: &Surface| surface.loose.map(|reason| reason.class);
    // For drawing it comes first, or the other one is not there.
    let first = || drawn.stored.hides(&picked.stored);
    let hides = picked.covers.then(first).flatten();
    let drawn_only = (hides.into_iter().chain(missing(picked)).min())
        .and_then(|class| Some(drawn.loose?.and(class)));
    // The same for the pick.
    let precedes = drawn.covers && picked.stored.precedes(&drawn.stored);
    let hides = precedes.then_some(Class::Edge);
    let picked_only = (hides.into_iter().chain(missing(drawn)).min())
        .and_then(|class| Some(picked.loose?.and(class)));
    let by_depth = (drawn.covers && picked.covers)
        .then(|| drawn.stored.reason(&picked.stored))
        .flatten();
    let all = [drawn_only, picked_only, by_depth];
    all.into_iter().flatten().reduce(Reason::or)
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
    let terms = match lens.projection {
        Projection::Perspective { .. } => a.abs() + (b / depth).abs(),
        Projection::Orthographic { .. } => (a * (depth - depth_origin(view))).abs(),
    };
    let ndc = lens.ndc_depth(depth);
    let error = 4.0 * U * (ndc.abs() + terms) + stored_per_depth(view, depth) * depth_error;
    match lens.depth {
        DepthMapping::Reversed => (ndc, error),
        DepthMapping::Standard => (-ndc, error),
    }
}

/// How fast what the depth buffer holds changes with depth.
pub(super) fn stored_per_depth(view: &View, depth: f64) -> f64 {
    let lens = view.camera.lens();
    let (a, b) = lens.depth_row();
    match lens.projection {
        Projection::Perspective { .. } => b.abs() / (depth * depth),
        Projection::Orthographic { .. } => a.abs(),
    }
}

/// A step of depth, by what the buffer stores: what one unit in the last place of an `f32` is there of the stored number,
/// or of the depth, or of the distance between near and far where that is less.
///
/// Of these the largest: a depth that is stored as nearly 0 is not known as finely as the number could tell.
pub(super) fn stored_step(view: &View, depth: f64) -> f64 {
    let lens = view.camera.lens();
    let range = lens.far - lens.near;
    let known = match lens.projection {
        Projection::Perspective { .. } => range.min(depth.abs()),
        Projection::Orthographic { .. } => range,
    };
    let stored = lens.ndc_depth(depth).abs();
    2.0 * U * stored.max(stored_per_depth(view, depth) * known)
}
