//! What the charts share: a page's head, panels with axes, words, and a fixed colour for each method. Lengths are in the
//! backend's pixels, two of which are one of a PNG file.

use super::{DrawError, Drawn, Failed, prelude::*};
use plotters::{
    coord::{
        Shift,
        ranged1d::{KeyPointHint, NoDefaultFormatting, Ranged, ValueFormatter},
        types::RangedCoordf64,
    },
    element::DashedPathElement,
    style::{
        FontStyle, register_font,
        text_anchor::{HPos, Pos, VPos},
    },
};
use std::ops::Range;

/// A page, or a part of one.
pub type Page<B> = DrawingArea<B, Shift>;

/// A colour.
pub type Ink = RGBColor;
/// Text, axes, and Sightline's own method.
pub const INK: Ink = RGBColor(0x22, 0x22, 0x22);
/// Secondary text.
pub const QUIET: Ink = RGBColor(0x55, 0x55, 0x55);
/// Methods without a name on a chart.
pub const GREY: Ink = RGBColor(0xb4, 0xb4, 0xb4);
/// Lines that guide the eye.
const FAINT: Ink = RGBColor(0xe2, 0xe2, 0xe2);
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

const FONT: &str = "sans-serif";
/// Sizes of a title, of a panel's title, and of all other words.
const TITLE: f64 = 76.0;
const HEADING: f64 = 54.0;
const WORDS: f64 = 42.0;

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

fn style(size: f64, ink: Ink, side: Side) -> TextStyle<'static> {
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

/// How many cases and which processor stand behind a method's figures: for a page's lines.
pub fn about(report: &Report, step: &str) -> String {
    let rows = report.rows.iter().filter(|row| row.info.step.key == step);
    let first = rows.clone().find(|row| row.info.ours).map(|row| row.info);
    let own = rows.filter(|row| Some(row.info) == first);
    let cases: usize = own.map(|row| row.cases).sum();
    format!("{cases} rays a point; {}", crate::study::processor())
}

/// An axis, as a coordinate of `plotters`.
#[derive(Clone, Debug)]
pub struct Axis {
    name: String,
    is_log: bool,
    /// Scaled.
    ends: [f64; 2],
    /// Values, each with its words.
    ticks: Vec<(f64, String)>,
    /// Where 0 stands, scaled.
    none: Option<f64>,
}

impl Axis {
    /// A logarithmic axis over all values above 0 that are finite.
    pub fn powers_of_ten(name: impl Into<String>, values: impl IntoIterator<Item = f64>) -> Self {
        let is_on = |value: &f64| value.is_finite() && *value > 0.0;
        let values = values.into_iter().filter(is_on).map(libm::log10);
        let values: Vec<f64> = values.collect();
        let low = values.iter().copied().reduce(f64::min).unwrap_or(0.0);
        let high = values.iter().copied().reduce(f64::max).unwrap_or(1.0);
        Self::between(name, [low, high.max(low + 0.3)])
    }

    /// A logarithmic axis between two powers of ten.
    pub fn between(name: impl Into<String>, ends: [f64; 2]) -> Self {
        let decades = (ends[1] - ends[0]).max(1.0);
        #[expect(clippy::cast_possible_truncation, reason = "exponents of f64")]
        let (first, last) = (ends[0].floor() as i32, ends[1].ceil() as i32);
        // A tick at every power, every second or third, or at 1, 2 and 5 of each.
        let every = match decades {
            ..5.0 => 1,
            ..9.0 => 2,
            _ => 3,
        };
        let within: &[f64] = if decades < 3.0 {
            &[1.0, 2.0, 5.0]
        } else {
            &[1.0]
        };
        let powers = (first..=last).filter(|power| power.rem_euclid(every) == 0);
        let values = powers.flat_map(|power| within.iter().map(move |by| by * 10_f64.powi(power)));
        let ticks = values.map(|value| (value, number(value)));
        let span = ends[0] - 1e-9..=ends[1] + 1e-9;
        let is_within = |(value, _): &(f64, String)| span.contains(&libm::log10(*value));
        Self {
            name: name.into(),
            is_log: true,
            ends,
            ticks: ticks.filter(is_within).collect(),
            none: None,
        }
    }

    /// A linear axis from 0 to `most`, with a tick at each `step`.
    pub fn linear(name: impl Into<String>, most: f64, step: f64) -> Self {
        let ticks = (0..=20_u8).map(|i| f64::from(i) * step);
        let ticks = ticks.filter(|value| *value <= most * (1.0 + 1e-9));
        Self {
            name: name.into(),
            is_log: false,
            ends: [0.0, most],
            ticks: ticks.map(|value| (value, number(value))).collect(),
            none: None,
        }
    }

