//! The card that screenshots are taken from: what they show, on which background, how large, and where they go.

use super::prelude::*;
use crate::{
    camera::Viewport,
    look::Backdrop,
    viewer::ui::{
        command::{Shot, ShotTo},
        focus::appears,
    },
};
use egui::{Context, DragValue, Id, Key, Modifiers, Popup, Window};
use std::{iter, mem};

/// Shown at the top of the window, so that the scene can be turned and seen beside it.
pub(super) fn show(ctx: &Context, state: &State, shot: &mut Shot, commands: &mut Vec<Command>) {
    let (mut open, types) = (true, types(ctx));
    Window::new("Screenshot")
        .open(&mut open)
        .collapsible(false)
        .resizable(false)
        .anchor(Align2::CENTER_TOP, [0.0, 48.0])
        .show(ctx, |ui| {
            Grid::new("screenshot").num_columns(2).show(ui, |ui| {
                ui.label("Shows");
                ui.horizontal(|ui| {
                    let what = &mut shot.has_panels;
                    (ui.selectable_value(what, false, "picture")).hint("without the panels");
                    (ui.selectable_value(what, true, "whole window")).hint("with the panels");
                });
                ui.end_row();
                ui.label("Background");
                ui.horizontal(|ui| {
                    let named = Backdrop::NAMED.map(|(name, backdrop)| (name, Some(backdrop)));
                    for (name, backdrop) in iter::once(("as on screen", None)).chain(named) {
                        let choice = ui.selectable_value(&mut shot.backdrop, backdrop, name);
                        choice.hint(about(backdrop));
                    }
                });
                ui.end_row();
                ui.label("Size");
                let is_fixed = shot.has_panels || !state.stages().is_empty();
                ui.add_enabled_ui(!is_fixed, |ui| size(ui, state, shot));
                ui.end_row();
            });
            ui.add_space(6.0);
            ui.horizontal(|ui| {
                let save = ui.button("Save").named("save the screenshot");
                let hint = "as a new PNG file, sightline-1.png or the next number (Enter)";
                save.asks(hint, Command::Shoot(*shot, ShotTo::File), commands);
                let copy = ui.button("Copy").named("copy the screenshot");
                let hint = "put it on the clipboard";
                copy.asks(hint, Command::Shoot(*shot, ShotTo::Clipboard), commands);
            });
        });
    let is_pressed = |key| !types && ctx.input_mut(|input| input.consume_key(Modifiers::NONE, key));
    // A control that Tab has led to takes Enter, and a menu Esc.
    if ctx.memory(|memory| memory.focused().is_none()) && is_pressed(Key::Enter) {
        commands.push(Command::Shoot(*shot, ShotTo::File));
    } else if !open || (!Popup::is_any_open(ctx) && is_pressed(Key::Escape)) {
        commands.push(Command::ToggleScreenshot);
    }
}

/// What a choice of background means.
fn about(backdrop: Option<Backdrop>) -> &'static str {
    match backdrop {
        None => "what is behind the scene now",
        Some(Backdrop::Dark) => "as with dark panels",
        Some(Backdrop::Light) => "as with light panels",
        Some(Backdrop::White) => "for paper",
        Some(Backdrop::Transparent) => "nothing: the scene alone, to be laid over anything",
    }
}

/// Whether a number is being typed, or was in the pass before: the key that ends that does nothing else. As the card
/// appears, what had the focus loses it.
fn types(ctx: &Context) -> bool {
    if appears(ctx, "screenshot") {
        ctx.memory_mut(|memory| {
            if let Some(id) = memory.focused() {
                memory.surrender_focus(id);
            }
        });
    }
    let (id, now) = (Id::unique("a size is typed"), ctx.text_edit_focused());
    let before = ctx.data_mut(|data| mem::replace(data.get_temp_mut_or_default(id), now));
    before || now
}

/// Width and height in pixels, and sizes that are often wanted.
fn size(ui: &mut Ui, state: &State, shot: &mut Shot) {
    let now = state.view().viewport;
    let shown = shot.size.unwrap_or(now);
    let mut sides = [shown.width(), shown.height()];
    ui.horizontal(|ui| {
        for (side, name) in sides.iter_mut().zip(["width", "height"]) {
            let field = DragValue::new(side)
                .range(1..=Viewport::LARGEST_SIDE)
                .suffix(" px");
            ui.add(field).named(name).hint("drag, or click and type");
        }
        let [width, height] = [now.width(), now.height()];
        for (name, times) in [("as on screen", 1), ("\u{d7} 2", 2), ("\u{d7} 4", 4)] {
            let is_room = width.max(height) * times <= Viewport::LARGEST_SIDE;
            let sized = ui.add_enabled(is_room, Button::new(name));
            let hint = format!("{} x {} px", width * times, height * times);
            if sized.hint(hint).clicked() {
                sides = [width * times, height * times];
            }
        }
    });
    let chosen = Viewport::new(sides[0], sides[1]).ok();
    shot.size = chosen.filter(|chosen| *chosen != now);
}
