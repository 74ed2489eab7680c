//! Sliding and dragging: what is changed from press to release is undone as one.

use crate::viewer::{model::Action, ui::command::Command};
use egui::Response;

/// What a control that can be slid or dragged did in this pass.
#[derive(Clone, Copy, Default)]
pub(super) struct Gesture {
    goes_on: bool,
    ended: bool,
}

impl Gesture {
    /// Takes note of such a control.
    pub fn note(&mut self, response: &Response) {
        self.goes_on |= response.dragged();
        self.ended |= response.drag_stopped();
    }

    /// Asks for what was changed, if anything was, and ends the step with the gesture.
    pub fn push(self, action: Option<Action>, commands: &mut Vec<Command>) {
        let changed = action.is_some();
        commands.extend(action.map(Command::Act));
        if self.ended || changed && !self.goes_on {
            commands.push(Command::Act(Action::Release));
        }
    }
}