    /// With room before the first end, as a share of the axis: 0 stands there, under these words.
    pub fn with_none(mut self, share: f64, words: &str) -> Self {
        let room = (self.ends[1] - self.ends[0]) * share / (1.0 - share);
        let none = self.ends[0] - 0.5 * room;
        self.ends[0] -= room;
        self.ticks.push((0.0, words.to_owned()));
        self.none = Some(none);
        self
    }

    /// With room at both ends, in powers of ten.
    pub fn wider(self, by: [f64; 2]) -> Self {
        Self::between(self.name, [self.ends[0] - by[0], self.ends[1] + by[1]])
    }

    /// The axis of so many rows of 0, beside whatever else it has.
    pub fn with_rows(self, rows: usize, words: &str) -> Self {
        let rows = f64::from(u32::try_from(rows).unwrap_or(0));
        self.with_none((0.045 * rows).clamp(0.03, 0.6), words)
    }

    /// The harmless end first, where values go down.
    pub fn turned(mut self, is_turned: bool) -> Self {
        if is_turned {
            self.ends.reverse();
        }
        self
    }

    fn scaled(&self, value: f64) -> f64 {
        match (self.none, self.is_log) {
            (Some(none), _) if value == 0.0 => none,
            (_, true) => libm::log10(value),
            (_, false) => value,
        }
    }
}

/// A value beyond an end stands at that end.
impl Ranged for Axis {
    type FormatOption = NoDefaultFormatting;
    type ValueType = f64;

    fn map(&self, value: &f64, limit: (i32, i32)) -> i32 {
        let [a, b] = self.ends;
        let scaled = self.scaled(*value).clamp(a.min(b), a.max(b));
        RangedCoordf64::from(a..b).map(&scaled, limit)
    }

    fn key_points<Hint: KeyPointHint>(&self, hint: Hint) -> Vec<f64> {
        let ticks = self.ticks.iter().map(|(value, _)| *value);
        let ticks = ticks.filter(|_| !hint.weight().allow_light_points());
        ticks.collect()
    }

    fn range(&self) -> Range<f64> {
        f64::NEG_INFINITY..f64::INFINITY
    }
}

impl ValueFormatter<f64> for Axis {
    fn format_ext(&self, value: &f64) -> String {
        let is_at = |(tick, _): &&(f64, String)| tick.total_cmp(value).is_eq();
        let tick = self.ticks.iter().find(is_at);
        tick.map_or_else(String::new, |(_, words)| words.clone())
    }
}

/// A tick's words.
fn number(value: f64) -> String {
    if value == 0.0 || (0.0099..1001.0).contains(&value) {
        format!("{}", (value * 1e6).round() / 1e6)
    } else {
        format!("{value:.0e}")
    }
}

/// A frame with two axes and a mesh.
pub struct Panel<'a, B: DrawingBackend> {
    /// The whole page, in whose pixels marks are drawn.
    pub page: &'a Page<B>,
    chart: ChartContext<'a, B, Cartesian2d<Axis, Axis>>,
}

/// Draws a titled panel into a part of a page, with room for labels to the right of its frame.
pub fn panel<'a, B: DrawingBackend>(
    page: &'a Page<B>,
    part: &Page<B>,
    title: &str,
    [x, y]: [Axis; 2],
    labels: i32,
) -> Result<Panel<'a, B>, Failed<B>> {
    let part = heading(part, title)?;
    let mut chart = ChartBuilder::on(&part)
        .margin(14)
        .margin_right(14 + labels)
        .x_label_area_size(108)
        .y_label_area_size(if y.name.is_empty() { 120 } else { 170 })
        .build_cartesian_2d(x.clone(), y.clone())?;
    let ticks = style(0.88 * WORDS, QUIET, Side::Middle);
    chart
        .configure_mesh()
        .bold_line_style(FAINT.stroke_width(2))
        .light_line_style(TRANSPARENT)
        .axis_style(INK.stroke_width(2))
        .label_style(ticks)
        .axis_desc_style(style(WORDS, INK, Side::Middle))
        .x_desc(&x.name)
        .y_desc(&y.name)
        .draw()?;
    Ok(Panel { page, chart })
}

