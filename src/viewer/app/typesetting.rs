//! Names in any script: a typeface of the system is taken when a name first needs it.

use super::{program::App, wake::Wake};
use crate::viewer::jobs::Typeface;
use egui::{
    FontData, FontFamily,
    epaint::text::{FontInsert, FontPriority, InsertFontFamily},
};

impl App {
    /// Searches for what is missing, and takes what was found.
    pub(super) fn take_typefaces(&mut self) {
        let wake = self.wake.clone();
        self.typefaces.search(move || wake(Wake::Look));
        for Typeface { name, bytes, index } in self.typefaces.poll() {
            log::info!("names are set in {name} too");
            let mut data = FontData::from_owned(bytes);
            data.index = index;
            let families = [FontFamily::Proportional, FontFamily::Monospace];
            let last = |family| InsertFontFamily {
                family,
                priority: FontPriority::Lowest,
            };
            let families = families.map(last).to_vec();
            self.context
                .add_font(FontInsert::new(&name, data, families));
            self.context.request_repaint();
        }
    }
}
