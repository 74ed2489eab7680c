//! Parsers of the flags' values.

use crate::{
    camera::Viewport,
    geometry::range,
    replace::is_stdout,
    viewer::model::{Stage, Views},
};
use clap::builder::{PathBufValueParser, PossibleValuesParser, TypedValueParser};
use glam::{DVec2, DVec3};
use std::{
    fs,
    io::{self, IsTerminal},
    path::PathBuf,
};

/// A number in range.
pub(super) fn number(text: &str) -> Result<f64, String> {
    let value: f64 = text.trim().parse().map_err(|_| "expected a number")?;
    let is_in_range = range::stored(value).is_some();
    is_in_range
        .then_some(value)
        .ok_or_else(|| "expected a number up to 1.29e33".to_owned())
}

/// `N` numbers between commas.
fn numbers<const N: usize>(text: &str, form: &str) -> Result<[f64; N], String> {
    let values: Result<Vec<f64>, _> = text.split(',').map(number).collect();
    let values = values.ok().and_then(|values| values.try_into().ok());
    values.ok_or_else(|| format!("expected {form}: numbers up to 1.29e33 with commas"))
}

/// `x,y,z`
pub(super) fn vector(text: &str) -> Result<DVec3, String> {
    numbers(text, "x,y,z").map(DVec3::from_array)
}

/// `X,Y`
pub(super) fn point(text: &str) -> Result<DVec2, String> {
    numbers(text, "X,Y").map(DVec2::from_array)
}

/// Which views of a scene are shown.
pub(super) const VIEWS: [(&str, Views); 6] = [
    ("picture", Views::Picture),
    ("four", Views::Four),
    ("object", Views::One(Stage::Object)),
    ("world", Views::One(Stage::World)),
    ("view", Views::One(Stage::View)),
    ("ndc", Views::One(Stage::Ndc)),
];

/// One of these words, for the value beside it.
pub(super) fn word<T: Copy + Send + Sync + 'static, const N: usize>(
    words: [(&'static str, T); N],
) -> impl TypedValueParser<Value = T> {
    PossibleValuesParser::new(words.map(|(word, _)| word)).map(move |word| {
        let place = words.iter().position(|(name, _)| *name == word);
        words[place.unwrap_or(0)].1
    })
}

/// The seed of the random numbers.
pub(super) fn seed(text: &str) -> Result<u64, String> {
    let seed = text.trim().parse();
    seed.map_err(|_| "expected a whole number from 0".to_owned())
}

/// A radius in pixels.
pub(super) fn radius(text: &str) -> Result<f64, String> {
    let radius = number(text)
        .ok()
        .filter(|radius| (0.0..=256.0).contains(radius));
    radius.ok_or_else(|| "expected pixels, from 0 to 256".to_owned())
}

/// An object's id.
pub(super) fn id(text: &str) -> Result<usize, String> {
    let id = text.trim().parse();
    id.map_err(|_| "expected ids from 1, as in 3,5; sightline list has them".to_owned())
}

/// The path of a PNG file to write, or of a device.
pub(super) fn png() -> impl TypedValueParser<Value = PathBuf> {
    PathBufValueParser::new().try_map(png_file)
}

/// The path of a PNG file to write, or `-` for standard output.
pub(super) fn png_or_stdout() -> impl TypedValueParser<Value = PathBuf> {
    PathBufValueParser::new().try_map(|path| match is_stdout(&path) {
        false => png_file(path),
        true if io::stdout().is_terminal() => Err("a terminal shows no PNG: pipe it"),
        true => Ok(path),
    })
}

fn png_file(path: PathBuf) -> Result<PathBuf, &'static str> {
    let ending = path.extension().unwrap_or_default();
    let is_other = || fs::metadata(&path).is_ok_and(|about| !about.is_file());
    if ending.eq_ignore_ascii_case("png") || is_other() {
        Ok(path)
    } else {
        Err("pictures are PNG files: expected a name in .png")
    }
}

/// `WxH`
pub(super) fn size(text: &str) -> Result<Viewport, String> {
    let sides = text.split_once(['x', 'X']);
    let side = |text: &str| {
        let side: u32 = text.parse().ok()?;
        (1..=Viewport::LARGEST_SIDE).contains(&side).then_some(side)
    };
    let sides = sides.and_then(|(width, height)| Some((side(width)?, side(height)?)));
    let (width, height) = sides.ok_or_else(|| {
        format!(
            "expected WxH with 1 to {} pixels a side",
            Viewport::LARGEST_SIDE
        )
    })?;
    Viewport::new(width, height).map_err(|error| error.to_string())
}
