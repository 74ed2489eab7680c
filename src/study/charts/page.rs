//! A page: its head and its words. Lengths are in the backend's pixels, two of which are one of a PNG file.

use super::{DrawError, Drawn, Failed, prelude::*};
use plotters::{
    coord::Shift,
    style::{
        FontStyle, register_font,
        text_anchor::{HPos, Pos, VPos},
    },
};

/// A page, or a part of one.
pub type Page<B> = DrawingArea<B, Shift>;

const FONT: &str = "sans-serif";
/// Sizes of a title, of a panel's title, and of all other words.
const TITLE: f64 = 76.0;
const HEADING: f64 = 54.0;
pub const WORDS: f64 = 42.0;

/// Registers the typeface; doing so again changes nothing.
pub fn register_typeface() -> Result<(), DrawError> {
    register_font(FONT, FontStyle::Normal, epaint_default_fonts::UBUNTU_LIGHT)
        .map_err(|_| DrawError("the typeface is not one".to_owned()))
}

/// The side of a point on which words stand.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Side {
    /// They end there.
    Left,
    /// They are centred on it.
    Middle,
    /// They begin there.
    Right,
}

/// Words of a size.
pub fn style(size: f64, ink: Ink, side: Side) -> TextStyle<'static> {
    let h_pos = match side {
        Side::Left => HPos::Right,
        Side::Middle => HPos::Center,
        Side::Right => HPos::Left,
    };
    let style = (FONT, size).into_font().color(&ink);
    style.pos(Pos::new(h_pos, VPos::Center))
}

/// Writes words beside a point.
pub fn words<B: DrawingBackend>(
    page: &Page<B>,
    text: &str,
    at: (i32, i32),
    ink: Ink,
    side: Side,
) -> Drawn<B> {
    sized(page, text, at, style(WORDS, ink, side))
}

/// [`words`] for what stands in narrow columns.
pub fn small_words<B: DrawingBackend>(
    page: &Page<B>,
    text: &str,
    at: (i32, i32),
    ink: Ink,
) -> Drawn<B> {
    sized(page, text, at, style(0.8 * WORDS, ink, Side::Middle))
}

fn sized<B: DrawingBackend>(
    page: &Page<B>,
    text: &str,
    at: (i32, i32),
    style: TextStyle<'_>,
) -> Drawn<B> {
    // `plotters` centres the height of a line; this centres its letters.
    let at = (at.0, at.1 + 5);
    page.draw(&Text::new(text, at, style))
}

/// Draws a line of squares, each with what its colour means.
pub fn legend<B: DrawingBackend>(
    page: &Page<B>,
    (mut x, y): (i32, i32),
    all: &[(Ink, &str)],
) -> Drawn<B> {
    for (ink, text) in all {
        page.draw(&Rectangle::new([(x, y), (x + 44, y + 42)], ink.filled()))?;
        words(page, text, (x + 60, y + 21), INK, Side::Right)?;
        x += 120 + width(page, text)?;
    }
    Ok(())
}

/// The width of words.
pub fn width<B: DrawingBackend>(page: &Page<B>, text: &str) -> Result<i32, Failed<B>> {
    let (width, _) = page.estimate_text_size(text, &style(WORDS, INK, Side::Right))?;
    Ok(i32::try_from(width).unwrap_or(i32::MAX))
}

/// Writes a page's message and the lines below it; the rest of the page is given back.
pub fn head<B: DrawingBackend>(
    page: &Page<B>,
    message: &str,
    lines: &[String],
) -> Result<Page<B>, Failed<B>> {
    page.fill(&WHITE)?;
    page.draw(&Text::new(
        message,
        (48, 70),
        style(TITLE, INK, Side::Right),
    ))?;
    let mut y = 142;
    for line in lines {
        words(page, line, (48, y), QUIET, Side::Right)?;
        y += 54;
    }
    Ok(page.margin(y - 10, 24, 40, 40))
}

/// Writes a part's title; the rest of the part is given back.
pub fn heading<B: DrawingBackend>(part: &Page<B>, title: &str) -> Result<Page<B>, Failed<B>> {
    if title.is_empty() {
        return Ok(part.clone());
    }
    part.draw(&Text::new(
        title,
        (12, 30),
        style(HEADING, INK, Side::Right),
    ))?;
    Ok(part.margin(60, 0, 0, 0))
}

/// How many rays of a step stand behind a point, and which processor: for a page's lines. A point is a method's, or a
/// method's at one value of a parameter.
pub fn about(report: &Report, step: &str, is_of_one_value: bool) -> String {
    let all = report.summaries_of(step);
    let ours = all.iter().find(|summary| summary.method.info.ours);
    let rows = ours.into_iter().flat_map(|summary| &summary.rows);
    let cases: usize = rows
        .map(|row| row.cases)
        .take(if is_of_one_value { 1 } else { usize::MAX })
        .sum();
    format!("{cases} rays a point; {}", crate::study::processor())
}
