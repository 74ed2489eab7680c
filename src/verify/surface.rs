//! A surface at a pixel, depths as the GPU computes them, and whether two surfaces explain a difference.

use super::{
    Class, DEPTH_CEILING, OUTLINE_CEILING_PX,
    bound::{Outline, Reason, Stored},
};
use crate::{
    camera::{DepthMapping, Lens, Projection, View},
    geometry::Placement,
    render::{
        rounding::{U, UNDERFLOW, is_f32, larger},
        transform::{VertexToView, ViewError},
        view_space::ViewSpace,
    },
};
use glam::{DAffine3, DVec3};

/// A surface that an id may stand for at a pixel.
#[derive(Clone, Copy, Debug)]
pub(super) struct Surface {
    /// Why drawing and pick may disagree on whether it covers the centre: an outline, or the cut of the near plane or
    /// the section, is near enough.
    pub coverage: Option<Reason>,
    /// Why a neighbour may show in its place, or vice versa: an edge between them is near enough.
    pub neighbour: Option<Reason>,
    /// Why drawing may decide otherwise whether the section keeps it.
    pub section: Option<Reason>,
    /// Whether drawing may keep it: false where the section cuts it away by more than drawing can be off.
    pub may_keep: bool,
    /// For a mesh's triangle: its batch's first object, and its number.
    pub triangle: Option<(usize, u32)>,
    /// Its nearest outline, however far away.
    pub outline: Outline,
    /// Whether it truly covers the centre, behind the near plane and kept by the section.
    pub covers: bool,
    /// View depth at the centre; NaN where there is none.
    pub depth: f64,
    /// What the depth buffer may hold for this depth.
    pub stored: Stored,
    /// The GPU's input.
    pub source: Source,
}

/// What a surface is made from. Identical input gives identical output, to the bit, on the GPU and in a pick: then the
/// order of objects decides which shows. Matrices that differ by less than `f32` resolves give identical drawings, but
/// not identical picks; so the model matrix is compared, too.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Source {
    /// Nothing.
    Empty,
    /// The GPU's version of a model matrix, that matrix, an origin and, about it, the first three vertices in order.
    Vertices(VertexToView, DAffine3, [DVec3; 4]),
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
            coverage: None,
            neighbour: None,
            section: None,
            may_keep: true,
            triangle: None,
            outline: Outline::NONE,
            covers: true,
            depth: f64::NAN,
            stored: Stored {
                nearness,
                nearest: nearness,
                farthest: nearness,
                rounding: 0.0,
                ceiling: 0.0,
                beyond_f32: false,
            },
            source: Source::Empty,
        }
    }

    /// The same surface, put at the view depth where a ray hits it if its corners are too large to tell the depth.
    pub fn at_hit(self, depths: &Depths, depth: f64) -> Self {
        if self.stored.is_bounded() {
            return self;
        }
        let past_near = depth - depths.lens.near;
        let stored = Stored {
            nearness: depths.nearness(past_near),
            ceiling: depths.ceiling(past_near),
            ..self.stored
        };
        Self {
            depth,
            stored,
            ..self
        }
    }

    /// Whether it lies within the ceiling of the near or far plane, and so may be cut off or look as deep as the empty
    /// buffer. (Standard depth stores 1 for most of what lies between planes far apart.)
    fn is_at_plane(&self, depths: &Depths) -> bool {
        let Lens { near, far, .. } = depths.lens;
        let ceiling = self.stored.ceiling / depths.stored_per_depth(self.depth - near);
        [near, far]
            .iter()
            .any(|plane| (self.depth - plane).abs() <= ceiling)
    }
}

/// Adds reasons where the section may cut away a neighbour across an edge but keep the surface, or vice versa: what
/// lies behind may then show at the edge between them.
pub(super) fn with_cut_neighbours(mut surfaces: Vec<Surface>) -> Vec<Surface> {
    let cut = surfaces.iter().filter_map(|surface| surface.section);
    if let Some(cut) = cut.reduce(Reason::or) {
        for surface in &mut surfaces {
            let at_edge = surface.neighbour.map(|reason| cut.and(reason.class));
            let known = surface.coverage.into_iter();
            surface.coverage = known.chain(at_edge).reduce(Reason::or);
        }
    }
    surfaces
}

/// The surfaces that no other one certainly hides: without the far side of a solid where its near side certainly covers
/// the centre and lies before it.
pub(super) fn not_behind(
    mut surfaces: Vec<Surface>,
    lies_before: impl Fn(&Surface, &Surface) -> bool,
) -> Vec<Surface> {
    let all = surfaces.clone();
    surfaces.retain(|surface| {
        let hides = |other: &Surface| {
            let may_differ = other.coverage.or(other.neighbour).is_some();
            other.covers && !may_differ && lies_before(other, surface)
        };
        !all.iter().any(hides)
    });
    surfaces
}

