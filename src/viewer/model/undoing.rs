//! What can be undone: each change leaves a step that takes it back.

use super::state::{Edits, State, UndoStep, Viewpoint};
use std::mem;

impl State {
    /// Keeps a step back to how the view was, if it has changed. It leads back to where the view stood only if that
    /// has changed.
    pub(super) fn record_viewpoint(&mut self, was: &Viewpoint) {
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
            self.timeline.push(step);
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
        }
    }

    /// Gives an edit a number that the file does not have; returns the numbers before the edit.
    pub(super) fn edit(&mut self, which: impl FnOnce(&mut Edits) -> &mut u64) -> Edits {
        let before = self.edits;
        let mark = self.timeline.mark();
        *which(&mut self.edits) = mark;
        before
    }
}
