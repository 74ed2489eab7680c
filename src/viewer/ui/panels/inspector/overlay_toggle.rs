//! A checkbox that shows an overlay.

use super::prelude::*;
use crate::viewer::{model::Overlay, ui::menus::item_of};

/// Named as in the menu.
pub(super) fn show(ui: &mut Ui, state: &State, which: Overlay, commands: &mut Vec<Command>) {
    let command = Command::Act(Action::Toggle(which));
    if let Some(item) = item_of(&command) {
        let mut shows = state.overlays().shows(which);
        let toggle = ui.checkbox(&mut shows, item.name);
        let hint = format!("{} ({})", item.hint, item.first_keys());
        toggle.asks(hint, command, commands);
    }
}
