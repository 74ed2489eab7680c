//! Cuts ranges of triangles in two by the surface area heuristic (Mac Donald & Booth 1990).
//!
//! A library's builder was tried instead, with an earlier node layout. With the trees of obvhs 0.4 (PLOC, medium
//! quality), rays took 2 to 35 % longer on the benchmark's meshes. Building took 1.2 to 2.5 times as long, with twice
//! the memory. The library's faster presets made rays slower still.

use super::{
    binning::{Cut, best_cut},
    build_primitive::{BuildPrimitive, Extent, center_of},
    node::WIDTH,
    simd::{Instructions, Lanes, StackRoom, Work},
};
use glam::Vec3A;

/// From the first of these counts on, a range is sorted into 16 bins along each axis, from the second on into 32, else
/// into 8: more bins would cost more than they gain.
const WORTH_BINS: [usize; 2] = [64, 512];
/// The most cuts above a leaf, and so the most nodes. Where another cut by surface could make a tree deeper, ranges
/// are halved by count, whatever that does to their boxes. Real meshes of up to a million triangles need up to 23.
pub(super) const DEEPEST: usize = 48;
// At each node on the way down, all children but one may wait.
const _: () = assert!(DEEPEST * (WIDTH - 1) <= StackRoom::CAPACITY);

/// Triangles that become one tree, with the box about them and the box about their doubled centres.
pub(super) struct Range<'a> {
    /// Cuts that led to it.
    depth: usize,
    pub primitives: &'a mut [BuildPrimitive],
    bounds: Extent,
    centers: Extent,
}

impl<'a> Range<'a> {
    #[inline(always)]
    fn new<L: Lanes>(lanes: L, depth: usize, primitives: &'a mut [BuildPrimitive]) -> Self {
        let empty = lanes.splat(f32::INFINITY);
        let (mut bounds, mut centers) = (empty, empty);
        for primitive in &*primitives {
            let primitive = lanes.load(&primitive.0.0);
            bounds = lanes.min(bounds, primitive);
            centers = lanes.min(centers, center_of(lanes, primitive));
        }
        Self {
            depth,
            primitives,
            bounds: Extent(lanes.store(bounds)),
            centers: Extent(lanes.store(centers)),
        }
    }

    pub fn len(&self) -> usize {
        self.primitives.len()
    }

    /// The corners of the box about the triangles.
    pub fn bounds(&self) -> [Vec3A; 2] {
        [self.bounds.min(), self.bounds.max()]
    }

    /// All of these triangles, with other boxes.
    pub fn anew(
        self,
        primitive: impl Fn(u32) -> BuildPrimitive,
        instructions: Instructions,
    ) -> Self {
        for old in &mut *self.primitives {
            *old = primitive(old.triangle());
        }
        instructions.run(Whole(self.primitives))
    }

    /// Half the surface of the box about the triangles.
    pub fn area(&self) -> f32 {
        self.bounds.area()
    }

    /// Cuts the range in two, neither empty. It must have more triangles than a leaf.
    pub fn split(self, instructions: Instructions) -> [Self; 2] {
        debug_assert!(self.len() > WIDTH);
        instructions.run(Split(self))
    }

    /// Cuts the range into up to eight, none empty: always the one with the largest surface.
    pub fn split_wide(self, instructions: Instructions) -> Vec<Self> {
        let mut parts = Vec::with_capacity(WIDTH);
        parts.push(self);
        while parts.len() < WIDTH {
            let splittable = (parts.iter().enumerate()).filter(|(_, p)| p.primitives.len() > WIDTH);
            let largest = splittable.max_by(|(_, a), (_, b)| a.area().total_cmp(&b.area()));
            let Some((largest, _)) = largest else { break };
            let range = parts.swap_remove(largest);
            parts.extend(range.split(instructions));
        }
        parts
    }

    /// How often it would have to be halved until leaves are left.
    fn halvings(&self) -> usize {
        let leaves = self.primitives.len().div_ceil(WIDTH);
        leaves.next_power_of_two().trailing_zeros() as usize
    }

