//! Names in any script: loads a typeface of the system when a name first needs it.

use super::program::App;
use crate::viewer::{jobs::Typeface, ui::Letters};
use egui::{
    FontData, FontFamily,
    epaint::text::{FontInsert, FontPriority, InsertFontFamily},
};

impl App {
    /// Searches the system for missing characters, and installs the typefaces found.
    pub(super) fn take_typefaces(&mut self) {
        self.typefaces.search(self.waker());
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
            // egui rasterises all glyphs again.
            self.letters = Letters::default();
            self.context.request_repaint();
        }
    }
}

#[cfg(test)]
mod tests {
    use super::App;
    use crate::viewer::{
        app::Host,
        model::{Stage, Views},
        options::Options,
    };
    use std::{sync::Arc, thread, time::Duration};

    /// Another typeface makes egui rasterise all glyphs again, which takes longer than a pass may.
    #[test]
    fn what_panels_say_by_themselves_needs_no_other_typeface() {
        let stages = Stage::ALL.map(|(stage, _)| Views::One(stage));
        for views in [Views::Picture, Views::Four].into_iter().chain(stages) {
            let options = Options {
                views,
                tour: true,
                ..Options::default()
            };
            let mut app = App::start(options, Arc::new(drop), Host::Picture);
            while app.is_busy() || app.state.views() != views {
                thread::sleep(Duration::from_millis(1));
                app.pass(egui::RawInput::default());
            }
            app.pass(egui::RawInput::default());
            app.take_finished();
            assert!(!app.typefaces.has_searched(), "{views:?}");
        }
    }
}
