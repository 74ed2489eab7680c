//! Where keys go. A text that is being edited takes all of them; another focused control takes those that operate it; the
//! rest are shortcuts.

use egui::{Context, Id};

/// What had the focus when the keys of a pass were pressed: egui drops it before we see the key that made it do so.
#[derive(Clone, Copy, Default)]
pub(super) struct Focus {
    /// A text was being edited.
    pub types: bool,
    /// Any control had the focus.
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

    /// What either of the two has.
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
