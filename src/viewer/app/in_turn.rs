//! Splits the input of a slow frame, so that egui gives what was typed to the field that it was typed into.

use egui::{Event, Key, RawInput};

/// Splits an input into one or more, in order. Within one pass egui moves the focus first and gives all text to the
/// field that has it then. So a key that moves the focus begins an input, and so does what is typed after it, or copied.
pub(in crate::viewer) fn in_turn(mut input: RawInput) -> Vec<RawInput> {
    let mut events = std::mem::take(&mut input.events).into_iter().peekable();
    let mut inputs = Vec::new();
    while events.peek().is_some() || inputs.is_empty() {
        let mut part = RawInput {
            dropped_files: Vec::new(),
            ..input.clone()
        };
        while let Some(event) = events.next_if(|next| !begins(next, &part.events)) {
            part.events.push(event);
        }
        inputs.push(part);
    }
    if let Some(first) = inputs.first_mut() {
        first.dropped_files = input.dropped_files;
    }
    inputs
}

/// Whether an event begins a new input behind these.
fn begins(next: &Event, before: &[Event]) -> bool {
    let moves_focus = |event: &Event| {
        let key = match event {
            Event::Key {
                key, pressed: true, ..
            } => *key,
            _ => return false,
        };
        matches!(key, Key::Tab | Key::Enter | Key::Escape)
    };
    let is_typed = matches!(
        next,
        Event::Text(_) | Event::Paste(_) | Event::Key { pressed: true, .. }
    );
    // What a key opens can be copied.
    let is_apart = moves_focus(next) || matches!(next, Event::Copy);
    is_apart && !before.is_empty() || is_typed && before.iter().any(moves_focus)
}

#[cfg(test)]
mod tests {
    use super::in_turn;
    use egui::{Event, Key, Modifiers, RawInput};

    #[test]
    fn what_was_typed_stands_apart_from_keys_that_move_the_focus() {
        let text = |text: &str| Event::Text(text.to_owned());
        let key = |key| Event::Key {
            key,
            physical_key: None,
            pressed: true,
            repeat: false,
            modifiers: Modifiers::NONE,
        };
        let counts = |events: Vec<Event>| {
            let input = RawInput {
                events,
                ..RawInput::default()
            };
            let parts = in_turn(input).into_iter();
            parts.map(|part| part.events.len()).collect::<Vec<_>>()
        };
        assert_eq!(counts(vec![]), [0]);
        assert_eq!(counts(vec![text("6"), text("5")]), [2]);
        assert_eq!(counts(vec![key(Key::Tab)]), [1]);
        let typed = vec![
            text("6"),
            key(Key::Num5),
            key(Key::Enter),
            text("7"),
            key(Key::Tab),
        ];
        assert_eq!(counts(typed), [2, 1, 1, 1]);
        assert_eq!(counts(vec![key(Key::Tab), key(Key::A), text("4")]), [1, 2]);
        assert_eq!(counts(vec![key(Key::F12), Event::Copy]), [1, 1]);
    }
}
