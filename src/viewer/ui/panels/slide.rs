//! Sliding and dragging: all changes from press to release are one undo step.

use super::prelude::*;

/// What a control that can be slid or dragged did in this pass.
#[derive(Clone, Copy, Default)]
pub(super) struct Slide {
    goes_on: bool,
    ended: bool,
}

impl Slide {
    /// Notes what a control that can be slid or dragged did.
    pub fn note(&mut self, response: &Response) {
        self.goes_on |= response.dragged();
        self.ended |= response.drag_stopped();
    }

    /// Asks for the change, if there is one, and ends the undo step with the slide.
    pub fn push(self, action: Option<Action>, commands: &mut Vec<Command>) {
        let changed = action.is_some();
        commands.extend(action.map(Command::Act));
        if self.ended || changed && !self.goes_on {
            commands.push(Command::Act(Action::Release));
        }
    }
}
