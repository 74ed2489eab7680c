//! Clicks in the gallery, picked by a method of the study.

use super::{
    showing::Compared,
    state::{Selection, State},
};
use crate::study::swap::Swap;
use glam::DVec2;

impl State {
    /// Sets the method that picks, `None` for Sightline's own, and repeats the last click by it.
    pub(super) fn pick_by(&mut self, method: Option<Swap>) {
        let Some(showing) = &mut self.showing else {
            return;
        };
        showing.method = method;
        let compared = showing.compared.take().map(|compared| compared.px);
        let picked = self
            .selection
            .as_ref()
            .and_then(|selection| selection.pick.as_ref());
        let px = compared.or_else(|| picked.map(|line| line.px));
        match px {
            Some(px) if self.method().is_some() => self.compare(px),
            Some(px) => drop(self.click(px, 0.0)),
            None => {}
        }
        // The next click there picks the nearest surface again.
        self.clicked_s = None;
    }

    /// A click by the method that is set. The object that it finds is selected, right or wrong, but not as a pick of
    /// Sightline's.
    pub(super) fn compare(&mut self, px: DVec2) {
        let Some(method) = self.method() else { return };
        let compared = Compared::at(&self.scene, &self.view, &method, px);
        let object = compared.theirs.map(|found| found.hit.object);
        self.selection = object.map(|object| Selection { object, pick: None });
        self.hits = None;
        if let Some(showing) = &mut self.showing {
            showing.compared = Some(compared);
        }
    }
}
