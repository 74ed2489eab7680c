//! Polygons to triangles that cover the same shape: a fan covers a notch, too.

use earcut::{Earcut, deviation};
use glam::DVec3;
use std::collections::{BTreeSet, HashMap};

/// How far the triangles' area may be from the polygon's, relative to it, where only straight corners were dropped:
/// well above what rounding makes of a sum over the largest polygons, well below any triangle worth seeing.
const CROSSES: f64 = 1e-9;

/// Splits polygons, with memory that lasts from one to the next.
#[derive(Default)]
pub(super) struct Splitter {
    earcut: Earcut<f64>,
    flat: Vec<[f64; 2]>,
    indices: Vec<u32>,
    triangles: Vec<[u32; 3]>,
}

impl Splitter {
    /// The n - 2 triangles of a simple polygon, as indices into its corners, wound as it is.
    ///
    /// Where two of them touch they share an edge: a corner on the straight line between its neighbours stays, since
    /// the polygon next to it has it too. Triangles without area come only of corners that coincide. An outline that
    /// crosses itself, as that of a twisted quad may, has no inside; it gets a fan.
    pub fn split(&mut self, corners: &[DVec3]) -> &[[u32; 3]] {
        self.triangles.clear();
        let normal = newell(corners);
        if let &[a, b, c, d] = corners {
            let turns = |p: DVec3, q: DVec3, r: DVec3| (q - p).cross(r - p).dot(normal) > 0.0;
            // A diagonal with a turn the polygon's way on either side lies inside of it.
            if turns(a, b, c) && turns(a, c, d) {
                self.triangles.extend([[0, 1, 2], [0, 2, 3]]);
                return &self.triangles;
            }
            if turns(b, c, d) && turns(b, d, a) {
                self.triangles.extend([[0, 1, 3], [1, 2, 3]]);
                return &self.triangles;
            }
        }
        self.flat.clear();
        self.flat.extend(corners.iter().map(flatten_along(normal)));
        self.earcut.earcut_slice(&self.flat, &[], &mut self.indices);
        if deviation(self.flat.iter().copied(), &[], &self.indices) > CROSSES {
            let fan = (1..).zip(2..).take(corners.len() - 2);
            self.triangles.extend(fan.map(|(b, c)| [0, b, c]));
            return &self.triangles;
        }
        self.triangles.extend(self.indices.as_chunks::<3>().0);
        if self.triangles.len() + 2 < corners.len() {
            close_gaps(&self.flat, &mut self.triangles);
        }
        &self.triangles
    }
}

/// Twice the polygon's vector area, by Newell's method about its first corner.
fn newell(corners: &[DVec3]) -> DVec3 {
    let Some(&first) = corners.first() else {
        return DVec3::ZERO;
    };
    corners
        .windows(2)
        .map(|pair| (pair[0] - first).cross(pair[1] - first))
        .sum()
}

/// Drops the normal's largest axis, so that the polygon becomes counter-clockwise; coordinates stay as they are, and
/// points on a line along an axis on a line.
fn flatten_along(normal: DVec3) -> impl Fn(&DVec3) -> [f64; 2] {
    let axis = normal.abs().max_position();
    let (x, y) = ((axis + 1) % 3, (axis + 2) % 3);
    let (x, y) = if normal[axis] > 0.0 { (x, y) } else { (y, x) };
    move |corner| [corner[x], corner[y]]
}

/// Brings back the corners that earcut drops because they lie on a straight line: where triangles leave a gap without
/// area, the triangle on its long side is divided at the corners on its other sides. Gaps of another form, about
/// corners that coincide, are filled.
fn close_gaps(flat: &[[f64; 2]], triangles: &mut Vec<[u32; 3]>) {
    let mut owner = HashMap::new();
    for (triangle, &corners) in triangles.iter().enumerate() {
        owner.extend(edges(corners).map(|edge| (edge, triangle)));
    }
    // What the gaps' outlines consist of: edges of the polygon without a triangle, and other sides of inner edges.
    let ring: BTreeSet<_> = (0..)
        .zip((1..).take(flat.len() - 1))
        .chain([(last(flat), 0)])
        .collect();
    let mut open: BTreeSet<(u32, u32)> = ring
        .iter()
        .copied()
        .filter(|edge| !owner.contains_key(edge))
        .collect();
    let inner = triangles.iter().flat_map(|&corners| edges(corners));
    let inner = inner
        .filter(|edge| !ring.contains(edge))
        .map(|(a, b)| (b, a));
    open.extend(inner.filter(|edge| !owner.contains_key(edge)));

    while let Some(mut gap) = take_loop(&mut open) {
        let length = |i: usize| distance(flat, gap[i], gap[(i + 1) % gap.len()]);
        let longest = (0..gap.len()).max_by(|&i, &j| length(i).total_cmp(&length(j)));
        let start_at = (longest.unwrap_or(0) + 1) % gap.len();
        gap.rotate_left(start_at);
        let (start, end) = (gap[0], gap[gap.len() - 1]);
        let forward = gap
            .windows(2)
            .all(|step| along(flat, [start, end], [step[0], step[1]]) > 0.0);
        let Some(&triangle) = owner.get(&(start, end)).filter(|_| forward) else {
            let rest = gap.windows(2).skip(1);
            triangles.extend(rest.map(|step| [start, step[0], step[1]]));
            continue;
        };
        let apex = triangles[triangle]
            .into_iter()
            .find(|&i| i != start && i != end);
        for (part, step) in gap.windows(2).enumerate() {
            let corners = [step[0], step[1], apex.unwrap_or(start)];
            let at = if part == 0 { triangle } else { triangles.len() };
            if part == 0 {
                triangles[at] = corners;
            } else {
                triangles.push(corners);
            }
            owner.extend(edges(corners).map(|edge| (edge, at)));
        }
    }
}

/// Takes a closed walk out of a set of directed edges; `None` when there is none left.
fn take_loop(edges: &mut BTreeSet<(u32, u32)>) -> Option<Vec<u32>> {
    let (start, _) = *edges.first()?;
    let mut walk = vec![start];
    let mut at = start;
    loop {
        let edge = *edges.range((at, 0)..=(at, u32::MAX)).next()?;
        edges.remove(&edge);
        at = edge.1;
        if at == start {
            return Some(walk);
        }
        walk.push(at);
    }
}

fn edges([a, b, c]: [u32; 3]) -> [(u32, u32); 3] {
    [(a, b), (b, c), (c, a)]
}

fn last(flat: &[[f64; 2]]) -> u32 {
    u32::try_from(flat.len() - 1).unwrap_or(u32::MAX)
}

fn distance(flat: &[[f64; 2]], from: u32, to: u32) -> f64 {
    along(flat, [from, to], [from, to])
}

/// The dot product of two steps.
fn along(flat: &[[f64; 2]], [a, b]: [u32; 2], [c, d]: [u32; 2]) -> f64 {
    let [a, b, c, d] = [a, b, c, d].map(|i| flat[i as usize]);
    (b[0] - a[0]) * (d[0] - c[0]) + (b[1] - a[1]) * (d[1] - c[1])
}
