//! Polygons to triangles that cover the same shape: a fan covers a notch, too.

use super::delaunay::delaunay;
use earcut::{Earcut, deviation};
use glam::DVec3;
use std::collections::{BTreeSet, HashSet, VecDeque};

/// How far the triangles' area may be from the polygon's, relative to it, where its outline does not cross itself:
/// well above what rounding makes of a sum over the largest polygons, well below any triangle worth seeing.
const CROSSES: f64 = 1e-9;

/// Polygons of more corners are split by [`delaunay()`]: earcut is faster on few, but takes cubic time on some.
const LARGE: usize = 64;

/// A face with more than this many corners of which half are repeats is left out, too.
const MOST_REPEATS: usize = 1 << 5;

/// Whether a triangle has an area, as far as `f64` tells: those without are left out.
pub(super) fn has_area([a, b, c]: [DVec3; 3]) -> bool {
    (b - a).cross(c - a) != DVec3::ZERO
}

/// Splits polygons, with memory that lasts from one to the next.
#[derive(Default)]
pub(super) struct Splitter {
    earcut: Earcut<f64>,
    flat: Vec<[f64; 2]>,
    indices: Vec<u32>,
    triangles: Vec<[u32; 3]>,
    polygon: Vec<DVec3>,
}

impl Splitter {
    /// The triangles of a face by its vertices and where those lie, with and without area, as indices into its corners;
    /// `None` where it has too many corners of which too many are the same.
    pub fn face(
        &mut self,
        vertices: &[u32],
        position: impl Fn(u32) -> DVec3,
    ) -> Option<&[[u32; 3]]> {
        if vertices.len() == 3 {
            return Some(&[[0, 1, 2]]);
        }
        if is_repetitive(vertices) {
            return None;
        }
        let mut polygon = std::mem::take(&mut self.polygon);
        polygon.clear();
        polygon.extend(vertices.iter().map(|&vertex| position(vertex)));
        match without_spikes(&polygon) {
            None => {
                self.split(&polygon);
            }
            Some(places) => self.split_without_spikes(&polygon, &places),
        }
        self.polygon = polygon;
        Some(&self.triangles)
    }

    /// The triangles of those of a polygon's corners that are left without its spikes, and for each of the others one without
    /// area.
    fn split_without_spikes(&mut self, polygon: &[DVec3], places: &[u32]) {
        let left: Vec<_> = places
            .iter()
            .map(|&place| polygon[place as usize])
            .collect();
        if left.len() < 3 {
            self.triangles.clear();
        } else {
            self.split(&left);
        }
        for triangle in &mut self.triangles {
            *triangle = triangle.map(|corner| places[corner as usize]);
        }
        let count = polygon.len() - 2;
        self.triangles
            .resize(count.max(self.triangles.len()), [0; 3]);
    }

    /// The n - 2 triangles of a simple polygon, as indices into its corners, wound as it is.
    ///
    /// Where two of them touch they share an edge: a corner on the straight line between its neighbours stays (earcut
    /// cuts no ear past it), since the polygon next to it has it too. Triangles without area come only of corners that
    /// coincide, which large polygons leave out. An outline that crosses itself, as that of a twisted quad may, has no
    /// inside; it gets a fan.
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
        let flatten = flatten_along(normal);
        self.flat
            .extend(corners.iter().map(|&corner| flatten(corner - corners[0])));
        if corners.len() > LARGE {
            self.indices = delaunay(&self.flat).unwrap_or_default();
        } else {
            self.earcut.earcut_slice(&self.flat, &[], &mut self.indices);
        }
        if deviation(self.flat.iter().copied(), &[], &self.indices) > CROSSES {
            let fan = (1..).zip(2..).take(corners.len() - 2);
            self.triangles.extend(fan.map(|(b, c)| [0, b, c]));
            return &self.triangles;
        }
        self.triangles.extend(self.indices.as_chunks::<3>().0);
        if corners.len() <= LARGE && self.triangles.len() + 2 < corners.len() {
            let corners = u32::try_from(corners.len()).unwrap_or(u32::MAX);
            close_gaps(&mut self.triangles, corners);
        }
        &self.triangles
    }
}

/// The corners that are left of a polygon where its outline does not go somewhere and straight back, by their places: such a
/// spike holds nothing. `None` where it has none.
fn without_spikes(polygon: &[DVec3]) -> Option<Vec<u32>> {
    let count = polygon.len();
    let at = |place: usize| polygon[place % count];
    // A spike's end, of one corner or of some that coincide, has the same place before and after it.
    let may_have = (0..count).any(|i| at(i) == at(i + 2) || at(i) == at(i + 1));
    if !may_have {
        return None;
    }
    let mut left: VecDeque<u32> = VecDeque::with_capacity(count);
    let is = |a: u32, b: u32| polygon[a as usize] == polygon[b as usize];
    let mut has_spikes = false;
    for place in (0..).take(count) {
        if left.back().is_some_and(|&back| is(back, place)) {
            continue;
        }
        if left.len() > 1 && is(left[left.len() - 2], place) {
            left.pop_back();
            has_spikes = true;
            continue;
        }
        left.push_back(place);
    }
    // About the first corner.
    while left.len() > 1 {
        let last = left.len() - 1;
        if is(left[0], left[last]) {
            left.pop_back();
        } else if last > 1 && is(left[0], left[last - 1]) {
            left.truncate(last - 1);
            has_spikes = true;
        } else if last > 1 && is(left[1], left[last]) {
            left.pop_front();
            left.pop_back();
            has_spikes = true;
        } else {
            break;
        }
    }
    has_spikes.then(|| left.into())
}

fn is_repetitive(vertices: &[u32]) -> bool {
    vertices.len() > MOST_REPEATS
        && 2 * vertices.iter().collect::<HashSet<_>>().len() <= vertices.len()
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
fn flatten_along(normal: DVec3) -> impl Fn(DVec3) -> [f64; 2] {
    let axis = normal.abs().max_position();
    let (x, y) = ((axis + 1) % 3, (axis + 2) % 3);
    let (x, y) = if normal[axis] > 0.0 { (x, y) } else { (y, x) };
    move |corner| [corner[x], corner[y]]
}

/// Fills what earcut leaves open about corners that coincide, or do when seen along the normal: the outlines of such
/// gaps are the sides of the polygon without a triangle, and the other sides of inner edges.
fn close_gaps(triangles: &mut Vec<[u32; 3]>, corners: u32) {
    let edges = |&[a, b, c]: &[u32; 3]| [(a, b), (b, c), (c, a)];
    let present: BTreeSet<(u32, u32)> = triangles.iter().flat_map(edges).collect();
    let ring = (0..corners).map(|i| (i, (i + 1) % corners));
    let is_side = |(a, b): (u32, u32)| b == (a + 1) % corners;
    let inner = present.iter().filter(|&&edge| !is_side(edge));
    let wanted = ring.chain(inner.map(|&(a, b)| (b, a)));
    let mut open = wanted.filter(|edge| !present.contains(edge)).collect();
    while let Some(gap) = take_loop(&mut open) {
        let fan = gap.windows(2).skip(1);
        triangles.extend(fan.map(|step| [gap[0], step[0], step[1]]));
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
