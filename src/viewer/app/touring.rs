//! The program's part in the tour.

use super::program::App;
use crate::viewer::ui::{Command, Intent, JustDone, TourMove};

impl App {
    /// Moves through the tour. The tour begins by opening the demo. The panel that a step is about becomes visible.
    pub(super) fn go_on_tour(&mut self, to: TourMove) {
        self.memory.toured = true;
        self.tour = self.tour.unwrap_or_default().after(to);
        if let Some(panel) = self.tour.and_then(|tour| tour.step().2.panel) {
            self.docks.show(panel);
        }
        if to == TourMove::Begin && !self.state.is_demo() {
            self.intend(Intent::Open(Vec::new()));
        }
    }

    /// Whether the tour is offered: as long as the demo is shown and the user has not answered.
    pub(super) fn offers_tour(&self) -> bool {
        let remembers = self.options.memory.is_some();
        remembers && !self.memory.toured && self.state.is_demo()
    }

    /// Checks whether the tour's step is done, after a command or any other change.
    pub(super) fn notice_step(&mut self, command: Option<&Command>) {
        let Some(tour) = &mut self.tour else { return };
        let done = JustDone {
            command,
            state: &self.state,
            matrices: self.floating.pipeline,
            checking: &self.checking,
        };
        if tour.notice(&done) {
            self.context.request_repaint();
        }
    }
}
