//! Names whose words run from right to left, as egui can lay them out: it shapes letters within a word in either
//! direction, but puts words, spaces and signs from left to right.

use std::borrow::Cow;
use unicode_bidi::{BidiClass, BidiInfo, bidi_class};

/// The name with its words in the order in which they stand from left to right. Letters stay in the order of reading. A
/// name without letters that run from right to left stays as it is.
pub(super) fn visual_order(name: &str) -> Cow<'_, str> {
    if !name.chars().any(runs_to_the_left) {
        return name.into();
    }
    let info = BidiInfo::new(name, None);
    let mut all = String::with_capacity(name.len());
    for paragraph in &info.paragraphs {
        let (levels, runs) = info.visual_runs(paragraph, paragraph.range.clone());
        for run in runs {
            let text = &name[run.clone()];
            if levels[run.start].is_rtl() {
                let mut pieces = pieces(text);
                pieces.reverse();
                all.extend(pieces);
            } else {
                all.push_str(text);
            }
        }
    }
    all.into()
}

fn runs_to_the_left(character: char) -> bool {
    matches!(bidi_class(character), BidiClass::R | BidiClass::AL)
}

/// Words, and each space or sign between them by itself. A bracket becomes its mirror image.
fn pieces(text: &str) -> Vec<String> {
    let mut pieces: Vec<String> = Vec::new();
    let mut is_in_word = false;
    for character in text.chars() {
        let is_of_word =
            runs_to_the_left(character) || (is_in_word && bidi_class(character) == BidiClass::NSM);
        match pieces.last_mut() {
            Some(word) if is_in_word && is_of_word => word.push(character),
            _ => pieces.push(mirrored(character).to_string()),
        }
        is_in_word = is_of_word;
    }
    pieces
}

fn mirrored(character: char) -> char {
    const PAIRS: [[char; 2]; 5] = [
        ['(', ')'],
        ['[', ']'],
        ['{', '}'],
        ['<', '>'],
        ['\u{ab}', '\u{bb}'],
    ];
    let other = PAIRS.iter().find_map(|[open, close]| match character {
        c if c == *open => Some(*close),
        c if c == *close => Some(*open),
        _ => None,
    });
    other.unwrap_or(character)
}

#[cfg(test)]
mod tests {
    use super::visual_order;

    #[test]
    fn the_first_word_of_a_name_that_runs_to_the_left_stands_rightmost() {
        // A red cube in Arabic and in Hebrew, and a box.
        let [cube, red] = [
            "\u{645}\u{643}\u{639}\u{628}",
            "\u{623}\u{62d}\u{645}\u{631}",
        ];
        let [kubiya, aduma] = [
            "\u{5e7}\u{5d5}\u{5d1}\u{5d9}\u{5d9}\u{5d4}",
            "\u{5d0}\u{5d3}\u{5d5}\u{5de}\u{5d4}",
        ];
        for (name, seen) in [
            (format!("{cube} {red}"), format!("{red} {cube}")),
            (format!("{kubiya} {aduma}"), format!("{aduma} {kubiya}")),
            (format!("{cube}_12"), format!("12_{cube}")),
            (format!("{cube} ({red})"), format!("({red}) {cube}")),
            (
                format!("box {cube} {red} b2"),
                format!("box {red} {cube} b2"),
            ),
            (
                format!("{cube} box lid {red}"),
                format!("{red} box lid {cube}"),
            ),
            // Marks stay with their letters.
            (
                "\u{5e9}\u{5c1} \u{5dc}".into(),
                "\u{5dc} \u{5e9}\u{5c1}".into(),
            ),
        ] {
            assert_eq!(visual_order(&name), seen, "{name}");
        }
    }

    #[test]
    fn other_names_stay_as_they_are() {
        for name in [
            "",
            "Egg",
            "a (b) [c]",
            "\u{4f60}\u{597d} \u{1f980}",
            "two\nlines",
        ] {
            assert_eq!(visual_order(name), name);
        }
    }
}
