//! Asks the user before anything that would drop edits.

use super::program::{App, Purpose};
use crate::viewer::{
    model::Action,
    ui::{Intent, Reply},
};

impl App {
    /// Carries out an intent, or asks first if it would drop edits.
    pub(super) fn intend(&mut self, intent: Intent) {
        if intent.drops(&self.state).is_empty() {
            self.carry_out(intent);
        } else {
            self.question = Some(intent);
            self.context.request_repaint();
        }
    }

    /// Acts on the user's answer to the question.
    pub(super) fn reply(&mut self, reply: Reply) {
        let Some(intent) = self.question.take() else {
            return;
        };
        match (reply, intent) {
            (Reply::Save, intent) => self.ask_where_to_save(Some(intent)),
            (Reply::GoOn, intent) => self.carry_out(intent),
            (Reply::Add, Intent::Open(paths)) => self.load(paths, Purpose::Add),
            (Reply::Stay | Reply::Add, _) => {}
        }
    }

    fn carry_out(&mut self, intent: Intent) {
        match intent {
            Intent::Open(paths) => self.load(paths, Purpose::Open),
            Intent::Reload => self.reload(),
            Intent::LeaveGallery => self.act(Action::LeaveGallery),
            Intent::Quit => {
                self.keep_memory();
                self.quit = true;
            }
        }
    }
}
