//! Text that stays on its line: names from files, as people see them.

/// Whether a character controls the terminal or the text direction: it moves the cursor, ends the line, or is
/// in Unicode's `Bidi_Control`.
pub(crate) fn is_mark(character: char) -> bool {
    let turns = matches!(character, '\u{61c}' | '\u{200e}' | '\u{200f}' | '\u{202a}'..='\u{202e}' | '\u{2066}'..='\u{2069}');
    character.is_control() || turns || matches!(character, '\u{2028}' | '\u{2029}')
}

/// The text with control and direction marks escaped.
pub(crate) fn plain(text: &str) -> String {
    let mut plain = String::new();
    for c in text.chars() {
        if is_mark(c) {
            plain.extend(c.escape_default());
        } else {
            plain.push(c);
        }
    }
    plain
}
