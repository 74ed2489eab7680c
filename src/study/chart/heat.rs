//! A heat map of methods by families. A cell's colour shows how far off a method is there, and its number how often.

use super::prelude::*;
use plotters::prelude::{ColorMap, ViridisRGB};

/// The powers of ten, in pixels, at which the colours begin and end.
const SCALE: [f64; 2] = [-12.0, 3.0];
/// Width of half a cell: a formula in `f32` on the left, in `f64` or exact on the right.
const HALF: f64 = 28.0;
const ROW: f64 = 25.0;
/// Width of the methods' names, and height of the lines above a block's cells.
const NAMES: f64 = 202.0;
const HEAD: f64 = 78.0;
/// Top of the first blocks.
const TOP: f64 = 96.0;

/// Families and formulas of a step, with their rows.
struct Block<'a> {
    step: About,
    rows: Vec<&'a Row>,
    families: Vec<&'a str>,
    methods: Vec<&'a str>,
}

impl<'a> Block<'a> {
    fn new(report: &'a Report, step: About) -> Self {
        let rows: Vec<&Row> = report.of_step(step).collect();
        Self {
            step,
            families: distinct(rows.iter().map(|row| row.family)),
            methods: distinct(rows.iter().map(|row| row.info.name)),
            rows,
        }
    }

    fn height(&self) -> f64 {
        HEAD + ROW * count(self.methods.len()) + 26.0
    }
}

/// The chart, of the steps whose errors are in pixels.
pub fn chart(report: &Report) -> Picture {
    let mut steps = report.steps();
    steps.retain(|step| [step.wrong_unit, step.error_unit].contains(&"px"));
    let blocks = steps.into_iter().map(|step| Block::new(report, step));
    let mut blocks: Vec<Block<'_>> = blocks.collect();
    // The largest first, each into the column that is shorter so far.
    blocks.sort_by(|a, b| b.height().total_cmp(&a.height()));
    let mut ends = [(24.0, TOP), (0.5 * WIDTH + 12.0, TOP)];
    let places = blocks.iter().map(|block| {
        let column = usize::from(ends[1].1 < ends[0].1);
        let (x, y) = ends[column];
        ends[column].1 += block.height();
        [x, y]
    });
    let places: Vec<[f64; 2]> = places.collect();
    let title = "Where each method fails";
    let line = "Colour: how far off at worst. Number: wrong answers in per cent; of rays, the power of ten of the error in px. Left f32, right f64 or \
                exact; blank: never wrong.";
    let mut picture = page(ends[0].1.max(ends[1].1), title, &[line]);
    legend(&mut picture);
    for (block, at) in blocks.iter().zip(places) {
        draw(&mut picture, block, at);
    }
    picture
}

/// White for 0, else darker for larger distances.
fn colour(px: f64) -> Colour {
    if px <= 0.0 {
        return [0xff; 3];
    }
    let share = (libm::log10(px) - SCALE[0]) / (SCALE[1] - SCALE[0]);
    let from_light = ViridisRGB.get_color(1.0 - share.clamp(0.0, 1.0));
    [from_light.0, from_light.1, from_light.2]
}

/// Dark on light, light on dark.
fn ink(on: Colour) -> Colour {
    let [r, g, b] = on.map(f64::from);
    if 0.3 * r + 0.59 * g + 0.11 * b > 120.0 {
        INK
    } else {
        [0xff; 3]
    }
}

fn legend(picture: &mut Picture) {
    const STEP: f64 = 26.0;
    let mut x = WIDTH - 24.0 - 18.0 * STEP;
    let ties = [x - 3.2 * STEP, 18.0];
    picture.rectangle(ties, [ties[0] + STEP, 34.0], [0xff; 3]);
    #[expect(clippy::cast_possible_truncation, reason = "two small integers")]
    for exponent in SCALE[0] as i32..=SCALE[1] as i32 {
        let px = 10_f64.powi(exponent);
        picture.rectangle([x, 18.0], [x + STEP, 34.0], colour(px));
        if exponent.rem_euclid(3) == 0 {
            let words = match exponent {
                0 => "1 px".to_owned(),
                _ => format!("{px:.0e}"),
            };
            picture.text([x + 0.5 * STEP, 44.0], Anchor::Middle, 14.0, QUIET, words);
        }
        x += STEP;
    }
    picture.text([ties[0], 26.0], Anchor::Left, 14.0, QUIET, "white: ties");
}

fn draw(picture: &mut Picture, block: &Block<'_>, [left, top]: [f64; 2]) {
    picture.text([left, top + 12.0], Anchor::Left, 20.0, INK, block.step.name);
    let right = left + NAMES;
    let columns = (0..).map(|i| right + 2.0 * HALF * f64::from(i));
    let rows = || (0..).map(|i| top + HEAD + ROW * f64::from(i));
    for (method, y) in block.methods.iter().zip(rows()) {
        let at = [right - 8.0, y + 0.5 * ROW];
        picture.text(at, Anchor::Right, 15.0, INK, *method);
    }
    for (family, x) in block.families.iter().zip(columns) {
        let lines = wrapped(family, 11);
        for (line, up) in lines.iter().rev().zip((0..).map(f64::from)) {
            let at = [x + HALF, top + HEAD - 10.0 - 14.0 * up];
            picture.text(at, Anchor::Middle, 13.5, QUIET, line);
        }
        for (method, y) in block.methods.iter().zip(rows()) {
            let own = block.rows.iter().copied();
            let own = own.filter(|row| (row.family, row.info.name) == (*family, *method));
            let (narrow, others): (Vec<_>, Vec<_>) = own.partition(|row| row.info.precision == F32);
            for (rows, x) in [(narrow, x), (others, x + HALF)] {
                cell(picture, [x, y], &rows);
            }
        }
    }
}

/// The cell of a method in one precision and one family; none where it has no rows.
fn cell(picture: &mut Picture, [x, y]: [f64; 2], rows: &[&Row]) {
    let Some(first) = rows.first() else { return };
    let decides = !first.info.step.wrong_unit.is_empty();
    let most = |of: fn(&Row) -> f64| rows.iter().map(|row| of(row)).fold(0.0, f64::max);
    let wrong = most(Row::wrong_percent);
    let px = if decides {
        most(|row| row.worst_wrong)
    } else {
        most(|row| row.worst_error)
    };
    let colour = colour(px);
    picture.rectangle([x, y], [x + HALF - 1.0, y + ROW - 1.0], [0xe4; 3]);
    picture.rectangle([x + 1.0, y + 1.0], [x + HALF - 2.0, y + ROW - 2.0], colour);
    let words = match (decides, wrong) {
        (true, 0.0) => String::new(),
        (true, ..1.0) => "<1".to_owned(),
        (true, _) => format!("{wrong:.0}"),
        (false, _) if px.is_infinite() => "inf".to_owned(),
        (false, _) => format!("{:.0}", libm::log10(px).floor()),
    };
    let middle = [x + 0.5 * HALF - 0.5, y + 0.5 * ROW - 0.5];
    picture.text(middle, Anchor::Middle, 17.0, ink(colour), words);
}

/// Wraps words into lines of about `letters` characters.
fn wrapped(words: &str, letters: usize) -> Vec<String> {
    let mut lines: Vec<String> = Vec::new();
    for word in words.split(' ') {
        match lines.last_mut() {
            Some(line) if line.len() + word.len() < letters => *line = format!("{line} {word}"),
            _ => lines.push(word.to_owned()),
        }
    }
    lines
}
