//! Says what is wrong with a TOML text in words for people. The parser's own messages name Rust's types.

/// The most characters of a value that a message quotes.
const MOST_QUOTED: usize = 60;

/// The message for integers of more than 64 bits.
const LONG: &str = "a whole number this long needs a decimal point, as in 123.0";

/// What a parser's message means, as one line. A message of no known form keeps its words.
pub(super) fn in_words(message: &str) -> String {
    let plain = || message.lines().next().unwrap_or_default().to_owned();
    reworded(message).unwrap_or_else(plain)
}

/// The message in words for people; `None` for a message of no known form.
fn reworded(message: &str) -> Option<String> {
    if let Some(rest) =
        (message.strip_prefix("invalid type: ")).or_else(|| message.strip_prefix("invalid value: "))
    {
        // The value comes first and may hold any text, so the last match counts.
        let (value, expected) = rest.rsplit_once(", expected ")?;
        if value.ends_with("128") {
            return Some(LONG.to_owned());
        }
        return Some(format!(
            "expected {}, not {}",
            wanted(expected),
            given(value)
        ));
    }
    if let Some(rest) = message.strip_prefix("invalid length ") {
        let (count, expected) = rest.split_once(", expected ")?;
        return Some(format!("expected {expected} values, not {count}"));
    }
    if let Some(rest) = message.strip_prefix("unknown field `") {
        let (name, known) = rest.rsplit_once("`, expected ")?;
        let (name, known) = (quoted(name), list(known, "and"));
        return Some(format!("there is no {name} here: there are {known}"));
    }
    if let Some(rest) = message.strip_prefix("unknown variant `") {
        let (word, known) = rest.rsplit_once("`, expected ")?;
        let (word, known) = (quoted(word), list(known, "or"));
        return Some(format!("expected {known}, not \"{word}\""));
    }
    if let Some(field) = message.strip_prefix("duplicate field `") {
        let field = field.strip_suffix('`')?;
        return Some(format!("{field} is said twice: keep one"));
    }
    Some(match message {
        "integer number overflowed" => LONG.to_owned(),
        "floating-point number overflowed" => "the number is too large".to_owned(),
        "duplicate key" => "this is said twice: keep one".to_owned(),
        "key with no value, expected `=`" | "invalid key-value pair, expected key" => {
            "expected name = value".to_owned()
        }
        "string values must be quoted, expected literal string" => {
            "expected a number, a text in quotes or a list in brackets".to_owned()
        }
        "invalid basic string, expected `\"`" => "the text has no closing quote".to_owned(),
        // Where a word is expected, the parser also takes a table.
        _ if ["wanted ", "expected empty ", "expected table"]
            .iter()
            .any(|start| message.starts_with(start)) =>
        {
            "expected a word in quotes".to_owned()
        }
        _ => return None,
    })
}

/// What was expected: serde's words for it are types of Rust.
fn wanted(expected: &str) -> String {
    let words = match expected {
        "a string" => "a text in quotes",
        "f64" => "a number",
        "usize" => "a whole number from 0",
        "a boolean" => "true or false",
        "a sequence" => "a list in brackets",
        _ => expected,
    };
    words.to_owned()
}

/// The value in the file: "integer `3`" becomes 3.
fn given(value: &str) -> String {
    let backed = |kind: &str| value.strip_prefix(kind)?.strip_suffix('`');
    let kinds = ["integer `", "floating point `", "boolean `"];
    if let Some(value) = kinds.into_iter().find_map(backed) {
        return value.to_owned();
    }
    match value {
        "sequence" => "a list".to_owned(),
        "map" => "a table".to_owned(),
        _ => match value.strip_prefix("string ") {
            Some(text) => format!("the text {}", shortened(text)),
            None => quoted(value),
        },
    }
}

/// A name from the file, on one line.
fn quoted(name: &str) -> String {
    shortened(&name.escape_debug().to_string())
}

fn shortened(text: &str) -> String {
    match text.char_indices().nth(MOST_QUOTED) {
        Some((end, _)) => format!("{}\u{2026}", &text[..end]),
        None => text.to_owned(),
    }
}

/// The names in "one of `a`, `b`, `c`" as "a, b and c".
fn list(known: &str, last: &str) -> String {
    let known = known.strip_prefix("one of ").unwrap_or(known);
    let names = known.replace('`', "");
    let (before, after) = (names
        .rsplit_once(" or ")
        .or_else(|| names.rsplit_once(", ")))
    .unwrap_or(("", &names));
    match before {
        "" => after.to_owned(),
        _ => format!("{before} {last} {after}"),
    }
}