    /// Partitions the primitives at a cut, without branches: a processor would mispredict every other one.
    #[inline(always)]
    fn split_at<L: Lanes>(self, lanes: L, cut: &Cut) -> [Self; 2] {
        // `max` with +infinity, for a primitive on the other side, widens no box; `max` with -infinity changes no
        // number.
        const GATE: [f32; 2] = [f32::INFINITY, f32::NEG_INFINITY];
        let Self {
            depth, primitives, ..
        } = self;
        let mut below = lanes.splat(f32::INFINITY);
        let mut above = below;
        let mut count = 0;
        for i in 0..primitives.len() {
            // Read before the primitive moves: what was just written is slow to read.
            let is_below = cut.is_below(&primitives[i]);
            let primitive = lanes.load(&primitives[i].0.0);
            primitives[i] = primitives[count];
            primitives[count] = BuildPrimitive(lanes.store(primitive));
            let center = center_of(lanes, primitive);
            let gate = |wanted: bool| lanes.splat(GATE[usize::from(wanted)]);
            below = lanes.min(below, lanes.max(center, gate(is_below)));
            above = lanes.min(above, lanes.max(center, gate(!is_below)));
            count += usize::from(is_below);
        }
        let (a, b) = primitives.split_at_mut(count);
        let part = |primitives, bounds, centers| Self {
            depth: depth + 1,
            primitives,
            bounds,
            centers: Extent(lanes.store(centers)),
        };
        let [bounds_a, bounds_b] = cut.bounds;
        [part(a, bounds_a, below), part(b, bounds_b, above)]
    }
}

/// A range to cut in two.
struct Split<'a>(Range<'a>);

impl<'a> Work for Split<'a> {
    type Output = [Range<'a>; 2];

    #[inline(always)]
    fn run<L: Lanes>(self, lanes: L) -> Self::Output {
        let Self(range) = self;
        let [worth_16, worth_32] = WORTH_BINS;
        let cut = match range.primitives.len() {
            _ if range.depth + range.halvings() >= DEEPEST => None,
            count if count < worth_16 => best_cut::<8, _>(lanes, range.primitives, &range.centers),
            count if count < worth_32 => best_cut::<16, _>(lanes, range.primitives, &range.centers),
            _ => best_cut::<32, _>(lanes, range.primitives, &range.centers),
        };
        if let Some(cut) = cut {
            return range.split_at(lanes, &cut);
        }
        let (depth, half) = (range.depth + 1, range.primitives.len() / 2);
        let (a, b) = range.primitives.split_at_mut(half);
        [Range::new(lanes, depth, a), Range::new(lanes, depth, b)]
    }
}

/// All triangles as one range.
pub(super) struct Whole<'a>(pub &'a mut [BuildPrimitive]);

impl<'a> Work for Whole<'a> {
    type Output = Range<'a>;

    #[inline(always)]
    fn run<L: Lanes>(self, lanes: L) -> Range<'a> {
        Range::new(lanes, 0, self.0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::bvh::simd::Simd;

    /// The most cuts that lead to a leaf.
    fn deepest(range: Range, instructions: Instructions) -> usize {
        if range.len() <= WIDTH {
            return range.depth;
        }
        let parts = range.split(instructions);
        let depths = parts.map(|part| deepest(part, instructions));
        depths[0].max(depths[1])
    }

    /// Triangles of which each cut takes off only a few make a deep tree, but never one deeper than a walk's stack
    /// allows, wherever in a large tree they are.
    #[test]
    fn no_tree_is_too_deep() {
        let instructions = Instructions::of(Simd::fastest()).expect("it is available");
        let mut primitives: Vec<_> = (0..1000_u32)
            .map(|i| {
                let at = 0.9_f32.powi(i.cast_signed());
                BuildPrimitive::new(i, Vec3A::splat(at), Vec3A::splat(1.05 * at))
            })
            .collect();
        let mut from = |depth| {
            let all = instructions.run(Whole(&mut primitives));
            deepest(Range { depth, ..all }, instructions)
        };
        let by_surface = from(0);
        assert!(by_surface > 20, "{by_surface} cuts: not deep");
        // 125 leaves need seven halvings.
        assert_eq!(from(DEEPEST - 7), DEEPEST);
        assert_eq!(from(DEEPEST - 8), DEEPEST);
        assert!(from(DEEPEST - 15) <= DEEPEST);
    }
}
