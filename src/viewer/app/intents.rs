//! Asks the user before anything that would drop edits or measures.

use super::{
    errands::{Pending, Purpose},
    program::App,
};
use crate::viewer::{
    model::Action,
    ui::{Intent, Reply},
};

impl App {
    /// Carries out an intent, or asks first if it would drop edits or measures.
    pub(super) fn intend(&mut self, intent: Intent) {
        self.propose(Pending {
            intent,
            arrival: None,
        });
    }

    /// Does what waited, or asks first if it would drop edits or measures.
    pub(super) fn propose(&mut self, pending: Pending) {
        if pending.intent.drops_nothing(&self.state) {
            self.carry_out(pending);
        } else {
            self.ask(pending);
        }
    }

    /// Asks a question, in place of the one before. What was loaded for the earlier one waits until this one is
    /// answered.
    pub(super) fn ask(&mut self, pending: Pending) {
        let before = self.question.replace(pending);
        let waits = before.and_then(|before| before.arrival);
        if let Some(arrival) = waits {
            self.ready = Some(*arrival);
        }
        self.context.request_repaint();
    }

    /// Acts on the user's answer to the question.
    pub(super) fn reply(&mut self, reply: Reply) {
        let Some(pending) = self.question.take() else {
            return;
        };
        match reply {
            Reply::Save => self.ask_where_to_save(Some(pending)),
            Reply::GoOn => self.carry_out(pending),
            Reply::Add => self.add_instead(pending),
            Reply::Stay => {}
        }
        self.take_ready();
    }

    /// Adds the files that were to be opened.
    fn add_instead(&mut self, pending: Pending) {
        match (pending.intent, pending.arrival) {
            (Intent::Open(_), Some(mut arrival)) => {
                arrival.errand.purpose = Purpose::Add;
                self.arrive(*arrival);
            }
            (Intent::Open(paths), None) => self.load(paths, Purpose::Add),
            _ => {}
        }
    }

    /// Goes on with what was asked about once there is nothing to ask any more: a save may have landed meanwhile.
    pub(super) fn take_settled(&mut self) {
        let state = &self.state;
        let settled = (self.question).take_if(|pending| pending.intent.drops_nothing(state));
        if let Some(pending) = settled {
            self.carry_out(pending);
            self.context.request_repaint();
        }
    }

    fn carry_out(&mut self, pending: Pending) {
        match (pending.intent, pending.arrival) {
            (Intent::Open(_) | Intent::Reload, Some(arrival)) => self.show_arrival(*arrival),
            (Intent::Open(paths), None) => self.load(paths, Purpose::Open),
            (Intent::Reload, None) => self.reload(),
            (Intent::LeaveGallery, _) => self.act(Action::LeaveGallery),
            (Intent::Quit, _) => {
                self.keep_memory();
                self.quit = true;
            }
        }
    }
}
