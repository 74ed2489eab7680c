//! One surface at a pixel, and whether two of them explain a difference.

use super::{
    Class, DEPTH_CEILING_STEPS, OUTLINE_CEILING_PX,
    bound::{Outline, Reason, Stored},
};
use crate::{
    camera::{DepthMapping, Lens, Projection, View},
    geometry::{Placement, double_double::Vector},
    render::{
        transform::{U, UNDERFLOW, VertexToView, ViewError, is_f32},
        view_space::ViewSpace,
    },
};
use glam::{DAffine3, DVec2, DVec3};

/// What an id may have shown at a pixel.
#[derive(Clone, Copy, Debug)]
pub(super) struct Surface {
    /// Why it may be there for one side only: an outline or the near plane's cut is near enough.
    pub loose: Option<Reason>,
    /// Why a neighbour may be there in its place, or it in a neighbour's: an edge between them is near enough.
    pub crossed: Option<Reason>,
    /// Why drawing may see otherwise whether the section keeps it, if it is there.
    pub cut: Option<Reason>,
    /// Of a mesh's triangle: its batch's first object and its number.
    pub triangle: Option<(usize, u32)>,
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

/// What a surface is made from. From the same the GPU makes the same, to the bit, and so does a pick: their order settles
/// which shows. Of matrices that differ by less than `f32` can tell, the GPU makes the same, and a pick does not.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Source {
    /// Nothing.
    Empty,
    /// Vertices in this order (of a face the first three) about an origin, under a model matrix and what the GPU has of it.
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
            loose: None,
            crossed: None,
            cut: None,
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

    /// The same where a ray hits it at this view depth, which its corners may be too large to tell.
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

    /// Whether it lies so near to a plane of the lens that it may look as deep as the empty buffer, or be cut off: no
    /// farther off than the ceiling. Standard depth stores 1 for most of what lies between planes far apart.
    fn is_at_plane(&self, depths: &Depths) -> bool {
        let Lens { near, far, .. } = depths.lens;
        let ceiling = self.stored.ceiling / depths.stored_per_depth(self.depth - near);
        [near, far]
            .into_iter()
            .any(|plane| (self.depth - plane).abs() <= ceiling)
    }
}

/// A neighbour across an edge may be cut away where a surface is kept, or the other way round: what lies behind may then
/// show at the edge between them.
pub(super) fn with_cut_neighbours(mut surfaces: Vec<Surface>) -> Vec<Surface> {
    let cut = surfaces.iter().filter_map(|surface| surface.cut);
    if let Some(cut) = cut.reduce(Reason::or) {
        for surface in &mut surfaces {
            let at_edge = surface.crossed.map(|reason| cut.and(reason.class));
            surface.loose = surface.loose.into_iter().chain(at_edge).reduce(Reason::or);
        }
    }
    surfaces
}

/// Those of an object's surfaces at a pixel that drawing may show there: not a solid's far side where drawing is certain to
/// put its near side before it.
pub(super) fn may_be_drawn(surfaces: Vec<Surface>) -> Vec<Surface> {
    not_behind(surfaces, |near, far| {
        near.stored.farthest > far.stored.nearest
    })
}

/// Those that a pick may show there: not a solid's far side where the near one certainly covers the centre, since picks are in
/// exact order.
pub(super) fn may_be_picked(surfaces: Vec<Surface>) -> Vec<Surface> {
    not_behind(surfaces, |near, far| near.depth < far.depth)
}

/// Those that no other one certainly covers and lies before.
fn not_behind(
    mut surfaces: Vec<Surface>,
    lies_before: impl Fn(&Surface, &Surface) -> bool,
) -> Vec<Surface> {
    let all = surfaces.clone();
    surfaces.retain(|surface| {
        let hides = |other: &Surface| {
            let is_loose = other.loose.or(other.crossed).is_some();
            other.covers && !is_loose && lies_before(other, surface)
        };
        !all.iter().any(hides)
    });
    surfaces
}

