//! Cuts ranges of triangles in two by the surface area heuristic (Mac Donald & Booth 1990), estimated in bins (Wald,
//! "On fast Construction of SAH-based Bounding Volume Hierarchies", RT 2007).
//!
//! A library's builder was tried instead, under the nodes of that time. With the trees of obvhs 0.4 (PLOC, medium
//! quality), rays took 2 to 35 % longer on the benchmark's meshes. Building took 1.2 to 2.5 times as long, with twice
//! the memory. The library's faster presets made rays slower still.

use super::{
    node::{WIDTH, to_u32},
    simd::{Eight, Instructions, Lanes, StackRoom, Work},
};
use glam::Vec3A;

/// From the first of these counts on, a range is sorted into 16 bins along each axis, from the second on into 32, else
/// into 8: more bins would cost more than they gain.
const WORTH_BINS: [usize; 2] = [64, 512];
/// The most cuts above a packet, and so the most nodes. Where another cut by surface could make a tree deeper, ranges
/// are halved by count, whatever that does to their boxes. Real meshes of up to a million triangles need up to 23.
pub(super) const DEEPEST: usize = 48;
// At each node on the way down, all children but one may wait.
const _: () = assert!(DEEPEST * (WIDTH - 1) <= StackRoom::CAPACITY);

/// A triangle's box, as in [`Extent`]; number 3 holds the triangle's index, below `2^30`, and [`Leaf::NORMAL`] as bits.
#[derive(Clone, Copy)]
pub(super) struct Leaf(Eight);

impl Leaf {
    /// Set beside the index, so that the number is a normal one. An index alone is subnormal, and the compiler
    /// multiplies it with the three numbers beside it: a terrain's tree took half as long again to build (Intel Xeon,
    /// 2026-11-26).
    const NORMAL: u32 = 1 << 30;

    pub fn new(triangle: u32, min: Vec3A, max: Vec3A) -> Self {
        let Extent(Eight(mut numbers)) = Extent::new(min, max);
        numbers[3] = f32::from_bits(triangle | Self::NORMAL);
        Self(Eight(numbers))
    }

    pub fn triangle(&self) -> u32 {
        self.0.0[3].to_bits() & !Self::NORMAL
    }

    /// Twice the middle of its box, along an axis.
    #[inline(always)]
    fn center(&self, axis: usize) -> f32 {
        let Eight(numbers) = &self.0;
        numbers[axis] - numbers[4 + axis]
    }
}

/// A box as eight numbers: least x, y, z and any number, then the negated greatest x, y, z and any number. The lanes'
/// minimum of two such boxes is then their union.
#[derive(Clone, Copy)]
struct Extent(Eight);

impl Extent {
    const EMPTY: Self = Self(Eight([f32::INFINITY; 8]));

    fn new(min: Vec3A, max: Vec3A) -> Self {
        let ([a, b, c], [d, e, f]) = (min.to_array(), (-max).to_array());
        Self(Eight([a, b, c, 0.0, d, e, f, 0.0]))
    }

    #[inline(always)]
    fn union<L: Lanes>(&self, lanes: L, other: &Eight) -> Self {
        let both = lanes.min(lanes.load(&self.0.0), lanes.load(&other.0));
        Self(lanes.store(both))
    }

    #[inline(always)]
    fn min(&self) -> Vec3A {
        let [x, y, z, ..] = self.0.0;
        Vec3A::new(x, y, z)
    }

    #[inline(always)]
    fn max(&self) -> Vec3A {
        let [_, _, _, _, x, y, z, _] = self.0.0;
        -Vec3A::new(x, y, z)
    }

    /// Half the surface.
    #[inline(always)]
    fn area(&self) -> f32 {
        let size = self.max() - self.min();
        size.x * size.y + size.y * size.z + size.z * size.x
    }
}

/// The middle of a leaf's box, doubled, as an [`Extent`].
#[inline(always)]
fn center_of<L: Lanes>(lanes: L, leaf: L::F) -> L::F {
    lanes.sub(leaf, lanes.halves_swapped(leaf))
}

/// Triangles that become one tree, with the box about them and the box about their doubled centres.
pub(super) struct Range<'a> {
    /// Cuts that led to it.
    depth: usize,
    leaves: &'a mut [Leaf],
    bounds: Extent,
    centers: Extent,
}

impl<'a> Range<'a> {
    #[inline(always)]
    fn new<L: Lanes>(lanes: L, depth: usize, leaves: &'a mut [Leaf]) -> Self {
        let empty = lanes.splat(f32::INFINITY);
        let (mut bounds, mut centers) = (empty, empty);
        for leaf in &*leaves {
            let leaf = lanes.load(&leaf.0.0);
            bounds = lanes.min(bounds, leaf);
            centers = lanes.min(centers, center_of(lanes, leaf));
        }
        Self {
            depth,
            leaves,
            bounds: Extent(lanes.store(bounds)),
            centers: Extent(lanes.store(centers)),
        }
    }

