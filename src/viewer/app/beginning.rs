//! What the tour's steps and the pick in four spaces begin with: the demo's picture as it opened, with one pick.

use super::program::App;
use crate::viewer::{
    model::{Action, MeasureAction, Views},
    ui::Start,
};

impl App {
    /// Begins so as soon as the demo is on show and laid out; `None` begins nothing.
    pub(super) fn begin(&mut self, start: Option<Start>) {
        self.unfold(start);
        let now = self.context.cumulative_pass_nr();
        self.beginning = start.map(|start| (start, now));
        self.context.request_repaint();
    }

    fn unfold(&mut self, start: Option<Start>) {
        for topic in start.map_or(&[][..], |start| start.topics) {
            self.memory.panels.show(*topic);
        }
    }

    /// Begins what waits for it, if it can.
    pub(super) fn take_beginning(&mut self) {
        if !self.state.is_demo() {
            return;
        }
        let now = self.context.cumulative_pass_nr();
        // What was unfolded has changed the picture's size.
        let is_laid_out = |(_, asked_in): &mut (Start, u64)| now > *asked_in + 1;
        let Some((start, _)) = self.beginning.take_if(is_laid_out) else {
            if self.beginning.is_some() {
                self.context.request_repaint();
            }
            return;
        };
        self.show_views(Views::Picture);
        if self.state.frozen().is_some() {
            self.act(Action::ToggleFreeze);
        }
        if self.state.measuring().is_on {
            self.act(Action::Measure(MeasureAction::Toggle));
        }
        self.act(Action::PickBy(None));
        self.act(Action::Section(None));
        self.act(Action::ResetView);
        self.act(Action::Select(None));
        if let Some(name) = start.picked {
            self.state.pick_middle_of(name);
        }
        for command in (start.then)(&self.state) {
            self.run_command(command);
        }
        // The four views have brought the matrices into view.
        self.unfold(Some(start));
        self.context.request_repaint();
    }
}
