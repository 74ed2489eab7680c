//! Rays at the edge that two triangles share, from neighbouring floating-point numbers: where neither triangle is hit,
//! a closed mesh leaks. After Kettner, Mehlhorn, Pion, Schirra & Yap, Classroom examples of robustness problems in
//! geometric computations, CGTA 40(1), 2008.

use super::prelude::*;
use crate::{
    geometry::shares::on_all_cores,
    study::{methods::triangles::RayTriangle, statistics::rate},
};
use glam::DVec3;
use std::sync::OnceLock;

/// Rays in a tile's row, and in its column.
const SIDE: u32 = 96;
/// Tiles in a row, and the pixels of a ray's square.
const COLUMNS: i32 = 5;
const SQUARE: i32 = 6;

/// The same test with a threshold, one for equality that leaks everywhere, and one that rounds too little to show.
const LEFT_OUT: [&str; 3] = [
    "Moeller-Trumbore, eps 1e-6",
    "areas, sum == 1",
    "double-double volumes",
];

/// The colour of a ray that hits neither triangle, one, the other, both; distinct in grey, too.
const HITS: [(Ink, &str); 4] = [
    (RGBColor(0xc4, 0x12, 0x1c), "neither: the ray leaks"),
    (RGBColor(0xe8, 0xef, 0xf6), "one triangle"),
    (RGBColor(0xbb, 0xcf, 0xe4), "the other"),
    (RGBColor(0x6f, 0x9c, 0xcb), "both"),
];

/// A method's answers: for each ray an index into [`HITS`].
struct Tile {
    info: MethodInfo,
    hits: Vec<usize>,
}

impl Tile {
    /// The share of rays that leak, in per cent.
    fn leaks(&self) -> f64 {
        let leaks = self.hits.iter().filter(|hits| **hits == 0).count();
        100.0 * rate(leaks, self.hits.len())
    }
}

/// Draws the chart.
pub fn draw<B: DrawingBackend>(page: &Page<B>) -> Drawn<B> {
    let tiles = tiles();
    // Of a formula's two precisions, the one that leaks more.
    let other = |tile: &Tile| {
        let mut same = tiles
            .iter()
            .filter(|other| other.info.name == tile.info.name);
        same.find(|other| other.info.precision != tile.info.precision)
    };
    let is_shown = |tile: &&Tile| match (other(tile), tile.info.precision) {
        (None, _) => true,
        (Some(wide), F32) => tile.leaks() >= wide.leaks(),
        (Some(narrow), _) => tile.leaks() > narrow.leaks(),
    };
    let shown: Vec<&Tile> = tiles.iter().filter(is_shown).collect();
    let leaking = tiles.iter().filter(|tile| tile.leaks() > 0.0);
    let (ours, theirs): (Vec<_>, Vec<_>) =
        leaking.map(|tile| tile.info).partition(|info| info.ours);
    let others = shown.iter().filter(|tile| !tile.info.ours).count();
    let message = format!(
        "Rays slip between two triangles in {} of {others} formulas, in f32 or f64; in Sightline's {}",
        distinct(theirs.iter().map(|info| info.name)).len(),
        if ours.is_empty() { "none" } else { "too" }
    );
    let lines = [
        format!("{SIDE} x {SIDE} rays at an edge that two triangles share; neighbours differ by the smallest step."),
        "Each formula in the precision that leaks more, at that precision's steps. Below: the share that hits neither."
            .to_owned(),
    ];
    let rest = head(page, &message, &lines)?;
    let (left, top) = rest.get_base_pixel();
    legend(page, (left + 8, top + 12), &HITS)?;
    let side = SQUARE * i32::try_from(SIDE).unwrap_or(0);
    for (tile, i) in shown.iter().zip(0..) {
        let at = (
            left + 8 + (side + 44) * (i % COLUMNS),
            top + 140 + (side + 154) * (i / COLUMNS),
        );
        draw_tile(page, tile, at)?;
        let leaks = percent(tile.leaks());
        let text = match other(tile) {
            None => format!("leaks: {leaks}"),
            Some(other) => format!(
                "{} leaks: {leaks}; {}: {}",
                tile.info.precision,
                other.info.precision,
                percent(other.leaks())
            ),
        };
        let (leak, _) = HITS[0];
        let ink = if tile.leaks() > 0.0 { leak } else { QUIET };
        words(page, &text, (at.0, at.1 + side + 30), ink, Side::Right)?;
    }
    Ok(())
}

