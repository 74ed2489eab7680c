//! Where keys go. A text that is edited takes them all; what is merely reached by Tab takes those that work it; all others
//! are shortcuts.

use egui::{Context, Id};

/// What had the focus when the keys of a pass were pressed: egui takes it away before anybody sees the key that did.
#[derive(Clone, Copy, Default)]
pub(super) struct Focus {
    /// A text was edited.
    pub types: bool,
    /// Something was reached, a text or a button.
    pub any: bool,
}

impl Focus {
    /// As it was when the last pass ended.
    pub fn before(ctx: &Context) -> Self {
        ctx.data(|data| data.get_temp(Self::id()))
            .unwrap_or_default()
    }

    /// As it is now.
    pub fn now(ctx: &Context) -> Self {
        Self {
            types: ctx.text_edit_focused(),
            any: ctx.memory(|memory| memory.focused().is_some()),
        }
    }

    /// Keeps it for the next pass.
    pub fn keep(self, ctx: &Context) {
        ctx.data_mut(|data| data.insert_temp(Self::id(), self));
    }

    /// Had by either.
    pub fn or(self, other: Self) -> Self {
        Self {
            types: self.types || other.types,
            any: self.any || other.any,
        }
    }

    fn id() -> Id {
        Id::unique("focus before")
    }
}
