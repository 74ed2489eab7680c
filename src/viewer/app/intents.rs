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

    /// Carries out an intent, or asks first if it would drop edits or measures. To open other files or to close the
    /// window ends a load, and the wait for files to open. To close the window also ends the wait for a file to save to.
    /// It closes after a save, or when asked to once more.
    pub(super) fn intend(&mut self, intent: Intent) {
        match (&mut self.modal, &intent) {
            (Modal::Saving(.., then), Intent::Quit) if *then != Some(Intent::Quit) => {
                *then = Some(intent);
                return self.say("the window closes once the scene is saved".into());
            }
            (
                Modal::Loading(_) | Modal::Dialog(_, PathFor::Open, _),
                Intent::Open(_) | Intent::Quit,
            )
            | (Modal::Dialog(..) | Modal::Saving(..), Intent::Quit) => self.modal = Modal::None,
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

    /// Begins to wait for the answer of another file dialog. Returns its number.
    pub(super) fn wait_for_dialog(&mut self, what: PathFor, then: Option<Intent>) -> u64 {
        self.dialogs += 1;
        self.modal = Modal::Dialog(self.dialogs, what, then);
        self.dialogs
    }

    /// The number of the dialog that was opened last. Where nothing waits, opens one first.
    pub fn last_dialog(&mut self, what: PathFor) -> u64 {
        if matches!(self.modal, Modal::None) {
            self.wait_for_dialog(what, None);
        }
        self.dialogs
    }

    /// Waits no longer for a file dialog. Returns whether it did.
    pub(super) fn give_up_dialog(&mut self) -> bool {
        let waits = self.has_dialog();
        if waits {
            self.modal = Modal::None;
        }
        waits
    }

    /// Whether a file dialog is open.
    pub fn has_dialog(&self) -> bool {
        matches!(self.modal, Modal::Dialog(..))
    }

    /// What is being loaded or saved, for the progress message.
    pub(super) fn underway(&self) -> Option<Underway> {
        match &self.modal {
            Modal::Loading(load) => Some(("loading", Some(load.job.fraction()))),
            Modal::Saving(..) => Some(("saving", None)),
            _ => None,
        }
    }
}
