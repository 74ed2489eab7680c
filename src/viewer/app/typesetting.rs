//! Names in any script: loads a typeface of the system when a name first needs it.

use super::program::App;
use crate::viewer::jobs::Typeface;
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
    use std::{collections::BTreeSet, sync::Arc, thread, time::Duration};

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
            let mut app = App::start(
                options,
                Arc::new(drop),
                Host::Picture,
                egui::Context::default(),
            );
            while app.is_busy() || app.state.views() != views {
                thread::sleep(Duration::from_millis(1));
                app.pass(egui::RawInput::default());
            }
            app.pass(egui::RawInput::default());
            app.take_finished();
            assert!(app.typefaces.searched().is_empty(), "{views:?}");
        }
    }

    /// A typeface of the system is asked for each character of a name that egui's own lack, and for no other.
    #[test]
    fn names_in_any_script_ask_for_other_typefaces() {
        let mut app = App::start(
            Options::default(),
            Arc::new(drop),
            Host::Picture,
            egui::Context::default(),
        );
        app.pass(egui::RawInput::default());
        let names = [
            "\u{4f60}\u{597d}",
            "\u{65e5}\u{672c}\u{306b}",
            "\u{d55c}\u{ad6d}",
            "\u{633}\u{644}\u{627}\u{645}",
            "\u{5e9}\u{5dc}\u{5d5}\u{5dd}",
            "\u{e2a}\u{e27}\u{e31}\u{e2a}\u{e14}\u{e35}",
            "\u{1f980}\u{1fabf}",
        ];
        for name in names.into_iter().chain(["Egg \u{e9} \u{1f600}"]) {
            let (text, font) = (name.to_owned(), egui::FontId::default());
            let white = egui::Color32::WHITE;
            (app.context).fonts_mut(|fonts| fonts.layout_no_wrap(text, font, white));
        }
        app.take_finished();
        let lacked: BTreeSet<char> = names.into_iter().flat_map(str::chars).collect();
        assert_eq!(app.typefaces.searched(), &lacked);
    }
}
