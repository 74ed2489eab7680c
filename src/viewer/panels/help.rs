//! Keys and mouse, from the very table that works them.

use super::super::{Command, keys};
use egui::{Align2, Context, Grid, Window};

pub(super) fn show(ctx: &Context, commands: &mut Vec<Command>) {
    let mut open = true;
    Window::new("Keys and mouse")
        .open(&mut open)
        .collapsible(false)
        .resizable(false)
        .anchor(Align2::CENTER_CENTER, [0.0, 0.0])
        .show(ctx, |ui| {
            Grid::new("help")
                .num_columns(2)
                .striped(true)
                .show(ui, |ui| {
                    let bindings = keys::BINDINGS
                        .iter()
                        .map(|binding| (binding.keys, binding.does));
                    for (input, does) in keys::MOUSE
                        .iter()
                        .copied()
                        .chain(bindings)
                        .filter(|(_, does)| !does.is_empty())
                    {
                        ui.monospace(input);
                        ui.label(does);
                        ui.end_row();
                    }
                });
        });
    if !open {
        commands.push(Command::ToggleHelp);
    }
}