/// The best explanation why one surface was drawn and the other picked; `None` when there is none.
///
/// Where a surface's outline is far away, drawing and pick agree on whether the surface covers the centre. The other
/// surface must then be there for only one of the two, and come first there. Two surfaces made from the same input
/// cover the same pixels at the same depths: their order decides which shows, and nothing explains another answer.
///
/// A surface well between near and far that the depth buffer takes for nothing is beyond `f32`, whatever its bounds.
pub(super) fn explain(depths: &Depths, drawn: &Surface, picked: &Surface) -> Option<Reason> {
    if drawn.triangle.is_some() && drawn.triangle == picked.triangle {
        // Drawing and pick reach the same triangle across edges.
        return drawn.neighbour;
    }
    if drawn.source == picked.source {
        return None;
    }
    let missing = |surface: &Surface| surface.coverage.map(|reason| reason.class);
    // For drawing, `drawn` comes first or `picked` is missing.
    let first = || drawn.stored.hides(&picked.stored);
    let hides = picked.covers.then(first).flatten();
    let drawn_only = (hides.into_iter().chain(missing(picked)).min())
        .and_then(|class| Some(drawn.coverage?.and(class)));
    // For the pick, `picked` comes first or `drawn` is missing.
    let precedes = drawn.covers && picked.stored.precedes(&drawn.stored);
    let hides = precedes.then_some(Class::Edge);
    let picked_only = (hides.into_iter().chain(missing(drawn)).min())
        .and_then(|class| Some(picked.coverage?.and(class)));
    // A neighbour in its place may cover the centre.
    let may_cover = |surface: &Surface| {
        let reached = || Some(surface.neighbour?.class);
        surface.covers.then_some(Class::Edge).or_else(reached)
    };
    let by_depth = may_cover(drawn).zip(may_cover(picked)).and_then(|(a, b)| {
        let reason = drawn.stored.reason(&picked.stored)?;
        Some(reason.and(a).and(b))
    });
    let all = [drawn_only, picked_only, by_depth];
    let best = all.into_iter().flatten().reduce(Reason::or)?;
    let is_lost = drawn.source == Source::Empty && !picked.is_at_plane(depths);
    let class = best.class.within(is_lost && best.class == Class::Depth);
    Some(Reason { class, ..best })
}

/// A lens's depths as the GPU computes them. Depths count from the near plane (*past near*), which keeps digits both at
/// the eye and where near and far lie close together far away.
#[derive(Clone, Copy)]
pub(super) struct Depths {
    lens: Lens,
    unit: f64,
    /// The w that the GPU computes, per unit of [`Depths::w`].
    unit_of_w: f64,
    /// From the near plane to where the depth buffer stores 0.
    origin: f64,
    /// The stored value times w, per unit of buffer depth.
    per_buffer_depth: f64,
    /// A pixel's height in world units where w is 1.
    pixel_at_w_1: f64,
}

impl Depths {
    pub fn new(space: &ViewSpace) -> Self {
        let lens = *space.view().camera.lens();
        Self {
            lens,
            unit: space.unit(),
            unit_of_w: match lens.projection {
                Projection::Perspective { .. } => space.unit(),
                Projection::Orthographic { .. } => 1.0,
            },
            origin: match lens.depth {
                DepthMapping::Reversed => lens.far - lens.near,
                DepthMapping::Standard => 0.0,
            },
            per_buffer_depth: lens.depth_row().0,
            pixel_at_w_1: 2.0 * space.view().half_extent().y
                / f64::from(space.view().viewport.height()),
        }
    }

    /// A depth that drawing may take for behind the near plane, or as near to it as can be projected: in perspective
    /// depths stay away from the eye's plane.
    pub fn projectable(&self, past_near: f64) -> f64 {
        match self.lens.projection {
            Projection::Perspective { .. } => past_near.max(-0.5 * self.lens.near),
            Projection::Orthographic { .. } => past_near,
        }
    }

    /// How many pixels away a plane at a pixel has its horizon: beyond it, it lies behind the eye.
    pub fn horizon_px(&self, past_near: f64, slope: f64) -> f64 {
        match self.lens.projection {
            Projection::Orthographic { .. } => f64::INFINITY,
            Projection::Perspective { .. } => (self.lens.near + past_near).abs() / slope,
        }
    }

    /// Clip space's w.
    pub fn w(&self, past_near: f64) -> f64 {
        self.lens.w(self.lens.near + past_near)
    }

    /// The depth buffer's value, unrounded.
    pub fn stored(&self, past_near: f64) -> f64 {
        self.per_buffer_depth * (past_near - self.origin) / self.w(past_near)
    }

    /// The depth buffer's value as nearness, unrounded: more is nearer.
    pub fn nearness(&self, past_near: f64) -> f64 {
        match self.lens.depth {
            DepthMapping::Reversed => self.stored(past_near),
            DepthMapping::Standard => -self.stored(past_near),
        }
    }

