//! How far off drawing may be at a pixel, and what that explains. Bounds come from camera, scene and the driver's
//! rounding; nothing here knows what was drawn or picked.

use super::{Class, OUTLINE_CEILING_PX};
use crate::render::Rasteriser;

/// An outline near a pixel's centre; lengths in pixels.
#[derive(Clone, Copy, Debug)]
#[expect(clippy::struct_field_names, reason = "the unit")]
pub(super) struct Outline {
    /// Distance from the centre, in pixels; never overestimated.
    pub distance_px: f64,
    /// How far the rasteriser's grid may move it, in pixels: 0 where it has no vertices.
    pub grid_px: f64,
    /// How far `f32` may move it, in pixels.
    pub f32_px: f64,
}

/// Why a surface may be at a pixel for drawing but not for the pick, or vice versa.
#[derive(Clone, Copy, Debug)]
pub(super) struct Reason {
    pub class: Class,
    /// The error that it needs over the error that is allowed; at most 1.
    pub strain: f64,
    /// The outline that it rests on; [`Outline::NONE`] for a depth.
    pub outline: Outline,
}

/// What the depth buffer may hold for a surface at a pixel's centre, as nearness: more is nearer.
#[derive(Clone, Copy, Debug)]
pub(super) struct Stored {
    /// Without any rounding.
    pub nearness: f64,
    /// The nearest that drawing may make it.
    pub nearest: f64,
    /// The farthest that drawing may make it.
    pub farthest: f64,
    /// The part of these bounds that is due to rounding, without moving the surface aside.
    pub rounding: f64,
    /// The largest `rounding` in a view that `f32` can draw.
    pub ceiling: f64,
    /// Whether the bounds lie above a ceiling.
    pub beyond_f32: bool,
}

impl Outline {
    /// No outline.
    pub const NONE: Self = Self {
        distance_px: f64::INFINITY,
        grid_px: 0.0,
        f32_px: 0.0,
    };

    /// The most by which drawing may move it, in pixels.
    pub fn error_px(&self) -> f64 {
        self.grid_px + self.f32_px
    }

    /// What it explains: nothing when it is farther away than drawing may move it, or when there is no bound on that.
    pub fn reason(self) -> Option<Reason> {
        let error_px = self.error_px();
        let strain = strain(self.distance_px, error_px)?;
        let class = if self.f32_px <= self.grid_px.max(Rasteriser::COMMON.grid_px) {
            Class::Edge
        } else {
            Class::F32Limit
        };
        Some(Reason {
            class: class.within(beyond_f32(error_px, 0.0, 0.0)),
            strain,
            outline: self,
        })
    }

    /// The nearer of two, relative to how far drawing may move each; one without a bound wins.
    pub fn nearer(self, other: Self) -> Self {
        let [of_self, of_other] = [self, other].map(|at| {
            if at.is_bounded() {
                at.distance_px / at.error_px()
            } else {
                f64::NEG_INFINITY
            }
        });
        if of_other < of_self { other } else { self }
    }

    /// Whether there is a bound on how far drawing may move it.
    pub fn is_bounded(&self) -> bool {
        self.error_px().is_finite()
    }
}

impl Reason {
    /// What the near plane explains for a surface at distance `gap` from it in depth. `grid` and `f32` are how much the
    /// rasteriser's grid and `f32` arithmetic may change that depth. `beyond_f32` says that the depth's bounds exceed a
    /// ceiling.
    pub fn at_near_plane(gap: f64, [grid, f32]: [f64; 2], beyond_f32: bool) -> Option<Self> {
        let class = if f32 <= grid {
            Class::Edge
        } else {
            Class::Depth
        };
        let strain = strain(gap, grid + f32)?;
        Some(Self::without_outline(class.within(beyond_f32), strain))
    }

    /// One that rests on no outline.
    pub fn without_outline(class: Class, strain: f64) -> Self {
        Self {
            class,
            strain,
            outline: Outline::NONE,
        }
    }

    /// The better of two: by class, then by less strain.
    pub fn or(self, other: Self) -> Self {
        if (other.class, other.strain) < (self.class, self.strain) {
            other
        } else {
            self
        }
    }

    /// This reason where one of `class` has to hold, too: beyond `f32` if either is.
    pub fn and(self, class: Class) -> Self {
        let class = self.class.within(class == Class::BeyondF32);
        Self { class, ..self }
    }
}