impl<B: DrawingBackend> Panel<'_, B> {
    /// The page's pixel at a pair of values.
    pub fn at(&self, x: f64, y: f64) -> (i32, i32) {
        self.chart.backend_coord(&(x, y))
    }

    /// The frame in the page's pixels: left, top, right and bottom.
    pub fn frame(&self) -> [i32; 4] {
        let (x, y) = self.chart.plotting_area().get_pixel_range();
        [x.start, y.start, x.end, y.end]
    }

    /// Fills the panel's width between two values of y.
    pub fn band(&self, [from, to]: [f64; 2], ink: Ink) -> Drawn<B> {
        let [left, _, right, _] = self.frame();
        let [a, b] = [from, to].map(|y| self.at(1.0, y).1);
        let area = [(left, a.min(b)), (right, a.max(b))];
        self.page.draw(&Rectangle::new(area, ink.filled()))
    }

    /// The height of the room for 0, in pixels.
    fn room(&self) -> i32 {
        let [_, _, _, bottom] = self.frame();
        2 * (bottom - self.at(1.0, 0.0).1)
    }

    /// Fills the room for 0.
    pub fn none_band(&self) -> Drawn<B> {
        let [left, _, right, bottom] = self.frame();
        let area = [(left + 2, bottom - self.room()), (right, bottom - 2)];
        self.page.draw(&Rectangle::new(area, NOBODY_SEES.filled()))
    }

    /// The page's pixel at a value of x in a row of the room for 0.
    pub fn in_none(&self, x: f64, row: usize, of: usize) -> (i32, i32) {
        let [_, _, _, bottom] = self.frame();
        let [row, of] = [row, of.max(1)].map(|count| i32::try_from(count).unwrap_or(1));
        let (x, _) = self.at(x, 0.0);
        (
            x,
            bottom - self.room() + self.room() * (2 * row + 1) / (2 * of),
        )
    }

    /// Writes words to the right of a point where there is room, else to the left.
    pub fn beside(&self, text: &str, (x, y): (i32, i32), away: i32) -> Drawn<B> {
        let [_, _, right, _] = self.frame();
        if x + away + width(self.page, text)? < right {
            words(self.page, text, (x + away, y), INK, Side::Right)
        } else {
            words(self.page, text, (x - away, y), INK, Side::Left)
        }
    }

    /// Names lines at their ends, to the right of the frame.
    pub fn end_labels(&self, mut ends: Vec<((i32, i32), String, Ink)>) -> Drawn<B> {
        let [_, top, right, bottom] = self.frame();
        ends.sort_by_key(|((_, y), ..)| *y);
        let wanted: Vec<i32> = ends.iter().map(|((_, y), ..)| *y).collect();
        let places = label_places(&wanted, 46, [top + 16, bottom - 16]);
        for (((_, y), text, ink), place) in ends.into_iter().zip(places) {
            let line = [(right + 4, y), (right + 32, place)];
            self.page
                .draw(&PathElement::new(line, ink.stroke_width(2)))?;
            words(self.page, &text, (right + 40, place), INK, Side::Right)?;
        }
        Ok(())
    }

    /// Draws a line through pairs of values: dashed, or solid.
    pub fn line(&self, values: &[[f64; 2]], ink: Ink, width: u32, is_dashed: bool) -> Drawn<B> {
        let points = values.iter().map(|[x, y]| self.at(*x, *y));
        let points: Vec<(i32, i32)> = points.collect();
        let style = ink.stroke_width(width);
        if is_dashed {
            let dashed = DashedPathElement::new(points, 14, 12, style);
            self.page.draw(&dashed)
        } else {
            self.page.draw(&PathElement::new(points, style))
        }
    }
}

/// A point: a star for Sightline, a ring in `f32`, else a disc.
pub fn star<B: DrawingBackend>(
    page: &Page<B>,
    (x, y): (i32, i32),
    info: &MethodInfo,
    ink: Ink,
    radius: i32,
) -> Drawn<B> {
    if info.ours {
        let corner = |i: u32| {
            let turn = f64::from(i) / 10.0 - 0.25;
            let r = f64::from(radius) * if i.is_multiple_of(2) { 1.9 } else { 0.85 };
            let (sin, cos) = libm::sincos(turn * std::f64::consts::TAU);
            #[expect(clippy::cast_possible_truncation, reason = "a few pixels")]
            let [dx, dy] = [r * cos, r * sin].map(|d| d.round() as i32);
            (x + dx, y + dy)
        };
        return page.draw(&Polygon::new((0..10).map(corner).collect::<Vec<_>>(), ink));
    }
    page.draw(&Circle::new((x, y), radius, ink.filled()))?;
    if info.precision == F32 {
        page.draw(&Circle::new((x, y), radius - 6, WHITE.filled()))?;
    }
    Ok(())
}

/// Places for labels of a height, in order and apart, beside the wanted ones, which are sorted, and within a range.
fn label_places(wanted: &[i32], height: i32, [from, to]: [i32; 2]) -> Vec<i32> {
    let mut low = from;
    let down = wanted.iter().map(|wanted| {
        let place = low.max(*wanted);
        low = place + height;
        place
    });
    let mut places: Vec<i32> = down.collect();
    let mut high = to;
    for place in places.iter_mut().rev() {
        *place = high.min(*place);
        high = *place - height;
    }
    places
}
