//! The row of buttons at the top.

use super::{exhibit, names::named};
use crate::viewer::{
    model::{Action, Overlay, Stage, State},
    ui::command::Command,
};
use egui::{Checkbox, Ui};
use glam::DVec3;

pub(super) fn show(ui: &mut Ui, state: &State, commands: &mut Vec<Command>) {
    ui.horizontal(|ui| {
        let mut button = |ui: &mut Ui, name: &str, hint: &str, command: Command| {
            if ui.button(name).on_hover_text(hint).clicked() {
                commands.push(command);
            }
        };
        button(
            ui,
            "Open\u{2026}",
            "OBJ and scene files (Ctrl+O); or drop them on the window",
            Command::OpenDialog,
        );
        button(
            ui,
            "Save\u{2026}",
            "as a scene file (Ctrl+S)",
            Command::SaveDialog,
        );
        button(ui, "Reload", "read the files again (R)", Command::Reload);
        ui.separator();
        for (name, back, key) in [("Undo", true, "Ctrl+Z"), ("Redo", false, "Ctrl+Shift+Z, Ctrl+Y")] {
            let step = state.next_step(back);
            let hint = format!("{} ({key})", step.unwrap_or("nothing"));
            ui.add_enabled_ui(step.is_some(), |ui| {
                let action = if back { Action::Undo } else { Action::Redo };
                button(ui, name, &hint, Command::Act(action));
            });
        }
        ui.separator();
        button(ui, "Frame all", "(A)", Command::Act(Action::FrameAll));
        button(
            ui,
            "Frame selection",
            "(F)",
            Command::Act(Action::FrameSelection),
        );
        ui.separator();
        for (name, key, to_eye) in [
            ("Front", "1", DVec3::Z),
            ("Right", "3", DVec3::X),
            ("Top", "7", DVec3::Y),
            ("Corner", "9", DVec3::ONE),
        ] {
            let hint = format!("({key}; Ctrl: from the other side)");
            button(ui, name, &hint, Command::Act(Action::LookFrom(to_eye)));
        }
        button(
            ui,
            "Reset",
            "the view that the scene opened with (Enter)",
            Command::Act(Action::ResetView),
        );
        ui.separator();
        let mut grid = state.grid();
        if ui
            .checkbox(&mut grid, "Grid")
            .on_hover_text("with axes: x red, y green, z blue (G)")
            .changed()
        {
            commands.push(Command::Act(Action::ToggleGrid));
        }
        let mut frozen = state.frozen().is_some();
        let in_world = state.stage() == Stage::World;
        if ui
            .add_enabled(in_world, Checkbox::new(&mut frozen, "Freeze"))
            .on_hover_text("leave this camera standing, with the pick's ray, and look at it from elsewhere (T)")
            .changed()
        {
            commands.push(Command::Act(Action::ToggleFreeze));
        }
        if ui
            .button("Pipeline")
            .on_hover_text("P, V, M and the pick on its way through them (P)")
            .clicked()
        {
            commands.push(Command::TogglePipeline);
        }
        let menu = ui.menu_button("Overlays", |ui| {
            for which in Overlay::ALL {
                overlay(ui, state, which, commands);
            }
            tree_level(ui, state, commands);
        });
        menu.response.on_hover_text("lines over the scene");
        exhibit::menu(ui, state, commands);
        if ui
            .button("Help")
            .on_hover_text("keys and mouse (H)")
            .clicked()
        {
            commands.push(Command::ToggleHelp);
        }
    });
}

/// Which level of the trees over meshes shows.
fn tree_level(ui: &mut Ui, state: &State, commands: &mut Vec<Command>) {
    ui.horizontal(|ui| {
        let level = state.overlays().tree_level;
        let shown = level.map_or("off".to_owned(), |level| level.to_string());
        let hint = "boxes that picks walk through, of meshes that are worth a tree; 0 is the box about all";
        ui.label(format!("tree level: {shown}")).on_hover_text(hint);
        for (name, deeper, hint) in [("\u{2212}", false, "(Shift+K)"), ("+", true, "(K)")] {
            let button = ui.small_button(name).on_hover_text(hint);
            named(&button, if deeper { "a level deeper" } else { "a level less deep" });
            if button.clicked() {
                commands.push(Command::Act(Action::TreeLevel { deeper }));
            }
        }
    });
}

/// A box that shows an overlay.
pub(super) fn overlay(ui: &mut Ui, state: &State, which: Overlay, commands: &mut Vec<Command>) {
    let [name, key, hint] = which.about();
    let mut shows = state.overlays().shows(which);
    let hint = format!("{hint} ({key})");
    if ui.checkbox(&mut shows, name).on_hover_text(hint).changed() {
        commands.push(Command::Act(Action::Toggle(which)));
    }
}
