//! The click before: whether the next one goes on to the surface behind, or is the second of a double click.

use super::{chosen::Chosen, measuring::MeasuredPoint, stages::Stage};
use crate::camera::View;
use glam::{DVec2, DVec3};

/// Two clicks that are more seconds apart are two picks, not a double click.
pub const DOUBLE_CLICK_S: f64 = 0.3;

/// Where a click was: in which of the four views, or in the camera's picture, at which pixel's centre, in which view.
pub(super) type Place = (Option<Stage>, DVec2, View);

/// The click before.
pub(super) struct LastClick {
    place: Place,
    time_s: f64,
    /// What it cleared, being on nothing.
    pub cleared: Option<Cleared>,
}

/// What a click on nothing clears.
pub(super) struct Cleared {
    pub chosen: Chosen,
    pub points: Vec<MeasuredPoint>,
    /// The point that was followed in the four views.
    pub point: Option<(usize, DVec3)>,
}

impl LastClick {
    /// The click after `last`, if there was one. Also returns whether it is on the same pixel of the same view as that
    /// one, and not the second of a double click. The second keeps what the first has cleared.
    pub fn after(last: Option<Self>, place: &Place, time_s: f64) -> (Self, bool) {
        let is_apart = |last: &Self| time_s - last.time_s > DOUBLE_CLICK_S;
        let is_again = (last.as_ref()).is_some_and(|last| last.place == *place && is_apart(last));
        let first = last.filter(|last| !is_apart(last));
        let this = Self {
            place: *place,
            time_s,
            cleared: first.and_then(|first| first.cleared),
        };
        (this, is_again)
    }
}
