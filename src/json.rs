//! JSON for terminals, clipboards and pipes: one line per value, with control characters escaped.

use crate::plain::is_mark;
use serde::Serialize;
use serde_json::{
    Serializer,
    ser::{CompactFormatter, Formatter},
};
use std::io::{self, Write};

/// Writes a value as JSON without a newline. In strings the characters of [`is_mark`] are escaped.
///
/// # Errors
/// When `out` fails.
pub(crate) fn write(out: impl Write, value: &impl Serialize) -> io::Result<()> {
    value.serialize(&mut Serializer::with_formatter(out, Escaping))?;
    Ok(())
}

/// [`write()`], and ends the line.
///
/// # Errors
/// When `out` fails.
pub(crate) fn write_line(mut out: impl Write, value: &impl Serialize) -> io::Result<()> {
    write(&mut out, value)?;
    writeln!(out)
}

/// An object of JSON with these fields, in this order.
macro_rules! object {
    ($($name:ident: $value:expr),+ $(,)?) => {{
        // The type of each field has the field's name.
        #[expect(non_camel_case_types)]
        let object = {
            #[derive(serde::Serialize)]
            struct JsonObject<$($name),+> {
                $($name: $name),+
            }
            JsonObject { $($name: $value),+ }
        };
        object
    }};
}
pub(crate) use object;

/// The JSON of a value, as a string.
///
/// # Errors
/// When JSON cannot represent the value.
pub(crate) fn text(value: &impl Serialize) -> io::Result<String> {
    let mut bytes = Vec::new();
    write(&mut bytes, value)?;
    String::from_utf8(bytes).map_err(io::Error::other)
}

/// Compact, with the characters of [`is_mark`] as `\uXXXX`.
struct Escaping;

impl Formatter for Escaping {
    fn write_string_fragment<W: ?Sized + Write>(
        &mut self,
        out: &mut W,
        mut fragment: &str,
    ) -> io::Result<()> {
        // Most names are plain ASCII.
        let is_plain = |byte| (b' '..=b'~').contains(&byte);
        if fragment.bytes().all(is_plain) {
            return CompactFormatter.write_string_fragment(out, fragment);
        }
        while let Some((at, mark)) = fragment.char_indices().find(|(_, c)| is_mark(*c)) {
            CompactFormatter.write_string_fragment(out, &fragment[..at])?;
            write!(out, "\\u{:04x}", u32::from(mark))?;
            fragment = &fragment[at + mark.len_utf8()..];
        }
        CompactFormatter.write_string_fragment(out, fragment)
    }
}

#[cfg(test)]
mod tests {
    use super::text;

    #[test]
    fn names_do_nothing_and_are_read_back() {
        let name = "a\u{9b}31m\u{202e}b\u{85}c\u{2028}\u{7f}\n\"\\ \u{e4}\u{5b57}";
        let json = text(&name).expect("a string");
        let shown = r#""a\u009b31m\u202eb\u0085c\u2028\u007f\n\"\\ ä字""#;
        assert_eq!(json, shown);
        let back: String = serde_json::from_str(&json).expect("JSON");
        assert_eq!(back, name);
    }
}
