//! A heat map of methods by families: from which value of its parameter on each method is off by half a pixel.

use super::{page::heading, prelude::*};

/// Width of half a cell, a formula in `f32` on the left, in `f64` or exact on the right; and height of a row.
const HALF: i32 = 68;
const ROW: i32 = 38;
/// Width of the methods' names, height of a line of the families' names, and of a block's title.
const NAMES: i32 = 480;
const LINE: i32 = 32;
const TITLE: i32 = 58;
/// Where the second column of blocks begins.
const RIGHT: i32 = 1760;
/// An answer further off than this fails.
const FAILS_PX: f64 = 0.5;

/// How far off, in pixels, up to which bound; with its colour and words. From light to dark in grey, too.
const CLASSES: [(f64, Ink, &str); 4] = [
    (
        0.0,
        RGBColor(0xf1, 0xf5, 0xf3),
        "never wrong, or at ties only",
    ),
    (0.01, RGBColor(0xfb, 0xdf, 0x9c), "by less than 0.01 px"),
    (
        FAILS_PX,
        RGBColor(0xee, 0x8a, 0x3a),
        "by less than half a pixel",
    ),
    (f64::INFINITY, RGBColor(0x8e, 0x16, 0x1c), "by more"),
];

/// A step's methods and families, without those that make nothing worse.
struct Block<'a> {
    step: About,
    rows: Vec<&'a Row>,
    families: Vec<&'a str>,
    methods: Vec<&'a str>,
}

impl<'a> Block<'a> {
    fn new(report: &'a Report, step: About) -> Self {
        let rows = report.of_step(step);
        let rows = rows.filter(|row| !["ordinary", HIT_RATE, AT_EDGES].contains(&row.family));
        let rows: Vec<&Row> = rows.collect();
        Self {
            step,
            families: distinct(rows.iter().map(|row| row.family)),
            methods: distinct(rows.iter().map(|row| row.info.name)),
            rows,
        }
    }

    /// The height of its title and its families' names.
    fn head(&self) -> i32 {
        let lines = self.families.iter().map(|family| wrapped(family).len());
        TITLE + LINE * whole(1 + lines.max().unwrap_or(0)) + 10
    }

    fn height(&self) -> i32 {
        self.head() + ROW * whole(self.methods.len()) + 20
    }
}

fn whole(count: usize) -> i32 {
    i32::try_from(count).unwrap_or(0)
}

/// Draws the chart, of the steps whose errors are in pixels.
pub fn draw<B: DrawingBackend>(page: &Page<B>, report: &Report) -> Drawn<B> {
    let mut steps = report.steps();
    steps.retain(|step| [step.wrong_unit, step.error_unit].contains(&"px"));
    let blocks = steps.into_iter().map(|step| Block::new(report, step));
    let mut blocks: Vec<Block<'_>> = blocks.collect();
    let line = format!(
        "Number: from which value of the parameter on an answer is off by more than half a pixel. {}",
        about(report, "triangle", true)
    );
    let rest = head(page, &message(&blocks), &[line])?;
    let (left, top) = rest.get_base_pixel();
    let classes = CLASSES.map(|(_, ink, text)| (ink, text));
    legend(page, (48, top + 6), &classes)?;
    // The largest first, each into the column that is shorter so far.
    blocks.sort_by_key(|block| -block.height());
    let mut ends = [top + 64; 2];
    for block in &blocks {
        let column = usize::from(ends[1] < ends[0]);
        let at = (left + [0, RIGHT][column], ends[column]);
        draw_block(page, block, at)?;
        ends[column] += block.height();
    }
    Ok(())
}

