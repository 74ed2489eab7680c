//! Splits polygons into triangles that cover the same shape. (A simple fan would also cover the notches of a polygon
//! that is not convex.)

use super::tangled::is_tangled;
use earcut::{Earcut, deviation};
use glam::DVec3;
use std::collections::{BTreeSet, HashSet, VecDeque};

/// If the outline does not cross itself, the area of the triangles differs from the polygon's area by at most this
/// relative amount. It is well above the rounding error for the largest polygons, and well below any visible triangle.
const CROSSES: f64 = 1e-9;

/// Outlines with more corners are searched for crossings before earcut, which takes cubic time on some that cross.
const LARGE: usize = 64;

/// A face with more corners than this is left out if at least half of them repeat a vertex.
const MOST_REPEATS: usize = 1 << 5;

/// Whether a triangle has an area, as computed in `f64`. Triangles without area are left out.
pub(super) fn has_area([a, b, c]: [DVec3; 3]) -> bool {
    (b - a).cross(c - a) != DVec3::ZERO
}

/// Splits polygons, and reuses its buffers from one polygon to the next.
#[derive(Default)]
pub(super) struct Splitter {
    earcut: Earcut<f64>,
    flat: Vec<[f64; 2]>,
    indices: Vec<u32>,
    triangles: Vec<[u32; 3]>,
    polygon: Vec<DVec3>,
}

impl Splitter {
    /// Splits a face into triangles, given its vertices and their positions. The triangles are indices into the face's
    /// corners; some may have no area. `None` if the face has too many corners that repeat a vertex.
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
            None => self.split(&polygon),
            Some(places) => self.split_without_spikes(&polygon, &places),
        }
        self.polygon = polygon;
        Some(&self.triangles)
    }

    /// Splits a polygon after its spikes are removed; `places` are the corners that are left. Triangles without area
    /// are added until there are as many as the polygon with its spikes would have.
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

    /// Splits a simple polygon into n - 2 triangles, as indices into its corners, with the winding of the polygon.
    ///
    /// Triangles that touch share an edge. A corner on the straight line between its neighbours stays a corner of a
    /// triangle (earcut cuts no ear past it), because the adjacent polygon has this corner, too. Only corners that
    /// coincide give triangles without area. An outline that crosses itself, as that of a twisted quad may, has no
    /// well-defined inside, so it is split as a fan.
    fn split(&mut self, corners: &[DVec3]) {
        self.triangles.clear();
        let normal = newell(corners);
        if let &[a, b, c, d] = corners {
            let turns = |p: DVec3, q: DVec3, r: DVec3| (q - p).cross(r - p).dot(normal) > 0.0;
            // A diagonal lies inside the quad if the triangles on both sides of it have the quad's winding.
            if turns(a, b, c) && turns(a, c, d) {
                return self.triangles.extend([[0, 1, 2], [0, 2, 3]]);
            }
            if turns(b, c, d) && turns(b, d, a) {
                return self.triangles.extend([[0, 1, 3], [1, 2, 3]]);
            }
        }
        self.flat.clear();
        let flatten = flatten_along(normal);
        self.flat
            .extend(corners.iter().map(|&corner| flatten(corner - corners[0])));
        if corners.len() > LARGE && is_tangled(&self.flat) {
            self.indices.clear();
        } else {
            self.earcut.earcut_slice(&self.flat, &[], &mut self.indices);
        }
        if deviation(self.flat.iter().copied(), &[], &self.indices) > CROSSES {
            let fan = (1..).zip(2..).take(corners.len() - 2);
            return self.triangles.extend(fan.map(|(b, c)| [0, b, c]));
        }
        self.triangles.extend(self.indices.as_chunks::<3>().0);
        if self.triangles.len() + 2 < corners.len() {
            let corners = u32::try_from(corners.len()).unwrap_or(u32::MAX);
            close_gaps(&mut self.triangles, corners);
        }
    }
}

/// Removes spikes from a polygon. A spike is a part of the outline that goes to a point and straight back; it encloses
/// no area. Returns the indices of the corners that are left; `None` if there is no spike.
fn without_spikes(polygon: &[DVec3]) -> Option<Vec<u32>> {
    let count = polygon.len();
    let at = |place: usize| polygon[place % count];
    // At the tip of a spike, the corners before and after it coincide. If the tip has several corners, they coincide.
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
    // The same for spikes around the first corner.
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

/// Twice the polygon's vector area, by Newell's method relative to its first corner.
fn newell(corners: &[DVec3]) -> DVec3 {
    let Some(&first) = corners.first() else {
        return DVec3::ZERO;
    };
    corners
        .windows(2)
        .map(|pair| (pair[0] - first).cross(pair[1] - first))
        .sum()
}

/// Projects the polygon along the normal's largest axis, so that it becomes counter-clockwise. The other two
/// coordinates are kept exactly, so points on a line parallel to an axis stay on a line.
fn flatten_along(normal: DVec3) -> impl Fn(DVec3) -> [f64; 2] {
    let axis = normal.abs().max_position();
    let (x, y) = ((axis + 1) % 3, (axis + 2) % 3);
    let (x, y) = if normal[axis] > 0.0 { (x, y) } else { (y, x) };
    move |corner| [corner[x], corner[y]]
}

/// Fills the gaps that earcut leaves around corners that coincide after projection. The outline of a gap consists of
/// polygon sides without a triangle and of inner edges that have a triangle on one side only.
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

/// Removes a closed loop from a set of directed edges and returns it; `None` if there is none.
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
