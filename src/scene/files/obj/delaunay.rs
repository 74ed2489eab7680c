//! Splits large polygons into triangles. It is fast for every shape of polygon.

use crate::geometry::binary::power_of_two_below;
use spade::{
    ConstrainedDelaunayTriangulation, HasPosition, HierarchyHintGenerator, Point2, Triangulation,
    handles::DirectedEdgeHandle,
};
use std::collections::{BTreeSet, HashMap, hash_map::Entry};

/// A large prime. Multiples of it, modulo the number of corners, give a scattered order of the corners.
const STRIDE: usize = 2_654_435_761;

/// A corner of the polygon. Corners that coincide are represented by one of them.
struct Corner {
    at: Point2<f64>,
    index: u32,
}

impl HasPosition for Corner {
    type Scalar = f64;

    fn position(&self) -> Point2<f64> {
        self.at
    }
}

type Triangles = ConstrainedDelaunayTriangulation<Corner, (), (), (), HierarchyHintGenerator<f64>>;

/// Splits a polygon with fewer than [`STRIDE`] corners into counter-clockwise triangles; `None` if its outline crosses
/// itself or has no area. Corners that coincide are replaced by one of them. It uses constrained Delaunay
/// triangulation. The expected time is O(n log n), because the corners are inserted in an order independent of the
/// outline.
pub(super) fn delaunay(flat: &[[f64; 2]]) -> Option<Vec<u32>> {
    let size = (flat.as_flattened().iter()).fold(0.0, |size: f64, c| size.max(c.abs()));
    // Scaling by a power of two is exact. `insert` refuses coordinates that are too small or too large after it.
    let scale = 1.0 / power_of_two_below(size);
    let mut all = Triangles::new();
    let mut ring = vec![None; flat.len()];
    // Two kinds of insertion take linear time: that of a vertex that is already there, and that of any vertex while
    // all are on a line. So each vertex is inserted once, and the first three are not on a line.
    let mut known = HashMap::new();
    let scattered = (0..flat.len()).map(|i| i * STRIDE % flat.len());
    for index in first_triangle(flat)?.into_iter().chain(scattered) {
        let [x, y] = flat[index].map(|c| scale * c + 0.0);
        let vertex = match known.entry([x.to_bits(), y.to_bits()]) {
            Entry::Occupied(known) => *known.get(),
            Entry::Vacant(new) => {
                let at = Point2::new(x, y);
                let index = u32::try_from(index).ok()?;
                *new.insert(all.insert(Corner { at, index }).ok()?)
            }
        };
        ring[index] = Some(vertex);
    }
    let ring: Vec<_> = ring.into_iter().flatten().collect();
    // If a side occurs twice, like a bridge to a hole, both sides of it are inside or both are outside.
    let mut sides = BTreeSet::new();
    for (&a, &b) in ring.iter().zip(ring.iter().cycle().skip(1)) {
        let side = [a.min(b), a.max(b)];
        if a != b && !sides.insert(side) {
            sides.remove(&side);
        }
    }
    for [a, b] in sides {
        if all.try_add_constraint(a, b).is_empty() {
            return None;
        }
    }

    let mut inside = vec![None; all.num_all_faces()];
    let is_side = |edge: DirectedEdgeHandle<_, _, _, _>| edge.as_undirected().is_constraint_edge();
    let mut open = Vec::new();
    for edge in all.convex_hull().flat_map(|edge| [edge, edge.rev()]) {
        if let Some(face) = edge.face().as_inner() {
            inside[face.index()] = Some(is_side(edge));
            open.push(face);
        }
    }
    while let Some(face) = open.pop() {
        for edge in face.adjacent_edges() {
            if let Some(next) = edge.rev().face().as_inner()
                && inside[next.index()].is_none()
            {
                inside[next.index()] = inside[face.index()].map(|inside| inside != is_side(edge));
                open.push(next);
            }
        }
    }
    let faces = all.inner_faces();
    let faces = faces.filter(|face| inside[face.index()] == Some(true));
    let corners = faces.flat_map(|face| face.vertices().map(|vertex| vertex.data().index));
    Some(corners.collect())
}

/// Three corners that are not on a line.
fn first_triangle(flat: &[[f64; 2]]) -> Option<[usize; 3]> {
    let &[x, y] = flat.first()?;
    let apart = |&[px, py]: &[f64; 2]| [px - x, py - y];
    let is_apart = |p: &[f64; 2]| apart(p).iter().any(|c| c.abs() > 0.0);
    let b = flat.iter().position(is_apart)?;
    let [bx, by] = apart(&flat[b]);
    let off_line = |p: &[f64; 2]| {
        let [px, py] = apart(p);
        bx * py - by * px != 0.0
    };
    Some([0, b, flat.iter().position(off_line)?])
}
