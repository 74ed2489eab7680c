//! The card that screenshots are taken from: what they show, on which background, how large, and where they go.

use super::{field::Field, prelude::*, slide::Slide};
use crate::{
    camera::Viewport,
    look::Backdrop,
    viewer::ui::{
        command::{Shot, ShotSize, ShotTo},
        focus::appears,
    },
};
use egui::{Context, Event, Id, Key, Modifiers, Popup, Window};
use std::{array, iter, mem};

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
                let hint = "put it on the clipboard (Ctrl+C)";
                copy.asks(hint, Command::Shoot(*shot, ShotTo::Clipboard), commands);
            });
        });
    let is_pressed = |key| !types && ctx.input_mut(|input| input.consume_key(Modifiers::NONE, key));
    // A control that Tab has led to takes Enter, and a menu Esc.
    if ctx.memory(|memory| memory.focused().is_none()) && is_pressed(Key::Enter) {
        commands.push(Command::Shoot(*shot, ShotTo::File));
    } else if !types && ctx.input(|input| input.events.contains(&Event::Copy)) {
        commands.push(Command::Shoot(*shot, ShotTo::Clipboard));
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
        // Only the next pass knows how wide the card is.
        ctx.request_discard("the card of screenshots appears");
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
    let shown = shot.size.of(now).unwrap_or(now);
    let sides = [shown.width(), shown.height()];
    ui.horizontal(|ui| {
        let asked: [Option<f64>; 2] = array::from_fn(|at| {
            let (name, side) = (["width", "height"][at], f64::from(sides[at]));
            let field = Field::new(name, "in pixels", at as u64, 56.0, side);
            field.show(ui, 1.0, &mut Slide::default(), |side| {
                pixels(side).map(drop)
            })
        });
        ui.label("px");
        if asked != [None; 2] {
            let [width, height] = array::from_fn(|at| {
                let asked = asked[at].and_then(|side| pixels(side).ok());
                asked.unwrap_or(sides[at])
            });
            if let Ok(size) = Viewport::new(width, height) {
                shot.size = ShotSize::Fixed(size);
            }
        }
        for (name, times) in [("as on screen", 1), ("\u{d7} 2", 2), ("\u{d7} 4", 4)] {
            let choice = ShotSize::OnScreen(times);
            let sized = Button::selectable(shot.size == choice, name);
            let sized = ui.add_enabled(choice.of(now).is_some(), sized);
            let hint = format!("{} x {} px now", now.width() * times, now.height() * times);
            if sized.hint(hint).clicked() {
                shot.size = choice;
            }
        }
    });
}

/// A side of a picture from a number that was typed or dragged.
#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "within the range"
)]
fn pixels(side: f64) -> Result<u32, String> {
    let (side, most) = (side.round(), Viewport::LARGEST_SIDE);
    if (1.0..=f64::from(most)).contains(&side) {
        Ok(side as u32)
    } else {
        Err(format!("it must be from 1 to {most} pixels"))
    }
}