/// The best explanation for one surface having been drawn and the other picked; `None` when nothing explains it.
///
/// A surface whose outline is far covers the centre, or not, for both sides alike; then the other one is there for one
/// side only, and has to come first there. Two surfaces made from the same cover the same pixels at the same depths:
/// which of them shows is settled by their order, and nothing excuses another answer.
///
/// A surface well within the planes that the depth buffer takes for nothing is lost, whatever its bounds.
pub(super) fn explain(depths: &Depths, drawn: &Surface, picked: &Surface) -> Option<Reason> {
    if drawn.triangle.is_some() && drawn.triangle == picked.triangle {
        // Both sides come to the same one, edge by edge.
        return drawn.crossed;
    }
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
    // A neighbour's depth may be what counts.
    let may_cover = |surface: &Surface| {
        let reached = || Some(surface.crossed?.class);
        surface.covers.then_some(Class::Edge).or_else(reached)
    };
    let by_depth = may_cover(drawn).zip(may_cover(picked)).and_then(|(a, b)| {
        let reason = drawn.stored.reason(&picked.stored)?;
        Some(reason.and(a).and(b))
    });
    let all = [drawn_only, picked_only, by_depth];
    let best = all.into_iter().flatten().reduce(Reason::or)?;
    let is_lost = drawn.source == Source::Empty && !picked.is_at_plane(depths);
    Some(if is_lost && best.class == Class::Depth {
        best.and(Class::BeyondF32)
    } else {
        best
    })
}

/// A lens's depths as the GPU makes them. Depths count from the near plane (*past near*): that keeps digits both at the eye
/// and where near and far lie close together in the distance.
#[derive(Clone, Copy)]
pub(super) struct Depths {
    lens: Lens,
    unit: f64,
    /// From the near plane to where the depth buffer stores 0.
    origin: f64,
    /// What the depth buffer stores for a unit of measured depth, times w.
    per_measured: f64,
    /// A pixel's height in world units where w is 1.
    pixel_at_w_1: f64,
}

impl Depths {
    pub fn new(space: &ViewSpace) -> Self {
        let lens = *space.view().camera.lens();
        Self {
            lens,
            unit: space.unit(),
            origin: match lens.depth {
                DepthMapping::Reversed => lens.far - lens.near,
                DepthMapping::Standard => 0.0,
            },
            per_measured: lens.depth_row().0,
            pixel_at_w_1: 2.0 * space.view().half_extent().y
                / f64::from(space.view().viewport.height()),
        }
    }

    /// Clip space's w.
    pub fn w(&self, past_near: f64) -> f64 {
        self.lens.w(self.lens.near + past_near)
    }

    /// What the depth buffer stores, without any rounding.
    pub fn stored(&self, past_near: f64) -> f64 {
        self.per_measured * (past_near - self.origin) / self.w(past_near)
    }

    /// The same by nearness: more is nearer.
    pub fn nearness(&self, past_near: f64) -> f64 {
        match self.lens.depth {
            DepthMapping::Reversed => self.stored(past_near),
            DepthMapping::Standard => -self.stored(past_near),
        }
    }

    /// How far off the stored number may be.
    ///
    /// Rounded are the factor, its product with the measured depth, the reciprocal of w (2.5 units in the last place), the
    /// product with that and what is stored: 9 halves of a unit, and one for second order.
    pub fn error(&self, past_near: f64, error: &ViewError) -> f64 {
        let (w, stored) = (self.w(past_near), self.stored(past_near).abs());
        let of_w = match self.lens.projection {
            Projection::Perspective { .. } => error.depth,
            Projection::Orthographic { .. } => 0.0,
        };
        let measured = (past_near - self.origin).abs();
        let underflow =
            UNDERFLOW * ((self.unit * measured).max(1.0) / (self.unit * w).min(1.0) + 2.0);
        (self.per_measured.abs() * error.measured + stored * of_w) / w
            + 10.0 * U * stored
            + underflow
    }

