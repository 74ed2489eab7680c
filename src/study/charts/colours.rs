//! The charts' colours: each method has its own, the same in every chart and in every run.

use super::prelude::*;

/// A colour.
pub type Ink = RGBColor;
/// Text, axes, and Sightline's own method.
pub const INK: Ink = RGBColor(0x22, 0x22, 0x22);
/// Secondary text.
pub const QUIET: Ink = RGBColor(0x55, 0x55, 0x55);
/// Methods without a name on a chart.
pub const GREY: Ink = RGBColor(0xb4, 0xb4, 0xb4);
/// Lines that guide the eye.
pub const FAINT: Ink = RGBColor(0xe2, 0xe2, 0xe2);
/// The background of what nobody sees, or never happens.
pub const NOBODY_SEES: Ink = RGBColor(0xe9, 0xf4, 0xee);
/// The background of what everybody sees.
pub const WARNING: Ink = RGBColor(0xfb, 0xe9, 0xe4);

/// Okabe & Ito's colours, which people of every colour vision tell apart.
const BLUE: Ink = RGBColor(0x00, 0x72, 0xb2);
const ORANGE: Ink = RGBColor(0xd5, 0x5e, 0x00);
const GREEN: Ink = RGBColor(0x00, 0x9e, 0x73);
const PINK: Ink = RGBColor(0xcc, 0x79, 0xa7);
const SKY: Ink = RGBColor(0x56, 0xb4, 0xe9);
const AMBER: Ink = RGBColor(0xe6, 0x9f, 0x00);
/// And one of Tol's.
const WINE: Ink = RGBColor(0x88, 0x22, 0x55);

/// The methods that charts name, each with its colour: the same in every chart and in every run.
const NAMED: [(&str, Ink); 26] = [
    ("inverse(P V), far - near", ORANGE),
    ("unproject, as three.js", PINK),
    ("unproject, as Bevy", SKY),
    ("eye basis", GREEN),
    ("inverse(M)", ORANGE),
    ("inverse(A) (o - T)", GREEN),
    ("Moeller-Trumbore", ORANGE),
    ("Embree robust", BLUE),
    ("Woop watertight", GREEN),
    ("Shewchuk's orient3d", PINK),
    ("plain quadratic", ORANGE),
    ("Hearn & Baker", GREEN),
    ("slabs with a branch", ORANGE),
    ("N . (S - o)", ORANGE),
    ("D - N . o", BLUE),
    ("standard, 32-bit float", ORANGE),
    ("standard, 24-bit integer", PINK),
    ("reversed, 24-bit integer", BLUE),
    ("logarithmic, 32-bit float", GREEN),
    ("f32 in the world", ORANGE),
    ("f32 about each file's origin", SKY),
    ("f32 about the eye", PINK),
    ("f64 throughout", GREEN),
    ("three.js's way", AMBER),
    ("Bevy's way", BLUE),
    ("VTK's way", WINE),
];

/// A method's own colour; `None` where charts don't name it.
pub fn colour(info: &MethodInfo) -> Option<Ink> {
    let named = NAMED.iter().find(|(name, _)| *name == info.name);
    if info.ours {
        Some(INK)
    } else {
        named.map(|(_, colour)| *colour)
    }
}

/// What charts call a method.
pub fn name(info: &MethodInfo) -> &'static str {
    if info.ours { "Sightline" } else { info.name }
}
