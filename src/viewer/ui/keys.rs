//! Keys to commands, by the table of menus.

use super::{command::Command, focus::Focus, menus::SHORTCUTS, panels::give_up_refused};
use egui::{Event, Key, Modifiers};
use std::iter;

const NONE: Modifiers = Modifiers::NONE;
const CTRL: Modifiers = Modifiers::COMMAND;

/// Takes Esc, which closed a menu and does nothing else then.
pub(in crate::viewer) fn take_escape(ctx: &egui::Context) {
    ctx.input_mut(|input| input.consume_key(NONE, Key::Escape));
}

/// The commands of the keys that were pressed. While a text is edited, only Ctrl+O, Ctrl+S and Ctrl+Q count, and none
/// while a question waits for an answer. While a question waits and no text is edited, only Esc counts. A focused
/// control gets Enter, Esc and the arrows. If none has the focus, Esc first gives up texts that are shown in red.
pub(in crate::viewer) fn pressed(ctx: &egui::Context, has_question: bool) -> Vec<Command> {
    let focus = Focus::of_pass(ctx);
    // No shortcut has Alt, and egui would take it for one without.
    let has_alt = |event: &Event| matches!(event, Event::Key { modifiers, .. } if modifiers.alt);
    if ctx.input(|input| input.events.iter().any(has_alt)) {
        return Vec::new();
    }
    if focus.types {
        return if has_question {
            Vec::new()
        } else {
            pressed_among(ctx, |modifiers, _, command| {
                modifiers == CTRL && command.ends_typing()
            })
        };
    }
    if has_question {
        let escapes = ctx.input_mut(|input| input.count_and_consume_key(NONE, Key::Escape));
        return vec![Command::Escape; escapes.min(1)];
    }
    if !focus.any && ctx.input(|input| input.key_pressed(Key::Escape)) && give_up_refused(ctx) {
        take_escape(ctx);
    }
    let is_taken = |key: Key| {
        focus.any
            && matches!(
                key,
                Key::Enter | Key::Escape | Key::ArrowUp | Key::ArrowDown
            )
    };
    let mut asked = pressed_among(ctx, |_, key, _| !is_taken(key));
    ctx.input(|input| {
        asked.extend(input.events.iter().filter_map(|event| match event {
            Event::Paste(text) => Some(Command::Paste(text.clone())),
            _ => None,
        }));
    });
    asked
}

/// The commands of those shortcuts that were pressed and that `counts` lets through.
fn pressed_among(
    ctx: &egui::Context,
    counts: impl Fn(Modifiers, Key, &Command) -> bool,
) -> Vec<Command> {
    let shortcuts = SHORTCUTS.iter();
    let shortcuts =
        shortcuts.filter(|((modifiers, key), command)| counts(*modifiers, *key, command));
    ctx.input_mut(|input| {
        let asked = shortcuts.flat_map(|((modifiers, key), command)| {
            // A key that was pressed twice within a slow frame acts twice.
            let times = input.count_and_consume_key(*modifiers, *key);
            iter::repeat_n((*command).clone(), times)
        });
        asked.collect()
    })
}
