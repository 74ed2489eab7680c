//! What would drop edits is asked about first.

use super::program::{App, Purpose};
use crate::{
    scene::gallery::Exhibit,
    viewer::ui::{Intent, Reply},
};
use std::path::Path;

impl App {
    /// Does it, or asks first where it would drop edits.
    pub(super) fn intend(&mut self, intent: Intent) {
        let drops = match &intent {
            // The gallery leaves the way back open.
            Intent::Open(paths) => !is_exhibit(paths) && self.state.unsaved(),
            Intent::Reload => self.state.edited(),
            Intent::Quit => self.state.unsaved(),
        };
        if drops {
            self.question = Some(intent);
            self.context.request_repaint();
        } else {
            self.carry_out(intent);
        }
    }

    /// Does what the user answered to the question.
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
            Intent::Quit => {
                self.keep_memory();
                self.quit = true;
            }
        }
    }
}

/// Whether files are a single scene of the gallery.
fn is_exhibit(paths: &[impl AsRef<Path>]) -> bool {
    match paths {
        [only] => matches!(Exhibit::at(only.as_ref()), Ok(Some(_))),
        _ => false,
    }
}