fn percent(value: f64) -> String {
    if value == 0.0 {
        "none".to_owned()
    } else {
        format!("{value:.1} %")
    }
}

fn draw_tile<B: DrawingBackend>(page: &Page<B>, tile: &Tile, (left, top): (i32, i32)) -> Drawn<B> {
    words(page, name(&tile.info), (left, top - 30), INK, Side::Right)?;
    for (row, y) in tile
        .hits
        .chunks(SIDE as usize)
        .zip((0..).map(|i| top + SQUARE * i))
    {
        let mut x = left;
        // One rectangle for each run of one colour.
        for run in row.chunk_by(PartialEq::eq) {
            let end = x + SQUARE * i32::try_from(run.len()).unwrap_or(0);
            let (ink, _) = HITS[run[0]];
            page.draw(&Rectangle::new([(x, y), (end, y + SQUARE)], ink.filled()))?;
            x = end;
        }
    }
    Ok(())
}

/// The tiles, computed once: no report changes them.
fn tiles() -> &'static [Tile] {
    static TILES: OnceLock<Vec<Tile>> = OnceLock::new();
    TILES.get_or_init(made)
}

fn made() -> Vec<Tile> {
    let all = [F32, F64].map(cases);
    let mut methods: Vec<_> = TriangleCase::methods().collect();
    methods.retain(|method| {
        let info = method.info;
        info.ours || info.precision != Precision::Exact && !LEFT_OUT.contains(&info.name)
    });
    on_all_cores(0..methods.len(), |index| {
        let method = methods[index];
        let cases = &all[usize::from(method.info.precision == F64)];
        let is_hit = |case: &TriangleCase| usize::from((method.run)(case).is_some());
        let hits = cases
            .iter()
            .map(|[one, other]| is_hit(one) + 2 * is_hit(other));
        Tile {
            info: method.info,
            hits: hits.collect(),
        }
    })
}

/// Rays from neighbouring numbers of a precision, the top row first, each with the two triangles. All rays have one
/// direction and pass the shared edge far from its ends; the coordinates use all digits of the precision.
fn cases(precision: Precision) -> Vec<[TriangleCase; 2]> {
    const DIRECTION: DVec3 = DVec3::new(0.25, -0.125, -1.0);
    let bits = if precision == F32 { 24 } else { 53 };
    let step = 0.5_f64.powi(bits);
    let middle = 0.5 + 0.5 * f64::from(SIDE) * step;
    let on_edge = DVec3::new(middle, middle, 3.0) + 2.75 * DIRECTION;
    let along = DVec3::new(1.0, 0.9, 0.3);
    let points = [
        on_edge - 12.3 * along,
        on_edge + 7.7 * along,
        on_edge + DVec3::new(9.1, -8.3, 2.7),
        on_edge + DVec3::new(-7.9, 9.7, 1.3),
    ];
    let [a, b, c, d] = points.map(|point| match precision {
        F32 => through_f32_each(point.into()),
        _ => point.into(),
    });
    let case = |i: u32| {
        let [x, y] = [i % SIDE, SIDE - 1 - i / SIDE].map(|i| 0.5 + step * f64::from(i));
        let origin = DVec3::new(x, y, 3.0).into();
        // Each triangle has the edge in its own direction, as neighbours in a mesh have.
        [[a, b, c], [b, a, d]].map(|corners| {
            TriangleCase::new(RayTriangle::new(origin, DIRECTION.into(), corners), PX)
        })
    };
    (0..SIDE * SIDE).map(case).collect()
}