    /// An upper bound on the error of the stored value.
    ///
    /// These are rounded: the factor, its product with the buffer depth, the reciprocal of w (2.5 units in the last
    /// place), the product with that, and the stored value. That is 9 half units; one more is for second order.
    pub fn error(&self, past_near: f64, error: &ViewError) -> f64 {
        let (w, stored) = (self.w(past_near), self.stored(past_near).abs());
        let of_w = match self.lens.projection {
            Projection::Perspective { .. } => error.depth,
            Projection::Orthographic { .. } => 0.0,
        };
        let buffer_depth = (past_near - self.origin).abs();
        let [buffer_depth_drawn, w_drawn] = [self.unit * buffer_depth, self.unit_of_w * w];
        let underflow = UNDERFLOW * (buffer_depth_drawn.max(1.0) / w_drawn.min(1.0) + 2.0);
        (self.per_buffer_depth.abs() * error.buffer_depth + stored * of_w) / w
            + 10.0 * U * stored
            + underflow
    }

    /// How far drawing may misplace the near plane, in depth. Clipping compares a product of two rounded factors with w,
    /// or with 0 where the depth buffer stores 0; see [`Self::error_at_w`]. Infinite where `f64` does not hold the factor.
    pub fn near_error(&self, error: &ViewError, exact: bool) -> f64 {
        match self.lens.depth {
            DepthMapping::Reversed => self.error_at_w(self.lens.near, error, exact),
            DepthMapping::Standard => error.buffer_depth,
        }
    }

    /// The same of the far plane.
    pub fn far_error(&self, error: &ViewError) -> f64 {
        match self.lens.depth {
            DepthMapping::Reversed => error.buffer_depth,
            DepthMapping::Standard => self.error_at_w(self.lens.far, error, false),
        }
    }

    /// How far drawing may misplace the plane where the depth buffer stores 1. There the product equals w, which is the
    /// plane's depth, or 1 in orthographic projection. Their difference changes with depth by the factor, less 1 in
    /// perspective. `exact` says that `f32` holds the product.
    fn error_at_w(&self, plane: f64, error: &ViewError, exact: bool) -> f64 {
        let factor = self.per_buffer_depth;
        let (w, of_w, change) = match self.lens.projection {
            Projection::Perspective { .. } => (plane, error.depth, (factor - 1.0).abs()),
            Projection::Orthographic { .. } => (1.0, 0.0, factor.abs()),
        };
        let of_product = 2.0 * U * w + 2.0 * UNDERFLOW / self.unit_of_w;
        let product = if exact { 0.0 } else { of_product };
        larger(
            (product + factor.abs() * error.buffer_depth + of_w) / change,
            0.0,
        )
    }

    /// Whether `f32` represents exactly what clipping compares at this depth.
    pub fn clips_exactly(&self, past_near: f64) -> bool {
        let factor = match self.lens.projection {
            Projection::Perspective { .. } => self.per_buffer_depth,
            Projection::Orthographic { .. } => self.per_buffer_depth / self.unit,
        };
        let buffer_depth = self.unit * (past_near - self.origin);
        #[expect(clippy::float_cmp, reason = "to the bit: it may have been rounded")]
        let is_exact = buffer_depth / self.unit + self.origin == past_near;
        is_exact && is_f32(factor) && is_f32(buffer_depth) && is_f32(factor * buffer_depth)
    }

    /// The largest error of the stored value in a view that `f32` can draw: [`DEPTH_CEILING`] of the depth, or of the
    /// distance between near and far where that is less; at most half a pixel's width, as for outlines.
    ///
    /// It comes from lengths, whatever the buffer stores: a coarser buffer does not allow larger errors.
    pub fn ceiling(&self, past_near: f64) -> f64 {
        self.stored_per_depth(past_near) * self.ceiling_world(past_near)
    }

    /// The ceiling as a length along the line of sight.
    pub fn ceiling_world(&self, past_near: f64) -> f64 {
        let range = self.lens.far - self.lens.near;
        let w = self.w(past_near).abs();
        let known = match self.lens.projection {
            Projection::Perspective { .. } => range.min(w),
            Projection::Orthographic { .. } => range,
        };
        (DEPTH_CEILING * known).min(self.half_a_pixel(past_near))
    }

    /// The most by which the shaders may misplace a section, along its normal, in a view that `f32` can draw. The test
    /// does not measure from the near or far plane, so their distance does not count.
    pub fn section_ceiling_world(&self, past_near: f64) -> f64 {
        let known = match self.lens.projection {
            Projection::Perspective { .. } => DEPTH_CEILING * self.w(past_near).abs(),
            Projection::Orthographic { .. } => f64::INFINITY,
        };
        known.min(self.half_a_pixel(past_near))
    }

    /// Half a pixel's width at a depth, in world units.
    fn half_a_pixel(&self, past_near: f64) -> f64 {
        OUTLINE_CEILING_PX * self.pixel_at_w_1 * self.w(past_near).abs()
    }

    /// How fast the stored value changes with depth.
    pub fn stored_per_depth(&self, past_near: f64) -> f64 {
        match self.lens.projection {
            Projection::Perspective { .. } => {
                let w = self.w(past_near);
                self.per_buffer_depth.abs() * (self.lens.near + self.origin) / (w * w)
            }
            Projection::Orthographic { .. } => self.per_buffer_depth.abs(),
        }
    }
}
