//! The one question before edits are dropped.

use super::hints::Hint;
use crate::viewer::{
    model::State,
    ui::command::{Command, Intent, Reply},
};
use egui::{Context, Id, Modal};

/// Shown in the middle of the window, over everything else.
pub(super) fn show(ctx: &Context, state: &State, intent: &Intent, commands: &mut Vec<Command>) {
    let (what, go_on) = match intent {
        Intent::Open(_) => ("opens other files", "Open, drop the edits"),
        Intent::Reload => ("reads the files again", "Reload, drop the edits"),
        Intent::LeaveGallery => ("leaves the gallery", "Leave, drop the edits"),
        Intent::Quit => ("closes the window", "Close, drop the edits"),
    };
    let scenes: Vec<_> = intent.drops(state).into_iter().map(State::name).collect();
    let scenes = scenes.join(" and ");
    Modal::new(Id::unique("question")).show(ctx, |ui| {
        ui.heading("Unsaved edits");
        ui.label(format!(
            "This {what}. Your edits in {scenes} are not saved."
        ));
        ui.add_space(8.0);
        ui.horizontal(|ui| {
            let mut answer = |ui: &mut egui::Ui, text: &str, hint: &str, reply| {
                if ui.button(text).hint(hint).clicked() {
                    commands.push(Command::Reply(reply));
                }
            };
            answer(
                ui,
                "Save first\u{2026}",
                "as a scene file, then go on",
                Reply::Save,
            );
            if matches!(intent, Intent::Open(_)) {
                answer(
                    ui,
                    "Add to the scene",
                    "show them beside the present scene, and keep the edits",
                    Reply::Add,
                );
            }
            answer(ui, go_on, "the edits are lost", Reply::GoOn);
            answer(ui, "Cancel", "nothing happens (Esc)", Reply::Stay);
        });
    });
}
