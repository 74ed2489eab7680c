//! What can be undone: each change leaves a step that takes it back.

use super::{
    state::{Edits, State, UndoStep, Viewpoint},
    timeline::Gesture,
};
use std::mem;

impl UndoStep {
    /// Whether it leads back to what was open before the gallery. Such a step is never forgotten.
    fn leads_out(&self) -> bool {
        matches!(self, Self::Open(state) if state.showing.is_none())
    }
}

impl State {
    /// Keeps the step that takes back what was just done. Within a gesture, only the first change leaves a step.
    pub(super) fn record(&mut self, gesture: Option<Gesture>, step: UndoStep) {
        self.timeline.push(gesture, step, UndoStep::leads_out);
    }

    /// Keeps a step back to how the view was, if it has changed. It leads back to where the view stood only if that
    /// has changed.
    pub(super) fn record_viewpoint(&mut self, gesture: Option<Gesture>, was: &Viewpoint) {
        let now = self.viewpoint();
        let cut = Viewpoint {
            section: now.section,
            sides: now.sides,
            ..*was
        };
        let step = if cut == now {
            UndoStep::Cut(was.section, was.sides)
        } else {
            UndoStep::Viewpoint(*was)
        };
        if *was != now {
            self.record(gesture, step);
        }
    }

    /// Takes back the last change, or makes the change again that was taken back last. Returns whether there was one.
    pub(super) fn step_in_time(&mut self, back: bool) -> bool {
        let Some(step) = self.timeline.take(back) else {
            return false;
        };
        let inverse = self.take_back(step);
        self.timeline.give(inverse, back);
        true
    }

    /// Goes back to what was open before the gallery; does nothing if nothing was open.
    pub(super) fn leave_gallery(&mut self) {
        if self.showing.is_some() && self.has_outside() {
            while self.showing.is_some() && self.step_in_time(true) {}
        }
    }

    /// Whether something was open before the gallery.
    pub fn has_outside(&self) -> bool {
        self.timeline.steps(true).iter().any(UndoStep::leads_out)
    }

    /// Does what a step says; returns the step that does the opposite.
    fn take_back(&mut self, step: UndoStep) -> UndoStep {
        match step {
            UndoStep::Edited(edit, edits, chosen) => {
                let edits = mem::replace(&mut self.edits, edits);
                let now = self.chosen.clone();
                let inverse = UndoStep::Edited(self.make(edit), edits, now);
                self.chosen = chosen;
                inverse
            }
            UndoStep::Viewpoint(viewpoint) => {
                let inverse = UndoStep::Viewpoint(self.viewpoint());
                self.restore_viewpoint(&viewpoint);
                inverse
            }
            UndoStep::Cut(section, sides) => {
                let now = self.viewpoint();
                self.restore_viewpoint(&Viewpoint {
                    section,
                    sides,
                    ..now
                });
                UndoStep::Cut(now.section, now.sides)
            }
            UndoStep::Measured(list) => {
                UndoStep::Measured(mem::replace(&mut self.measuring.list, list))
            }
            UndoStep::Open(state) => UndoStep::Open(self.exchange(state)),
        }
    }

    /// Shows another state; the window's settings and the history stay. Returns the state before.
    pub(super) fn exchange(&mut self, mut other: Box<State>) -> Box<State> {
        other.timeline = mem::take(&mut self.timeline);
        other.scene_revision = self.scene_revision + 1;
        other.visibility_revision = self.visibility_revision + 1;
        (other.grid, other.overlays) = (self.grid, self.overlays);
        other.panes = self.panes.take();
        // The picture on screen is still of the scene before.
        other.seen = self.seen;
        other.measuring.is_on = self.measuring.is_on;
        other.view.viewport = self.view.viewport;
        (other.cursor, other.lit, other.clicked_s) = (None, None, None);
        mem::swap(self, &mut *other);
        self.fit();
        self.refresh_panes();
        other
    }

    /// Gives an edit a number that the file does not have; returns the numbers before the edit.
    pub(super) fn edit(&mut self, which: impl FnOnce(&mut Edits) -> &mut u64) -> Edits {
        let before = self.edits;
        let mark = self.timeline.mark();
        *which(&mut self.edits) = mark;
        before
    }
}
