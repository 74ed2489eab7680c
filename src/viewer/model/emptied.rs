//! Whether nothing of the scene is in the picture, why, and what brings it back.

use super::{action::Action, state::State};
use crate::{camera::View, geometry::Section};

/// What leaves the picture empty.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum EmptiedBy {
    /// The section cuts away all that would be in view.
    Section,
    /// No object is between near and far, at least one of which is set by hand.
    Planes,
    /// The camera looks elsewhere.
    Pose,
    /// The camera is so far away that all of the scene is within two pixels.
    Distance,
}

impl State {
    /// Whether a visible object may be in the picture of a view. Judged by the boxes about objects and by the corners
    /// of the view volume.
    pub(super) fn may_show(&self, view: &View) -> bool {
        let keeps = |section: Section| {
            let mut corners = view.frustum_corners().into_iter();
            corners.any(|corner| section.side(corner) >= 0.0)
        };
        view.section.is_none_or(keeps) && self.scene.any_visible(|bounds| view.may_see(bounds))
    }

    /// Whether all that is visible looks less than `px` wide, as a ball about it would. A scene of one point has no size.
    fn is_within(&self, px: f64) -> bool {
        let bounds = self.scene.visible_bounds();
        let diameter = 2.0 * bounds.radius();
        let looks = (self.view).px_across(diameter, bounds.center());
        diameter > 0.0 && looks.is_some_and(|looks| looks < px)
    }

    /// What leaves the picture without any of the visible objects, or with none of a size that one can see, and the
    /// actions that bring some into view. `None` if one may be seen.
    pub fn emptied(&self) -> Option<(EmptiedBy, Vec<Action>)> {
        let view = self.view;
        if self.may_show(&view) {
            let is_tiny = self.is_within(2.0);
            return is_tiny.then(|| (EmptiedBy::Distance, vec![Action::FrameAll]));
        }
        let uncut = view.uncut();
        let fits = |view: View| {
            let camera = self.camera_with(&self.controls.fitted());
            camera.is_ok_and(|camera| self.may_show(&View { camera, ..view }))
        };
        let is_cut = view.section.is_some() && self.takes_sections();
        let cut_off = Action::Section(None);
        let fit = Action::Lens(self.controls.fitted());
        let keeps = |section: Section| {
            let kept = |corner| section.side(corner) >= 0.0;
            (self.scene).any_visible(|bounds| bounds.corners().into_iter().any(kept))
        };
        Some(if is_cut && self.may_show(&uncut) {
            (EmptiedBy::Section, vec![cut_off])
        } else if fits(view) {
            (EmptiedBy::Planes, vec![fit])
        } else if is_cut && fits(uncut) {
            (EmptiedBy::Section, vec![cut_off, fit])
        } else if is_cut && !view.section.is_some_and(keeps) {
            (EmptiedBy::Section, vec![cut_off, Action::FrameAll])
        } else {
            (EmptiedBy::Pose, vec![Action::FrameAll])
        })
    }
}
