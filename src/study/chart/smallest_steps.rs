//! Shows each triangle test's answers for rays at an edge that start at neighbouring floating-point numbers. After
//! Kettner, Mehlhorn, Pion, Schirra & Yap, Classroom examples of robustness problems in geometric computations, CGTA
//! 40(1), 2008.

use super::prelude::*;
use crate::{geometry::shares::on_all_cores, study::methods::triangles::RayTriangle};
use glam::DVec3;

/// Rays in a tile's row, and in its column.
const SIDE: u32 = 256;
/// The most formulas in a row, the first one's left end, the height of a tile's name or figure, and the first row's
/// top.
const COLUMNS: usize = 9;
const LEFT: f64 = 56.0;
const NAME: f64 = 26.0;
const TOP: f64 = 92.0;

// Also distinct in grey, from light to dark: miss, hit, false, lost.
const HIT: Colour = [0xa9, 0xcb, 0xea];
const MISS: Colour = [0xf4, 0xf4, 0xf4];
const LOST: Colour = [0x7a, 0x0c, 0x0c];
const FALSE: Colour = [0xd9, 0x77, 0x06];

/// One method's answers, or the truth.
struct Tile {
    name: &'static str,
    precision: Precision,
    colours: Vec<Colour>,
}

/// The chart.
pub fn chart() -> Picture {
    let tiles = tiles();
    let names = distinct(tiles.iter().map(|tile| tile.name));
    let blocks = names.len().div_ceil(COLUMNS);
    let columns = names.len().div_ceil(blocks);
    let pitch = (WIDTH - LEFT - 8.0) / count(columns);
    let side = pitch - 8.0;
    let block = 2.0 * (side + NAME) + NAME + 12.0;
    let title = "An edge, and the smallest steps across it";
    let line = "256 x 256 rays at an edge; neighbours differ by the smallest step of their precision. The triangle is below the edge.";
    let mut picture = page(TOP + count(blocks) * block, title, &[line]);
    legend(&mut picture);
    for (names, row) in names.chunks(columns).zip((0..).map(f64::from)) {
        let top = TOP + row * block;
        for (is_narrow, y, words) in [(true, 0.0, "f32 steps"), (false, side + NAME, "f64 steps")] {
            let y = top + NAME + y;
            picture.text_upwards([34.0, y + 0.5 * side], 17.0, QUIET, words);
            for (name, x) in names.iter().zip((0..).map(|i| LEFT + pitch * f64::from(i))) {
                if is_narrow {
                    picture.text([x, top + 10.0], Anchor::Left, 15.0, INK, *name);
                }
                let is_own =
                    |tile: &&Tile| tile.name == *name && (tile.precision == F32) == is_narrow;
                if let Some(tile) = tiles.iter().find(is_own) {
                    draw(&mut picture, tile, [x, y], side);
                }
            }
        }
    }
    picture
}

fn draw(picture: &mut Picture, tile: &Tile, [x, y]: [f64; 2], side: f64) {
    picture.map(&tile.colours, SIDE as usize, [x, y], side / f64::from(SIDE));
    let is_wrong = |colour: &&Colour| [LOST, FALSE].contains(colour);
    let wrong = tile.colours.iter().filter(is_wrong).count();
    let percent = 100.0 * count(wrong) / f64::from(SIDE * SIDE);
    let words = match (wrong, tile.name) {
        (0, TRUTH) => "the truth".to_owned(),
        (0, _) => "none wrong".to_owned(),
        _ => format!("{percent:.1} % wrong"),
    };
    picture.text([x, y + side + 11.0], Anchor::Left, 15.0, QUIET, words);
}

/// The name of the truth's tiles.
const TRUTH: &str = "exact";

fn tiles() -> Vec<Tile> {
    let all = [F32, F64].map(|precision| (precision, cases(precision)));
    let mut tiles: Vec<Tile> = Vec::new();
    for (precision, cases) in &all {
        let so = cases.iter().map(|(_, truth)| truth.map_or(MISS, |_| HIT));
        tiles.push(Tile {
            name: TRUTH,
            precision: *precision,
            colours: so.collect(),
        });
    }
    let mut methods: Vec<_> = TriangleCase::methods().collect();
    methods.sort_by_key(|method| !method.info.ours);
    tiles.extend(on_all_cores(0..methods.len(), |index| {
        let method = methods[index];
        let (_, cases) = &all[usize::from(method.info.precision != F32)];
        let said = cases.iter();
        let said = said.map(|(case, truth)| colour(case, *truth, method));
        let info = method.info;
        Tile {
            name: if info.ours { "Sightline" } else { info.name },
            precision: info.precision,
            colours: said.collect(),
        }
    }));
    tiles
}

/// Rays from neighbouring numbers of a precision with their hits, the top row first. All have one direction and pass an
/// edge of one triangle far from its corners, whose coordinates use all digits of the precision.
fn cases(precision: Precision) -> Vec<(TriangleCase, Option<f64>)> {
    const DIRECTION: DVec3 = DVec3::new(0.25, -0.125, -1.0);
    let bits = if precision == F32 { 24 } else { 53 };
    let step = 0.5_f64.powi(bits);
    let middle = 0.5 + 0.5 * f64::from(SIDE) * step;
    let on_edge = DVec3::new(middle, middle, 3.0) + 2.75 * DIRECTION;
    let along = DVec3::new(1.0, 0.9, 0.3);
    let corners = [
        on_edge - 12.3 * along,
        on_edge + 7.7 * along,
        on_edge + DVec3::new(9.1, -8.3, 2.7),
    ];
    let corners = corners.map(|corner| match precision {
        F32 => through_f32_each(corner.into()),
        _ => corner.into(),
    });
    let case = |i: u32| {
        let [x, y] = [i % SIDE, SIDE - 1 - i / SIDE].map(|i| 0.5 + step * f64::from(i));
        let origin = DVec3::new(x, y, 3.0).into();
        let case = TriangleCase::new(RayTriangle::new(origin, DIRECTION.into(), corners), PX);
        let truth = case.truth();
        (case, truth)
    };
    (0..SIDE * SIDE).map(case).collect()
}

fn colour(case: &TriangleCase, truth: Option<f64>, method: &Method<TriangleCase>) -> Colour {
    match (case.judge(&truth, &(method.run)(case)), truth) {
        (Verdict::Missed(_), _) => LOST,
        (Verdict::Phantom(_) | Verdict::Other, _) => FALSE,
        (_, Some(_)) => HIT,
        (_, None) => MISS,
    }
}

fn legend(picture: &mut Picture) {
    let all = [
        (HIT, "hit"),
        (MISS, "miss"),
        (LOST, "a hit lost"),
        (FALSE, "a miss taken for a hit"),
    ];
    for ((colour, words), x) in all.into_iter().zip([980.0, 1070.0, 1170.0, 1310.0]) {
        picture.rectangle([x, 20.0], [x + 22.0, 42.0], [0x88; 3]);
        picture.rectangle([x + 1.0, 21.0], [x + 21.0, 41.0], colour);
        picture.text([x + 30.0, 31.0], Anchor::Left, 18.0, INK, words);
    }
}