    pub fn into_leaves(self) -> &'a [Leaf] {
        self.leaves
    }

    pub fn len(&self) -> usize {
        self.leaves.len()
    }

    /// The corners of the box about the triangles.
    pub fn bounds(&self) -> [Vec3A; 2] {
        [self.bounds.min(), self.bounds.max()]
    }

    /// All of these triangles, with other boxes.
    pub fn anew(self, leaf: impl Fn(u32) -> Leaf, instructions: Instructions) -> Self {
        for old in &mut *self.leaves {
            *old = leaf(old.triangle());
        }
        instructions.run(Whole(self.leaves))
    }

    /// Half the surface of the box about the triangles.
    pub fn area(&self) -> f32 {
        self.bounds.area()
    }

    /// Cuts the range in two, neither empty. It must have more triangles than a packet.
    pub fn split(self, instructions: Instructions) -> [Self; 2] {
        debug_assert!(self.len() > WIDTH);
        instructions.run(Split(self))
    }

    /// Cuts the range into up to eight, none empty: always the one with the largest surface.
    pub fn split_wide(self, instructions: Instructions) -> Vec<Self> {
        let mut parts = Vec::with_capacity(WIDTH);
        parts.push(self);
        while parts.len() < WIDTH {
            let splittable = (parts.iter().enumerate()).filter(|(_, p)| p.leaves.len() > WIDTH);
            let largest = splittable.max_by(|(_, a), (_, b)| a.area().total_cmp(&b.area()));
            let Some((largest, _)) = largest else { break };
            let range = parts.swap_remove(largest);
            parts.extend(range.split(instructions));
        }
        parts
    }

    /// How often it would have to be halved until packets are left.
    fn halvings(&self) -> usize {
        let packets = self.leaves.len().div_ceil(WIDTH);
        packets.next_power_of_two().trailing_zeros() as usize
    }

    /// Partitions the leaves at a cut, without branches: a processor would mispredict every other one.
    #[inline(always)]
    fn split_at<L: Lanes>(self, lanes: L, cut: &Cut) -> [Self; 2] {
        // `max` with +infinity, for a leaf on the other side, widens no box; `max` with -infinity changes no number.
        const GATE: [f32; 2] = [f32::INFINITY, f32::NEG_INFINITY];
        let Self { depth, leaves, .. } = self;
        let mut below = lanes.splat(f32::INFINITY);
        let mut above = below;
        let mut count = 0;
        for i in 0..leaves.len() {
            // Read before the leaf moves: what was just written is slow to read.
            let is_below = cut.is_below(&leaves[i]);
            let leaf = lanes.load(&leaves[i].0.0);
            leaves[i] = leaves[count];
            leaves[count] = Leaf(lanes.store(leaf));
            let center = center_of(lanes, leaf);
            let gate = |wanted: bool| lanes.splat(GATE[usize::from(wanted)]);
            below = lanes.min(below, lanes.max(center, gate(is_below)));
            above = lanes.min(above, lanes.max(center, gate(!is_below)));
            count += usize::from(is_below);
        }
        let (a, b) = leaves.split_at_mut(count);
        let part = |leaves, bounds, centers| Self {
            depth: depth + 1,
            leaves,
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
        let cut = match range.leaves.len() {
            _ if range.depth + range.halvings() >= DEEPEST => None,
            count if count < worth_16 => Binning::<8>::new(lanes, &range).best(lanes),
            count if count < worth_32 => Binning::<16>::new(lanes, &range).best(lanes),
            _ => Binning::<32>::new(lanes, &range).best(lanes),
        };
        if let Some(cut) = cut {
            return range.split_at(lanes, &cut);
        }
        let Range { depth, leaves, .. } = range;
        let (a, b) = leaves.split_at_mut(leaves.len() / 2);
        [
            Range::new(lanes, depth + 1, a),
            Range::new(lanes, depth + 1, b),
        ]
    }
}

/// All triangles as one range.
pub(super) struct Whole<'a>(pub &'a mut [Leaf]);

impl<'a> Work for Whole<'a> {
    type Output = Range<'a>;

    #[inline(always)]
    fn run<L: Lanes>(self, lanes: L) -> Range<'a> {
        Range::new(lanes, 0, self.0)
    }
}

/// Maps centres to bins.
#[derive(Clone, Copy)]
struct Bins {
    origin: Vec3A,
    scale: Vec3A,
    /// The number of bins, a power of two, less 1.
    mask: u32,
}

impl Bins {
    /// 2^23.
    const INTEGER: f32 = 8_388_608.0;

    #[expect(clippy::cast_precision_loss, reason = "a small number")]
    #[inline(always)]
    fn new(centers: &Extent, mask: u32) -> Self {
        let size = centers.max() - centers.min();
        let scale = Vec3A::splat(mask as f32) / size;
        Self {
            origin: centers.min(),
            scale: Vec3A::select(size.cmpgt(Vec3A::ZERO), scale, Vec3A::ZERO),
            mask,
        }
    }

