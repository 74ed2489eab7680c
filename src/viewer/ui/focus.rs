//! Where keys go. A text that is being edited takes all keys. Another focused control takes the keys that operate it.
//! The rest are shortcuts.

use egui::{Context, Id, Popup};
use std::mem;

/// Takes the focus from the text that is being edited: its field then does what Enter does.
pub(in crate::viewer) fn leave_text(ctx: &Context) {
    if ctx.text_edit_focused() {
        ctx.memory_mut(|memory| {
            if let Some(id) = memory.focused() {
                memory.surrender_focus(id);
            }
        });
    }
}

/// Whether what has this name appears in this pass: it was not laid out in the pass before.
pub(super) fn appears(ctx: &Context, name: &str) -> bool {
    let pass = ctx.cumulative_pass_nr();
    let id = Id::unique(("laid out in pass", name));
    let last = ctx.data_mut(|data| mem::replace(data.get_temp_mut_or(id, 0), pass + 1));
    last < pass
}

/// What had the focus when the keys of a pass were pressed. egui drops the focus before we see the key that dropped it.
#[derive(Clone, Copy, Default)]
pub(super) struct Focus {
    /// A text was being edited.
    pub types: bool,
    /// Any control had the focus, or a menu was open: its first arrow key gives one of its lines the focus.
    pub any: bool,
}

impl Focus {
    /// The focus of this pass: what has it now, or had it when the last pass ended.
    pub fn of_pass(ctx: &Context) -> Self {
        let now = Self {
            types: ctx.text_edit_focused(),
            any: ctx.memory(|memory| memory.focused().is_some()) || Popup::is_any_open(ctx),
        };
        let id = Id::unique("focus before");
        let before: Self = ctx.data_mut(|data| mem::replace(data.get_temp_mut_or_default(id), now));
        Self {
            types: before.types || now.types,
            any: before.any || now.any,
        }
    }
}
