//! The smallest steps: what each triangle test says of rays that pass an edge, over neighbouring numbers. After Kettner,
//! Mehlhorn, Pion, Schirra & Yap, Classroom examples of robustness problems in geometric computations, CGTA 40(1), 2008.

use super::{
    page::{WIDTH, page},
    picture::{Anchor, Colour, INK, Mark, Picture, QUIET},
};
use crate::study::{
    methods::triangles::{RayTriangle, TriangleCase},
    real::V3,
    scene_rays::PX,
    step::{Case, Method, Precision, Verdict},
};
use glam::DVec3;
use std::thread;

/// Neighbours in a row, and in a column.
const SIDE: u32 = 256;
/// At most so many formulas in a row, and from where; above each tile for its name, below for its figure.
const COLUMNS: usize = 9;
const LEFT: f64 = 56.0;
const NAME: f64 = 26.0;
const TOP: f64 = 92.0;

// Light to dark in this order in grey, too: miss, hit, false, lost.
const HIT: Colour = [0xa9, 0xcb, 0xea];
const MISS: Colour = [0xf4, 0xf4, 0xf4];
const LOST: Colour = [0x7a, 0x0c, 0x0c];
const FALSE: Colour = [0xd9, 0x77, 0x06];

/// What is so, or what one method says of it.
struct Tile {
    name: &'static str,
    precision: Precision,
    colours: Vec<Colour>,
}

/// The chart.
#[must_use]
pub fn chart() -> Picture {
    let tiles = tiles();
    let mut names: Vec<&str> = Vec::new();
    for tile in &tiles {
        if !names.contains(&tile.name) {
            names.push(tile.name);
        }
    }
    let blocks = names.len().div_ceil(COLUMNS);
    let columns = names.len().div_ceil(blocks);
    let [blocks, per_row] = [blocks, columns].map(|n| u32::try_from(n).map_or(1.0, f64::from));
    let pitch = (WIDTH - LEFT - 8.0) / per_row;
    let side = pitch - 8.0;
    let block = 2.0 * (side + NAME) + NAME + 12.0;
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "a page"
    )]
    let height = (TOP + blocks * block) as u32;
    let title = "An edge, and the smallest steps across it";
    let line = "256 x 256 rays, each from its neighbour by the smallest step that its numbers can make; one triangle, below the edge.";
    let mut picture = page(height, title, &[line]);
    legend(&mut picture);
    for (names, row) in names.chunks(columns).zip((0..).map(f64::from)) {
        let top = TOP + row * block;
        for (is_narrow, y, words) in [(true, 0.0, "f32 steps"), (false, side + NAME, "f64 steps")] {
            picture.marks.push(Mark::Text {
                at: [34.0, top + NAME + y + 0.5 * side],
                anchor: Anchor::Middle,
                size: 17.0,
                colour: QUIET,
                upwards: true,
                text: words.to_owned(),
            });
            for (name, x) in names.iter().zip((0..).map(|i| LEFT + pitch * f64::from(i))) {
                if is_narrow {
                    picture.text([x, top + 10.0], Anchor::Left, 15.0, INK, *name);
                }
                let is_own = |tile: &&Tile| {
                    tile.name == *name && (tile.precision == Precision::F32) == is_narrow
                };
                if let Some(tile) = tiles.iter().find(is_own) {
                    draw(&mut picture, tile, [x, top + NAME + y], side);
                }
            }
        }
    }
    picture
}

fn draw(picture: &mut Picture, tile: &Tile, [x, y]: [f64; 2], side: f64) {
    picture.map(&tile.colours, SIDE as usize, [x, y], side / f64::from(SIDE));
    let wrong = tile
        .colours
        .iter()
        .filter(|colour| [LOST, FALSE].contains(colour))
        .count();
    let percent =
        100.0 * f64::from(u32::try_from(wrong).unwrap_or(u32::MAX)) / f64::from(SIDE * SIDE);
    let words = match (wrong, tile.name) {
        (0, TRUTH) => "what is so".to_owned(),
        (0, _) => "none wrong".to_owned(),
        _ => format!("{percent:.1} % wrong"),
    };
    picture.text([x, y + side + 11.0], Anchor::Left, 15.0, QUIET, words);
}

/// The tiles of what is so.
const TRUTH: &str = "exact";

fn tiles() -> Vec<Tile> {
    let [narrow, wide] = [Precision::F32, Precision::F64].map(cases);
    let of = |precision: Precision| {
        if precision == Precision::F32 {
            &narrow
        } else {
            &wide
        }
    };
    let truth = |precision| Tile {
        name: TRUTH,
        precision,
        colours: of(precision)
            .iter()
            .map(|(_, truth)| if truth.is_some() { HIT } else { MISS })
            .collect(),
    };
    let said = |method: &'static Method<TriangleCase>| Tile {
        name: if method.ours {
            "Sightline"
        } else {
            method.name
        },
        precision: method.precision,
        colours: of(method.precision)
            .iter()
            .map(|(case, truth)| colour(case, *truth, method))
            .collect(),
    };
    let mut tiles = vec![truth(Precision::F32), truth(Precision::F64)];
    let mut methods: Vec<_> = TriangleCase::methods().collect();
    methods.sort_by_key(|method| !method.ours);
    thread::scope(|scope| {
        let workers: Vec<_> = methods
            .into_iter()
            .map(|method| scope.spawn(move || said(method)))
            .collect();
        tiles.extend(workers.into_iter().filter_map(|worker| worker.join().ok()));
    });
    tiles
}

/// Rays from neighbouring numbers of a precision, with whether they hit: the top row first. All go the same way and pass an
/// edge of one triangle far from its corners, whose coordinates are what the precision makes of no round ones.
fn cases(precision: Precision) -> Vec<(TriangleCase, Option<f64>)> {
    const DIRECTION: DVec3 = DVec3::new(0.25, -0.125, -1.0);
    let step = if precision == Precision::F32 {
        0.5_f64.powi(24)
    } else {
        0.5_f64.powi(53)
    };
    let middle = 0.5 + 0.5 * f64::from(SIDE) * step;
    let on_edge = DVec3::new(middle, middle, 3.0) + 2.75 * DIRECTION;
    let along = DVec3::new(1.0, 0.9, 0.3);
    let corners = [
        on_edge - 12.3 * along,
        on_edge + 7.7 * along,
        on_edge + DVec3::new(9.1, -8.3, 2.7),
    ];
    let corners = corners.map(|corner| match precision {
        Precision::F32 => V3::from(corner.as_vec3().as_dvec3()),
        _ => V3::from(corner),
    });
    let case = |i: u32| {
        let [x, y] = [i % SIDE, SIDE - 1 - i / SIDE].map(|i| 0.5 + step * f64::from(i));
        let ray = RayTriangle {
            origin: V3::from(DVec3::new(x, y, 3.0)),
            direction: V3::from(DIRECTION),
            corners,
        };
        let case = TriangleCase::new(ray, PX);
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
