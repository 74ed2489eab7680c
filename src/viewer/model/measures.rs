//! Changes to the list of measures.

use super::{
    measuring::{MeasureAction, Measuring},
    state::{State, Step},
};
use crate::pick::{measure::Measured, snap::Snap};

impl State {
    /// The points that clicks snapped to, and what was measured.
    #[must_use]
    pub fn measuring(&self) -> &Measuring {
        &self.measuring
    }

    pub(super) fn measure(&mut self, action: MeasureAction) {
        let list = self.measuring.list.clone();
        match action {
            MeasureAction::Toggle => {
                self.measuring.is_on ^= true;
                self.forget_points();
            }
            MeasureAction::Add(what) => {
                let entry = self.measuring.entry(what);
                self.measuring.list.extend(entry);
            }
            MeasureAction::Remove(at) if at < list.len() => drop(self.measuring.list.remove(at)),
            MeasureAction::Remove(_) => {}
            MeasureAction::Clear => self.measuring.list.clear(),
        }
        if self.measuring.list != list {
            self.record(None, Step::Measured(list));
        }
    }

    /// Takes the point that a click snapped to.
    pub(in crate::viewer) fn take_snap(&mut self, snap: Snap, object_area: Option<Measured>) {
        let points = &mut self.measuring.points;
        points.push(snap);
        let old = points.len().saturating_sub(2);
        points.drain(..old);
        self.measuring.object_area = object_area;
    }

    /// Drops the points: they may have moved with the scene.
    pub(super) fn forget_points(&mut self) {
        self.measuring.points.clear();
        self.measuring.object_area = None;
    }

    /// Marks every measure as taken before the scene changed.
    pub(super) fn outdate_measures(&mut self) {
        for entry in &mut self.measuring.list {
            entry.outdated = true;
        }
    }
}
