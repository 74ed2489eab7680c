//! Whether two triangles of one space that touch in a point also overlap there, without a ray. A point is on the
//! outline of a triangle where it is a corner or lies between two of them.

use super::{
    coplanar::are_coplanar,
    integer::{Bits, Formula, Integer, Ring, solve},
    number::{Number, Vector},
    point::way,
};
use glam::DVec3;
use std::cmp::Ordering;

/// Whether a point lies exactly on the segment between two points, ends included. All are finite.
pub(crate) fn is_between(point: DVec3, ends: [DVec3; 2]) -> bool {
    let [a, b] = ends;
    let is_in_box = a.min(b).cmple(point).all() && point.cmple(a.max(b)).all();
    is_in_box && (ends.contains(&point) || solve(&OnOneLine([point, a, b])))
}

/// Whether two triangles lie in one plane and overlap arbitrarily near a point that is on the outlines of both. Both
/// have an area.
pub(crate) fn overlap_at(point: DVec3, a: [DVec3; 3], b: [DVec3; 3]) -> bool {
    let sectors = [a, b].map(|corners| Sector::new(corners, point));
    let [Some(in_a), Some(in_b)] = sectors else {
        return false;
    };
    are_coplanar(a, b) && (in_a.holds_some_of(&in_b) || in_b.holds_some_of(&in_a))
}

/// What a triangle fills around a point on its outline: from one side to the other, counter-clockwise about its normal.
struct Sector {
    point: DVec3,
    corners: [DVec3; 3],
    /// A point on each side.
    sides: [DVec3; 2],
}

impl Sector {
    /// `None` where the point is not on the outline.
    fn new(corners: [DVec3; 3], point: DVec3) -> Option<Self> {
        let corner = |i: usize| corners[i % 3];
        let at_corner = (0..3).find(|&i| corner(i) == point);
        let on_edge = || (0..3).find(|&i| is_between(point, [corner(i), corner(i + 1)]));
        let sides = match at_corner {
            Some(i) => [corner(i + 1), corner(i + 2)],
            None => on_edge().map(|i| [corner(i + 1), corner(i)])?,
        };
        Some(Self {
            point,
            corners,
            sides,
        })
    }

    /// Whether a side or the inside of another sector at this point lies strictly within.
    fn holds_some_of(&self, other: &Self) -> bool {
        let [first, last] = self.sides;
        // From a corner or an edge, the sum of the vectors to all corners points inside.
        let ways: [&[DVec3]; 3] = [&other.sides[..1], &other.sides[1..], &other.corners];
        ways.into_iter()
            .any(|way| self.turns_left(&[first], way) && self.turns_left(way, &[last]))
    }

    /// Whether the direction `to` lies less than half a turn counter-clockwise from the direction `from`. A direction is
    /// the sum of the vectors from this point to the given ones.
    fn turns_left(&self, from: &[DVec3], to: &[DVec3]) -> bool {
        solve(&Turn {
            sector: self,
            ways: [from, to],
        })
        .is_gt()
    }
}

/// Whether three points lie on one line.
struct OnOneLine([DVec3; 3]);

impl Formula for OnOneLine {
    type Numbers<I: Ring> = Vector<I>;
    type Answer = bool;

    fn numbers<I: Ring>(&self) -> Vector<I> {
        let [a, b, c] = self.0;
        way::<I>(None, a, b).cross(&way(None, a, c))
    }

    fn most_bits(cross: &Vector<Bits>) -> u32 {
        Bits::most(cross.integers)
    }

    fn answer<I: Integer>(&self, cross: Vector<I>) -> bool {
        cross.integers.iter().all(|n| n.sign().is_eq())
    }
}

/// The sign of the turn from one way to another, counter-clockwise about a sector's normal.
struct Turn<'a> {
    sector: &'a Sector,
    ways: [&'a [DVec3]; 2],
}

impl Formula for Turn<'_> {
    type Numbers<I: Ring> = Number<I>;
    type Answer = Ordering;

    fn numbers<I: Ring>(&self) -> Number<I> {
        let Sector { point, corners, .. } = *self.sector;
        let [a, b, c] = corners;
        let normal = way::<I>(None, a, b).cross(&way(None, a, c));
        let [from, to] = self.ways.map(|way_to| {
            let start = Vector::new(DVec3::ZERO);
            (way_to.iter()).fold(start, |sum, to| sum.plus(&way(None, point, *to)))
        });
        from.cross(&to).dot(&normal)
    }

    fn most_bits(turn: &Number<Bits>) -> u32 {
        Bits::most([turn.integer])
    }

    fn answer<I: Integer>(&self, turn: Number<I>) -> Ordering {
        turn.sign()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_point_is_between_ends_on_the_segment_alone() {
        let ends = [DVec3::new(1.0, -1.0, 3.0), DVec3::new(4.0, 2.0, 9.0)];
        for (share, expected) in [
            (-0.5, false),
            (0.0, true),
            (0.25, true),
            (1.0, true),
            (1.5, false),
        ] {
            let point = ends[0].lerp(ends[1], share);
            assert_eq!(is_between(point, ends), expected, "{share}");
            assert_eq!(is_between(point, [ends[1], ends[0]]), expected, "{share}");
        }
        // In the box of both ends, but beside the line.
        assert!(!is_between(DVec3::new(2.0, 1.0, 5.0), ends));
    }

    /// Triangles with a corner on the edge of another, which lie on one side of it or the other.
    #[test]
    fn triangles_at_an_edge_overlap_on_its_inner_side() {
        let xy = |[x, y]: [f64; 2]| DVec3::new(x, y, 0.0);
        let corners = [[0.0, 0.0], [4.0, 0.0], [0.0, 4.0]].map(xy);
        for i in 0..3 {
            let [a, b, c] = [0, 1, 2].map(|k| corners[(i + k) % 3]);
            let at = 0.5 * (a + b);
            let outwards = at - c;
            let beside = |side: f64| [at, a + side * outwards, b + side * outwards];
            assert!(overlap_at(at, corners, beside(-0.25)), "edge {i}");
            assert!(!overlap_at(at, corners, beside(0.25)), "edge {i}");
            assert!(
                !overlap_at(at + outwards, corners, beside(-0.25)),
                "edge {i}"
            );
            let lifted = beside(-0.25).map(|p| if p == at { p } else { p + DVec3::Z });
            assert!(!overlap_at(at, corners, lifted), "edge {i}");
        }
    }
}