    /// How far off in depth drawing may see the near plane. In reversed depth clipping compares a product of two rounded
    /// factors with w, as large as the near plane's depth (or 1); their difference changes with depth by 1 and the factor.
    /// In standard depth it looks at the sign of the measured depth.
    pub fn near_error(&self, error: &ViewError, exact: bool) -> f64 {
        let factor = self.per_measured.abs();
        let (w, of_w, change) = match self.lens.projection {
            Projection::Perspective { .. } => (self.lens.near, error.depth, 1.0 + factor),
            Projection::Orthographic { .. } => (1.0, 0.0, factor),
        };
        match self.lens.depth {
            DepthMapping::Standard => error.measured,
            DepthMapping::Reversed => {
                let product = if exact {
                    0.0
                } else {
                    2.0 * U * w + 2.0 * UNDERFLOW / self.unit
                };
                (product + factor * error.measured + of_w) / change
            }
        }
    }

    /// Whether `f32` holds what clipping compares at this depth.
    pub fn clips_exactly(&self, past_near: f64) -> bool {
        let (factor, measured) = match self.lens.projection {
            Projection::Perspective { .. } => {
                (self.per_measured, self.unit * (past_near - self.origin))
            }
            Projection::Orthographic { .. } => (
                self.per_measured / self.unit,
                self.unit * (past_near - self.origin),
            ),
        };
        #[expect(clippy::float_cmp, reason = "to the bit: it may have been rounded")]
        let is_exact = measured / self.unit + self.origin == past_near;
        is_exact && is_f32(factor) && is_f32(measured) && is_f32(factor * measured)
    }

    /// The most that the stored number may be off for drawing to hold the view: [`DEPTH_CEILING_STEPS`] of 2^-23 of the
    /// depth, or of the distance between near and far where that is less; and no more than half a pixel's width, as far
    /// as an outline may be off.
    ///
    /// In lengths, whatever the buffer stores: one that holds less is no excuse for showing more of it wrong.
    pub fn ceiling(&self, past_near: f64) -> f64 {
        self.stored_per_depth(past_near) * self.ceiling_world(past_near)
    }

    /// The same as a length along the line of sight.
    pub fn ceiling_world(&self, past_near: f64) -> f64 {
        let range = self.lens.far - self.lens.near;
        let w = self.w(past_near).abs();
        let known = match self.lens.projection {
            Projection::Perspective { .. } => range.min(w),
            Projection::Orthographic { .. } => range,
        };
        let steps = DEPTH_CEILING_STEPS * f64::from(f32::EPSILON) * known;
        let aside = OUTLINE_CEILING_PX * self.pixel_at_w_1 * w;
        steps.min(aside)
    }

    /// How fast the stored number changes with depth.
    pub fn stored_per_depth(&self, past_near: f64) -> f64 {
        match self.lens.projection {
            Projection::Perspective { .. } => {
                let w = self.w(past_near);
                self.per_measured.abs() * (self.lens.near + self.origin) / (w * w)
            }
            Projection::Orthographic { .. } => self.per_measured.abs(),
        }
    }
}

/// The ray through a pixel position in view space, z being depth past near: where it meets the near plane and its step for
/// one unit of depth; and the change of whichever moves for one pixel right and down.
pub(super) struct ViewRay {
    pub origin: DVec3,
    pub direction: DVec3,
    steps: [DVec3; 2],
    lens: Lens,
}

impl ViewRay {
    pub fn new(view: &View, px: DVec2) -> Self {
        let lens = *view.camera.lens();
        let grid = view.camera.pixel_grid(view.viewport).in_view_space();
        let ray = grid.differential::<f64>(px, DVec3::ZERO);
        let [origin, direction, right, down] =
            [ray.origin, ray.direction, ray.right, ray.down].map(Vector::narrow);
        Self {
            origin: (origin + lens.near * direction).with_z(0.0),
            direction,
            steps: [right, down],
            lens,
        }
    }

    /// Depth past near at which it meets the plane through `point` across `normal`.
    pub fn depth_on(&self, point: DVec3, normal: DVec3) -> f64 {
        normal.dot(point - self.origin) / normal.dot(self.direction)
    }

    /// Change of that depth for one pixel right and down, at a view depth. From `N . (o + z d - P) = 0`, where o or d
    /// moves.
    pub fn slope(&self, depth: f64, normal: DVec3) -> DVec2 {
        let [right, down] = self.steps;
        -self.lens.w(depth) * DVec2::new(normal.dot(right), normal.dot(down))
            / normal.dot(self.direction)
    }
}
