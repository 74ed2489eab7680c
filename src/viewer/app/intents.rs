//! What opens, reads, saves or closes: it waits for what is under way, and asks before it would drop edits or measures.

use super::{
    modal::{Modal, Purpose},
    program::App,
    wake::PathFor,
};
use crate::viewer::{
    model::Action,
    ui::{Intent, Reply, Underway},
};

impl App {
    /// Whether nothing blocks what opens, reads or saves; else says what does.
    pub(super) fn is_free(&mut self) -> bool {
        let blocked = self.modal.blocks();
        if let Some(by) = blocked {
            self.say(by.into());
        }
        blocked.is_none()
    }

    /// Whether an edit has to wait for a load, which may replace the scene. Says so.
    pub(super) fn waits(&mut self, action: &Action) -> bool {
        let is_loading = matches!(self.modal, Modal::Loading(_));
        is_loading && action.rules().edits && !self.is_free()
    }

    /// Carries out an intent, or asks first if it would drop edits or measures. To open other files ends a load or
    /// the wait for files to open; to close the window ends these and the wait for a file to save to.
    pub(super) fn intend(&mut self, intent: Intent) {
        match (&mut self.modal, &intent) {
            (Modal::Saving(.., then), Intent::Quit) => {
                *then = Some(intent);
                return;
            }
            (Modal::Loading(_), Intent::Open(_) | Intent::Quit)
            | (Modal::Dialog(PathFor::Open, _), Intent::Open(_))
            | (Modal::Dialog(..), Intent::Quit) => self.modal = Modal::None,
            _ => {}
        }
        if !self.is_free() {
            return;
        }
        if intent.drops_nothing(&self.state) {
            self.carry_out(intent);
        } else {
            self.modal = Modal::Question(intent);
            self.context.request_repaint();
        }
    }

    /// Acts on the user's answer to the question.
    pub(super) fn reply(&mut self, reply: Reply) {
        let asks = |modal: &Modal| matches!(modal, Modal::Question(_));
        let Modal::Question(intent) = self.modal.take_if(asks) else {
            return;
        };
        match (reply, intent) {
            (Reply::Save, intent) => self.ask_where_to_save(Some(intent)),
            (Reply::GoOn, intent) => self.carry_out(intent),
            (Reply::Add, Intent::Open(paths)) => self.load(paths, Purpose::Add),
            (Reply::Add | Reply::Stay, _) => {}
        }
    }

    /// Does what drops nothing of the scene on show that the user wants to keep. A scene that was left for the gallery
    /// comes back first if it is to be asked about, too.
    fn carry_out(&mut self, intent: Intent) {
        self.modal = Modal::None;
        let drops_outside = (self.state.outside())
            .is_some_and(|outside| intent.closes() && !intent.drops_nothing(outside));
        match intent {
            _ if drops_outside => {
                self.leave_gallery();
                self.intend(intent);
            }
            Intent::Open(paths) => self.load(paths, Purpose::Open),
            Intent::Reload => self.reload(),
            Intent::LeaveGallery => self.leave_gallery(),
            Intent::Quit => {
                self.keep_memory();
                self.quit = true;
            }
        }
    }

    /// Cancels loading. Returns whether there was anything to cancel.
    pub(super) fn stop_loading(&mut self) -> bool {
        let loads = |modal: &Modal| matches!(modal, Modal::Loading(_));
        let Modal::Loading(load) = self.modal.take_if(loads) else {
            return false;
        };
        self.give_up_change(load.purpose);
        true
    }

    /// Whether a file dialog is open.
    pub fn has_dialog(&self) -> bool {
        matches!(self.modal, Modal::Dialog(..))
    }

    /// What is being loaded, for the progress message.
    pub(super) fn underway(&self) -> Option<Underway> {
        match &self.modal {
            Modal::Loading(load) => Some(("loading", Some(load.job.fraction()))),
            _ => None,
        }
    }
}
