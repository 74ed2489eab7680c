//! The tour, as the program takes part in it.

use super::program::App;
use crate::viewer::ui::{Command, Intent, Seen, TourMove};

impl App {
    /// Goes on in the tour. It begins in the demo.
    pub(super) fn go_on_tour(&mut self, to: TourMove) {
        self.memory.toured = true;
        self.tour = self.tour.unwrap_or_default().after(to);
        if to == TourMove::Begin && !self.state.is_demo() {
            self.intend(Intent::Open(Vec::new()));
        }
    }

    /// Whether the tour is offered: to somebody who has opened nothing, and has not answered yet.
    pub(super) fn offers_tour(&self) -> bool {
        let remembers = self.options.memory.is_some();
        remembers && !self.memory.toured && self.state.is_demo()
    }

    /// Looks whether the tour's step is done by now, after a command or after whatever else came about.
    pub(super) fn notice_step(&mut self, command: Option<&Command>) {
        let Some(tour) = &mut self.tour else { return };
        let seen = Seen {
            command,
            state: &self.state,
            matrices: self.floating.pipeline,
            checking: &self.checking,
        };
        if tour.notice(&seen) {
            self.context.request_repaint();
        }
    }
}