    /// The bin of a centre along each axis. The last bits of a float between 2^23 and 2^24 are an integer. The mask
    /// gives some bin even where that overflows, and always the same one.
    #[inline(always)]
    fn of(&self, center: Vec3A) -> [u32; 3] {
        let at = (center - self.origin) * self.scale + Vec3A::splat(Self::INTEGER);
        at.to_array().map(|x| x.to_bits() & self.mask)
    }

    /// The same along one axis.
    #[inline(always)]
    fn along(&self, axis: usize, center: f32) -> u32 {
        let at = (center - self.origin[axis]) * self.scale[axis] + Self::INTEGER;
        at.to_bits() & self.mask
    }
}

/// Where a range is cut in two.
struct Cut {
    bins: Bins,
    axis: usize,
    /// The first bin above the cut.
    first_above: u32,
    bounds: [Extent; 2],
}

impl Cut {
    #[inline(always)]
    fn is_below(&self, leaf: &Leaf) -> bool {
        self.bins.along(self.axis, leaf.center(self.axis)) < self.first_above
    }
}

/// How many triangles fall into each bin along each axis, and the boxes about them.
struct Binning<const BINS: usize> {
    bins: Bins,
    extents: [[Extent; BINS]; 3],
    counts: [[usize; BINS]; 3],
}

impl<const BINS: usize> Binning<BINS> {
    #[inline(always)]
    fn new<L: Lanes>(lanes: L, range: &Range) -> Self {
        let bins = Bins::new(&range.centers, to_u32(BINS - 1));
        let mut extents = [[Extent::EMPTY; BINS]; 3];
        let mut counts = [[0; BINS]; 3];
        for leaf in &*range.leaves {
            let numbers = lanes.load(&leaf.0.0);
            let center = Vec3A::new(leaf.center(0), leaf.center(1), leaf.center(2));
            for (axis, bin) in bins.of(center).into_iter().enumerate() {
                let bin = bin as usize % BINS;
                let extent = &mut extents[axis][bin].0;
                *extent = lanes.store(lanes.min(lanes.load(&extent.0), numbers));
                counts[axis][bin] += 1;
            }
        }
        Self {
            bins,
            extents,
            counts,
        }
    }

    /// The cut with the least expected cost; `None` when all are in one bin.
    #[inline(always)]
    fn best<L: Lanes>(&self, lanes: L) -> Option<Cut> {
        let mut best: Option<(f32, usize, usize)> = None;
        for axis in 0..3 {
            let (extents, counts) = (&self.extents[axis], &self.counts[axis]);
            let mut costs_above = [f32::INFINITY; BINS];
            let (mut extent, mut count) = (Extent::EMPTY, 0);
            for bin in (1..BINS).rev() {
                extent = extent.union(lanes, &extents[bin].0);
                count += counts[bin];
                costs_above[bin] = cost(&extent, count);
            }
            let (mut extent, mut count) = (Extent::EMPTY, 0);
            for bin in 1..BINS {
                extent = extent.union(lanes, &extents[bin - 1].0);
                count += counts[bin - 1];
                let cost = cost(&extent, count) + costs_above[bin];
                if best.is_none_or(|(least, ..)| cost < least) && cost < f32::INFINITY {
                    best = Some((cost, axis, bin));
                }
            }
        }
        let (_, axis, first_above) = best?;
        let mut bounds = [Extent::EMPTY; 2];
        for (bin, extent) in self.extents[axis].iter().enumerate() {
            let side = &mut bounds[usize::from(bin >= first_above)];
            *side = side.union(lanes, &extent.0);
        }
        Some(Cut {
            bins: self.bins,
            axis,
            first_above: to_u32(first_above),
            bounds,
        })
    }
}

/// The expected cost of a ray: surface times number of packets. Infinite for no triangles.
#[expect(clippy::cast_precision_loss, reason = "an estimate")]
#[inline(always)]
fn cost(extent: &Extent, count: usize) -> f32 {
    if count == 0 {
        return f32::INFINITY;
    }
    extent.area() * count.div_ceil(WIDTH) as f32
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::bvh::simd::Simd;

    /// The most cuts that lead to a packet.
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
        let mut leaves: Vec<_> = (0..1000_u32)
            .map(|i| {
                let at = 0.9_f32.powi(i.cast_signed());
                Leaf::new(i, Vec3A::splat(at), Vec3A::splat(1.05 * at))
            })
            .collect();
        let mut from = |depth| {
            let all = instructions.run(Whole(&mut leaves));
            deepest(Range { depth, ..all }, instructions)
        };
        let by_surface = from(0);
        assert!(by_surface > 20, "{by_surface} cuts: not deep");
        // 125 packets need seven halvings.
        assert_eq!(from(DEEPEST - 7), DEEPEST);
        assert_eq!(from(DEEPEST - 8), DEEPEST);
        assert!(from(DEEPEST - 15) <= DEEPEST);
    }
}