impl Stored {
    /// Where both cover a pixel, why drawing may show this surface in front of `other`: [`Class::Edge`], the most
    /// harmless, where it really is in front; `None` where drawing cannot show it there.
    pub fn hides(&self, other: &Self) -> Option<Class> {
        if self.nearness >= other.nearness {
            return Some(Class::Edge);
        }
        (self.nearest >= other.farthest).then(|| self.class_with(other))
    }

    /// Whether it really comes first where both cover a pixel, to within rounding. Picks do not depend on how far
    /// drawing moves surfaces aside.
    pub fn precedes(&self, other: &Self) -> bool {
        self.nearness + self.rounding >= other.nearness - other.rounding
    }

    /// What two surfaces that both cover a pixel explain: nothing unless the buffer may order them either way. Without
    /// any error they have one order only.
    pub fn reason(&self, other: &Self) -> Option<Reason> {
        let (near, far) = if self.nearness < other.nearness {
            (other, self)
        } else {
            (self, other)
        };
        let allowed = (near.nearness - near.farthest) + (far.nearest - far.nearness);
        let strain = strain(near.nearness - far.nearness, allowed)?;
        // Two surfaces closer together than the ceiling are harmless, whatever the bounds.
        let class = if near.capped().farthest <= far.capped().nearest {
            Class::Depth
        } else {
            self.class_with(other)
        };
        Some(Reason::without_outline(class, strain))
    }

    /// Whether the buffer may order two surfaces that both cover a pixel either way; a bound above a ceiling counts as
    /// the ceiling.
    pub fn is_in_one_place(&self, other: &Self) -> bool {
        self.capped().reason(&other.capped()).is_some()
    }

    /// Whether rounding alone may order the two either way, for surfaces that drawing moves aside together.
    pub fn is_in_one_place_unmoved(&self, other: &Self) -> bool {
        (self.nearness - other.nearness).abs() <= self.rounding + other.rounding
    }

    /// With depth bounds capped to the ceiling, where a bound exceeds one.
    fn capped(&self) -> Self {
        if !self.beyond_f32 {
            return *self;
        }
        Self {
            nearest: self.nearest.min(self.nearness + self.ceiling),
            farthest: self.farthest.max(self.nearness - self.ceiling),
            ..*self
        }
    }

    /// Whether there is a bound on how far off the buffer may be.
    pub fn is_bounded(&self) -> bool {
        self.nearest.is_finite() && self.farthest.is_finite() && self.rounding.is_finite()
    }

    fn class_with(&self, other: &Self) -> Class {
        Class::Depth.within(self.beyond_f32 || other.beyond_f32)
    }
}

/// Whether the bound aside, in pixels, or the bound in depth exceeds its ceiling, so that `f32` cannot draw the view.
pub(super) fn beyond_f32(error_px: f64, depth_error: f64, depth_ceiling: f64) -> bool {
    !(error_px <= OUTLINE_CEILING_PX && depth_error <= depth_ceiling)
}

/// `needed / allowed` where that is at most 1. An `allowed` of 0, infinity or NaN allows nothing.
pub(super) fn strain(needed: f64, allowed: f64) -> Option<f64> {
    (allowed > 0.0 && allowed.is_finite() && needed <= allowed).then(|| needed / allowed)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_nearer_outline_is_the_one_that_drawing_reaches_more_easily() {
        let outline = |distance_px, grid_px| Outline {
            distance_px,
            grid_px,
            f32_px: 0.0,
        };
        let (far, near) = (outline(1.0, 2.0), outline(0.1, 0.01));
        let unbounded = outline(9.0, f64::NAN);
        for (a, b, expected) in [(far, near, far), (near, unbounded, unbounded)] {
            for nearer in [a.nearer(b), b.nearer(a)] {
                assert_eq!(nearer.distance_px.to_bits(), expected.distance_px.to_bits());
            }
        }
    }

    #[test]
    fn surfaces_within_their_rounding_precede_each_other() {
        let stored = |nearness| Stored {
            nearness,
            nearest: nearness,
            farthest: nearness,
            rounding: 1.0,
            ceiling: 0.0,
            beyond_f32: false,
        };
        let [far, within, near] = [0.0, 1.5, 3.0].map(stored);
        assert!(far.precedes(&within) && within.precedes(&near) && near.precedes(&far));
        assert!(!far.precedes(&near));
    }

    #[test]
    fn a_bound_of_zero_allows_nothing() {
        assert_eq!(strain(0.5, 1.0), Some(0.5));
        for allowed in [0.0, f64::INFINITY, f64::NAN] {
            assert_eq!(strain(0.0, allowed), None);
        }
    }
}