/// How many formulas are off by half a pixel somewhere.
fn message(blocks: &[Block<'_>]) -> String {
    let of = |is_it: &dyn Fn(&MethodInfo) -> bool| {
        let methods = blocks.iter().flat_map(|block| {
            let infos = distinct(block.rows.iter().map(|row| row.info));
            let own = infos.into_iter().filter(|info| is_it(info));
            own.map(|info| {
                let rows = block.rows.iter().filter(|row| row.info == info);
                rows.map(|row| row.off_by()).fold(0.0, f64::max) > FAILS_PX
            })
        });
        let is_off: Vec<bool> = methods.collect();
        let off = is_off.iter().filter(|is_off| **is_off).count();
        format!("{off} of {}", is_off.len())
    };
    let [narrow, wide, ours] = [
        of(&|info| info.precision == F32),
        of(&|info| info.precision != F32 && !info.ours),
        of(&|info| info.ours),
    ];
    format!(
        "Half a pixel off somewhere: {narrow} formulas in f32, {wide} in f64 or exact, {ours} of Sightline's"
    )
}

fn square<B: DrawingBackend>(page: &Page<B>, (x, y): (i32, i32), side: i32, ink: Ink) -> Drawn<B> {
    let area = [(x, y), (x + side, y + ROW - 4)];
    page.draw(&Rectangle::new(area, ink.filled()))
}

fn draw_block<B: DrawingBackend>(
    page: &Page<B>,
    block: &Block<'_>,
    (left, top): (i32, i32),
) -> Drawn<B> {
    heading(&page.margin(top, 0, left - 12, 0), block.step.name)?;
    let (first, top) = (left + NAMES, top + block.head());
    let rows = || (0..).map(|i| top + ROW * i);
    let mut cells = Vec::new();
    for (method, y) in block.methods.iter().zip(rows()) {
        let at = (first - 16, y + ROW / 2);
        words(page, method, at, INK, Side::Left)?;
    }
    for (family, x) in block
        .families
        .iter()
        .zip((0..).map(|i| first + 2 * HALF * i))
    {
        let lines = wrapped(family);
        for (line, up) in lines.iter().rev().zip(0..) {
            small_words(page, line, (x + HALF, top - 22 - LINE * (1 + up)), QUIET)?;
        }
        for (precision, x) in [("f32", x), ("f64", x + HALF)] {
            small_words(page, precision, (x + HALF / 2, top - 22), QUIET)?;
        }
        for (method, y) in block.methods.iter().zip(rows()) {
            let own = block.rows.iter().copied();
            let own = own.filter(|row| (row.family, row.info.name) == (*family, *method));
            let (narrow, wide): (Vec<_>, Vec<_>) = own.partition(|row| row.info.precision == F32);
            for (rows, x) in [(narrow, x), (wide, x + HALF)] {
                if !rows.is_empty() {
                    cells.push(((x, y), rows));
                }
            }
        }
    }
    for ((x, y), rows) in &cells {
        let (_, ink, _) = CLASSES[class(rows)];
        square(page, (x + 2, *y), HALF - 4, ink)?;
    }
    // A number may be wider than its cell.
    for ((x, y), rows) in &cells {
        if let Some(value) = fails_from(rows) {
            let is_dark = class(rows) == CLASSES.len() - 1;
            let ink = if is_dark { WHITE } else { INK };
            let at = (x + HALF / 2, y + ROW / 2 - 2);
            small_words(page, &value, at, ink)?;
        }
    }
    Ok(())
}

/// How far off a method is in a family: an index into [`CLASSES`].
fn class(rows: &[&Row]) -> usize {
    let px = rows.iter().map(|row| row.off_by()).fold(0.0, f64::max);
    let class = CLASSES.iter().position(|(most, ..)| px <= *most);
    class.unwrap_or(CLASSES.len() - 1)
}

/// The first value of the parameter at which a method fails.
fn fails_from(rows: &[&Row]) -> Option<String> {
    let Row { value, .. } = rows.iter().find(|row| row.off_by() > FAILS_PX)?;
    Some(if (0.1..200.0).contains(value) {
        format!("{value}")
    } else {
        format!("{value:.0e}")
    })
}

/// Wraps a family's name into lines.
fn wrapped(text: &str) -> Vec<String> {
    const LETTERS: usize = 9;
    let mut lines: Vec<String> = Vec::new();
    for word in text.split(' ') {
        match lines.last_mut() {
            Some(line) if line.len() + word.len() < LETTERS => *line = format!("{line} {word}"),
            _ => lines.push(word.to_owned()),
        }
    }
    lines
}
