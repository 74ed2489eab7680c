//! Keys and mouse, from the very table that works them.

use crate::viewer::ui::{command::Command, keys};
use egui::{Align2, Context, Grid, Window};

pub(super) fn show(ctx: &Context, commands: &mut Vec<Command>) {
    let mut open = true;
    Window::new("Keys and mouse")
        .open(&mut open)
        .collapsible(false)
        .resizable(false)
        .anchor(Align2::CENTER_CENTER, [0.0, 0.0])
        .show(ctx, |ui| {
            let bindings = keys::BINDINGS
                .iter()
                .map(|binding| (binding.keys, binding.does));
            let all = keys::MOUSE.iter().copied().chain(bindings);
            let rows: Vec<_> = all.filter(|(_, does)| !does.is_empty()).collect();
            // Side by side: one above the other they do not fit a small screen.
            ui.horizontal_top(|ui| {
                for (column, rows) in rows.chunks(rows.len().div_ceil(2)).enumerate() {
                    Grid::new(column)
                        .num_columns(2)
                        .striped(true)
                        .show(ui, |ui| {
                            for (input, does) in rows {
                                ui.monospace(*input);
                                ui.label(*does);
                                ui.end_row();
                            }
                        });
                }
            });
        });
    if !open {
        commands.push(Command::ToggleHelp);
    }
}
