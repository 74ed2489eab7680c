//! Asks for a path where the desktop shows no file dialog.

use super::prelude::*;
use crate::viewer::ui::path_question::{PathFor, PathQuestion};
use egui::{Context, Id, Key, Modal, Modifiers, TextEdit};

/// Shown in the middle of the window, over everything else.
pub(super) fn show(ctx: &Context, question: &mut PathQuestion, commands: &mut Vec<Command>) {
    let (heading, does) = match question.what {
        PathFor::Open => ("Open", "Open"),
        PathFor::Save => ("Save scene", "Save"),
    };
    let mut take = None;
    Modal::new(Id::unique("path question")).show(ctx, |ui| {
        let width = (ctx.content_rect().width() - 60.0).clamp(100.0, 460.0);
        ui.set_max_width(width);
        ui.heading(heading);
        ui.label("This desktop shows no file dialog: it needs an XDG desktop portal, or zenity. Type the path of the file:");
        let id = Id::unique("typed path");
        let edit = TextEdit::singleline(&mut question.text).id(id);
        let field = ui.add(edit.desired_width(width - 20.0)).named("path");
        if field.changed() {
            question.edited();
        }
        if field.lost_focus() && ui.input(|input| input.key_pressed(Key::Enter)) {
            take = Some(true);
        }
        // Nothing else in the window takes keys.
        if !ui.memory(|memory| memory.focused().is_some()) {
            field.request_focus();
        }
        if let Some(said) = &question.said {
            let said = RichText::new(said).color(ui.visuals().warn_fg_color);
            ui.label(said).hint("why the path is not taken");
        }
        ui.add_space(8.0);
        ui.horizontal(|ui| {
            let does = question.replaces.as_ref().map_or(does, |_| "Replace");
            if ui.button(does).hint("(Enter)").clicked() {
                take = Some(true);
            }
            if ui.button("Cancel").hint("nothing happens (Esc)").clicked() {
                take = Some(false);
            }
        });
    });
    if ctx.input_mut(|input| input.consume_key(Modifiers::NONE, Key::Escape)) {
        take = Some(false);
    }
    commands.extend(take.map(|take| Command::TypedPath { take }));
}
