//! The text of a scene file, parsed piece by piece, so that a long one tells how far it has come and can be cancelled.
//!
//! Pieces begin at lines that begin with `[[object]]`. If a piece parses as a TOML document, no string, array or table
//! of it goes on in the next piece. So the pieces together say what the whole says, if each of them parses, the one
//! before the first object names no object, and at most one holds anything else. Otherwise the whole is parsed at once,
//! which also gives the error its words.

use super::{Progress, progress::Cancelled};
use toml::{
    Spanned,
    de::{DeTable, DeValue, Error},
};

/// Pieces have at least this many bytes, except the first and the last.
const LEAST: usize = 1 << 16;
/// The line that begins an object.
const OBJECT: &str = "[[object]]";

/// What a scene file's text says. Positions in a value count from the start of its piece; the number beside the value
/// is the byte where that piece starts.
pub(super) struct Parsed<'a> {
    /// All but the objects.
    pub rest: (usize, Spanned<DeTable<'a>>),
    /// The objects, in order.
    pub objects: Vec<(usize, Spanned<DeValue<'a>>)>,
}

/// Why there is no [`Parsed`].
pub(super) enum Stopped {
    Cancelled(Cancelled),
    Syntax(Error),
}

/// Parses a scene file's text. In the progress, it counts as its length.
pub(super) fn parse<'a>(text: &'a str, progress: &Progress) -> Result<Parsed<'a>, Stopped> {
    let mut done = 0;
    let parsed = in_pieces(text, LEAST, |bytes| {
        done += bytes;
        progress.advance(bytes as u64)
    });
    if let Some(parsed) = parsed.map_err(Stopped::Cancelled)? {
        return Ok(parsed);
    }
    let whole = whole(text).map_err(Stopped::Syntax)?;
    let left = (text.len() - done) as u64;
    progress.advance(left).map_err(Stopped::Cancelled)?;
    Ok(whole)
}

/// The whole text at once.
fn whole(text: &str) -> Result<Parsed<'_>, Error> {
    let mut table = DeTable::parse(text)?;
    let objects = match table.as_ref().get("object").map(Spanned::as_ref) {
        Some(DeValue::Array(_)) => table.as_mut().remove("object"),
        _ => None,
    };
    let objects = match objects.map(Spanned::into_inner) {
        Some(DeValue::Array(array)) => array.into_iter().map(|object| (0, object)).collect(),
        _ => Vec::new(),
    };
    Ok(Parsed {
        rest: (0, table),
        objects,
    })
}

/// The same by pieces of at least `least` bytes; `None` where the whole has to be parsed at once.
fn in_pieces(
    text: &str,
    least: usize,
    mut advance: impl FnMut(usize) -> Result<(), Cancelled>,
) -> Result<Option<Parsed<'_>>, Cancelled> {
    let mut objects = Vec::new();
    let mut rest: Option<(usize, Spanned<DeTable>)> = None;
    let starts = starts(text, least);
    let ends = starts.iter().copied().skip(1).chain([text.len()]);
    for (&start, end) in starts.iter().zip(ends) {
        let piece = &text[start..end];
        let Ok(mut table) = DeTable::parse(piece) else {
            return Ok(None);
        };
        match table.as_mut().remove("object").map(Spanned::into_inner) {
            None => {}
            Some(DeValue::Array(array)) if piece.starts_with(OBJECT) => {
                objects.extend(array.into_iter().map(|object| (start, object)));
            }
            Some(_) => return Ok(None),
        }
        let holds_more = !table.as_ref().is_empty();
        match &rest {
            Some((_, rest)) if holds_more && !rest.as_ref().is_empty() => return Ok(None),
            Some(_) if !holds_more => {}
            _ => rest = Some((start, table)),
        }
        advance(piece.len())?;
    }
    Ok(rest.map(|rest| Parsed { rest, objects }))
}

/// Where pieces begin: at 0, at the first object, and then at objects at least `least` bytes apart.
fn starts(text: &str, least: usize) -> Vec<usize> {
    let mut starts = vec![0];
    let line = format!("\n{OBJECT}");
    for (at, _) in text.match_indices(&line) {
        let last = starts[starts.len() - 1];
        if !text[last..].starts_with(OBJECT) || at + 1 - last >= least {
            starts.push(at + 1);
        }
    }
    starts
}

#[cfg(test)]
mod tests {
    use super::{Parsed, in_pieces, whole};
    use serde::Deserialize;
    use toml::{
        Value,
        de::{Deserializer, ValueDeserializer},
    };

    /// What was parsed: each object with its place in the text, and all the rest.
    fn told(parsed: Parsed) -> (Vec<(usize, usize, Value)>, Value) {
        let object = |(start, object): (usize, toml::Spanned<toml::de::DeValue>)| {
            let span = object.span();
            let value = Value::deserialize(ValueDeserializer::from(object)).expect("a value");
            (start + span.start, start + span.end, value)
        };
        let rest = Value::deserialize(Deserializer::from(parsed.rest.1)).expect("a value");
        (parsed.objects.into_iter().map(object).collect(), rest)
    }

    const CAMERA: &str = "[camera]\neye = [1, 2, 3]\n";
    const BALL: &str = "[[object]]\nshape = \"sphere\"\nscale = [\n1,\n2, 3]\n";
    const CUBE: &str = "[[object]] # a cube\r\nshape = \"cube\"\r\n";

    #[test]
    fn pieces_say_what_the_whole_says() {
        let sub = "[[object]]\nshape = \"cube\"\n[object.more]\nx = 1\n";
        for text in [
            String::new(),
            CAMERA.into(),
            BALL.repeat(9),
            [CAMERA, BALL, CUBE, BALL, sub, CUBE].concat(),
            [CUBE, BALL, CAMERA, CUBE, BALL].concat(),
            format!("# nothing\n{BALL}{CUBE}{CAMERA}"),
        ] {
            for least in [1, 60, 100_000] {
                let mut done = 0;
                let parsed = in_pieces(&text, least, |bytes| {
                    done += bytes;
                    Ok(())
                });
                let parsed = parsed.expect("nobody cancels").expect("pieces");
                let expected = told(whole(&text).expect("a document"));
                assert_eq!(told(parsed), expected, "{least}: {text}");
                assert_eq!(done, text.len());
            }
        }
    }

    /// Either the whole is no document, or a line that looks like an object is in a string or in an array.
    #[test]
    fn where_pieces_do_not_tell_the_whole_does() {
        let in_string = "[[object]]\nname = '''\n[[object]]\nshape = 1\n'''\nshape = \"cube\"\n";
        let in_array = "[[object]]\nscale = [\n[[object]]\n]\n";
        for (text, is_document) in [
            (in_string.to_owned(), true),
            (in_array.to_owned(), false),
            (format!("{CAMERA}{BALL}{CAMERA}"), false),
            (format!("{CAMERA}{BALL}[camera.more]\nx = 1\n"), true),
            (format!("object = []\n{BALL}"), false),
            (format!("object = 1\n{BALL}"), false),
            (format!("{BALL}[object]\n"), false),
            (format!("{BALL}{CUBE}["), false),
            ("object = [{}]\n".to_owned(), true),
        ] {
            let parsed = in_pieces(&text, 1, |_| Ok(()));
            assert!(parsed.expect("nobody cancels").is_none(), "{text}");
            assert_eq!(whole(&text).is_ok(), is_document, "{text}");
        }
    }
}
