//! Decides whether the section keeps a surface at a pixel, and whether drawing may decide otherwise.
//!
//! The shaders' test ([`ScreenSection`]) takes a pixel's position and its q. A face moved aside has another q there: it
//! changes by q's slope times the distance.
//!
//! Bounds have a ceiling: the section is misplaced by at most [`Depths::section_ceiling_world`], plus the change of the
//! surface's q over half a pixel.

use super::{
    Class, OUTLINE_CEILING_PX,
    bound::{self, Reason},
    surface::Depths,
};
use crate::render::{
    rounding::U,
    section::{ScreenSection, q},
    transform::ViewError,
    view_space::ViewSpace,
};
use glam::DVec2;

/// A surface at a pixel, as a section sees it.
pub(super) struct AtSection {
    /// Whether it is kept at the centre.
    pub keeps: bool,
    /// Whether drawing may keep it.
    pub may_keep: bool,
    /// Why drawing may decide otherwise than `keeps`.
    pub reason: Option<Reason>,
}

/// A section in a view.
pub(super) struct Sectioned<'a> {
    space: &'a ViewSpace,
    depths: Depths,
    screen: Option<ScreenSection>,
}

impl<'a> Sectioned<'a> {
    pub fn new(space: &'a ViewSpace) -> Self {
        Self {
            space,
            depths: Depths::new(space),
            screen: ScreenSection::of(space.view()),
        }
    }

    /// The q of a fragment at a depth past near.
    pub fn q(&self, past_near: f64) -> f64 {
        q(self.space, past_near)[0]
    }

    /// Tests a face, given its depth past near at a pixel's centre and its slope in depth per pixel. The grid and
    /// `f32` move it aside by up to `grid_px` and `f32_px`. `error` is the error of `f32`; `interpolation` is that of
    /// interpolating [`Sectioned::q`] over the face.
    pub fn face(
        &self,
        px: DVec2,
        past_near: f64,
        slope: DVec2,
        [grid_px, f32_px]: [f64; 2],
        error: &ViewError,
        interpolation: impl FnOnce() -> f64,
    ) -> AtSection {
        let Some(screen) = &self.screen else {
            return AtSection::WHOLE;
        };
        let per_depth = q(self.space, past_near)[1];
        let of_q = screen.per_q * per_depth * slope;
        let aside_px = grid_px + f32_px;
        // The shaders keep this much of what is cut away. It is rounded once, and once in a sum.
        let slack = (1.0 + 2.0 * U) * screen.corner_slack();
        let moved = of_q.length() * aside_px + slack;
        let room = of_q.length() * OUTLINE_CEILING_PX;
        let off = screen.per_q.abs() * interpolation();
        self.at(screen, px, past_near, error, aside_px, [moved, off, room])
    }

    /// Tests a sphere. Nothing moves it aside; half a pixel aside would change its depth by `of_slope`.
    pub fn sphere(&self, px: DVec2, past_near: f64, of_slope: f64, error: &ViewError) -> AtSection {
        let Some(screen) = &self.screen else {
            return AtSection::WHOLE;
        };
        let per_depth = q(self.space, past_near)[1];
        let room = (screen.per_q * per_depth).abs() * of_slope;
        self.at(screen, px, past_near, error, 0.0, [0.0, 0.0, room])
    }

    /// Tests a surface that moves aside by up to `aside_px`. `moved` is the error of the test's value from that, with
    /// the slack for it, and `off` the error from all else so far. `room` is the ceiling's part for moving aside.
    fn at(
        &self,
        screen: &ScreenSection,
        px: DVec2,
        past_near: f64,
        error: &ViewError,
        aside_px: f64,
        [moved, off, room]: [f64; 3],
    ) -> AtSection {
        let [q, per_depth] = q(self.space, past_near);
        let value = screen.value(px, q);
        // The error of q: a reciprocal's (2.5 units in the last place), or the stored depth's.
        let off_q = if self.space.view().camera.lens().is_orthographic() {
            self.depths.error(past_near, error)
        } else {
            per_depth.abs() * error.depth + 6.0 * U * q
        };
        let off = off + screen.per_q.abs() * off_q + screen.bound(px, q);
        let length = self.depths.section_ceiling_world(past_near);
        let ceiling = screen.per_length * length / self.depths.w(past_near) + room;
        let strain = bound::strain(value.abs(), moved + off);
        let class = Class::Section.within(bound::beyond_f32(aside_px, off, ceiling));
        let reason = strain.map(|strain| Reason::without_outline(class, strain));
        AtSection {
            keeps: value >= 0.0,
            // NaN and an infinite bound leave it open.
            may_keep: !(value < -(moved + off)),
            reason,
        }
    }
}

impl AtSection {
    /// What holds without a section.
    const WHOLE: Self = Self {
        keeps: true,
        may_keep: true,
        reason: None,
    };
}
