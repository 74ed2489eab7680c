//! The one question before edits or measures are dropped.

use super::prelude::*;
use crate::viewer::ui::command::{Intent, Reply};
use egui::{Context, Id, Modal};

/// Shown in the middle of the window, over everything else.
pub(super) fn show(ctx: &Context, state: &State, intent: &Intent, commands: &mut Vec<Command>) {
    let (edited, measured) = (intent.drops_edits(state), intent.drops_measures(state));
    let (heading, dropped) = match (edited, measured) {
        (true, false) => ("Unsaved edits", "edits"),
        (true, true) => ("Unsaved edits", "edits and measures"),
        (false, _) => ("Measures would be lost", "measures"),
    };
    let name = state.name();
    let (what, go_on) = match intent {
        Intent::Open(_) => ("opens other files", "Open"),
        Intent::Reload => ("reads the files again", "Reload"),
        Intent::LeaveGallery => ("leaves the gallery", "Leave"),
        Intent::Quit => ("closes the window", "Close"),
    };
    let mut text = vec![format!("This {what}.")];
    if edited {
        text.push(format!("Your edits in {name} are not saved."));
    }
    if measured {
        text.push(format!(
            "No file holds measures: those of {name} will be lost unless you copy them first."
        ));
    }
    Modal::new(Id::unique("question")).show(ctx, |ui| {
        ui.heading(heading);
        ui.label(text.join(" "));
        ui.add_space(8.0);
        ui.horizontal(|ui| {
            let mut button = |ui: &mut Ui, text: &str, hint: &str, asked: Command| {
                ui.button(text).asks(hint, asked, commands);
            };
            if edited {
                let hint = "as a scene file, then go on";
                button(ui, "Save first\u{2026}", hint, Command::Reply(Reply::Save));
            }
            if measured {
                let hint = "all lines as text; the question stays";
                let copy = Command::Copy(state.measuring().text());
                button(ui, "Copy the measures", hint, copy);
            }
            if matches!(intent, Intent::Open(_)) {
                let hint = "show them beside the present scene, which stays as it is";
                button(ui, "Add to the scene", hint, Command::Reply(Reply::Add));
            }
            let hint = format!("the {dropped} are lost");
            let go_on = format!("{go_on}, drop the {dropped}");
            button(ui, &go_on, &hint, Command::Reply(Reply::GoOn));
            let hint = "nothing happens (Esc)";
            button(ui, "Cancel", hint, Command::Reply(Reply::Stay));
        });
    });
}
