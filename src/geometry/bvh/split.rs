//! Splits ranges of triangles by the surface area heuristic (Mac Donald & Booth 1990), estimated in bins (Wald, "On
//! fast Construction of SAH-based Bounding Volume Hierarchies", RT 2007).
//!
//! To make a node, the range with the largest surface is cut in two, again and again, until there are eight.
//!
//! A library's builder was tried instead, under the same nodes. With the trees of obvhs 0.4 (PLOC, medium quality),
//! rays took 2 to 35 % longer on the benchmark's meshes. Building took 1.2 to 2.5 times as long, with twice the memory.
//! The library's faster presets made rays slower still.

use super::{
    node::{WIDTH, to_u32},
    simd::{Eight, Instructions, Lanes, StackRoom, Work},
};
use glam::Vec3A;

/// From this many triangles on, a range is sorted into 16 bins along each axis, else into 8: more bins would cost more
/// than they gain.
const WORTH_16_BINS: usize = 64;
/// From this depth on, ranges are halved by count, whatever that does to their boxes, so that no input makes the tree
/// deeper than [`DEEPEST`]. Real meshes are 5 to 8 deep.
const HALVED_BELOW: usize = 13;
/// The most nodes above a packet: from `HALVED_BELOW` on, each child gets an eighth of its node's triangles, of which
/// there are at most 2^27.
pub(super) const DEEPEST: usize = HALVED_BELOW + 8;
// At each node on the way down, all children but one may wait.
const _: () = assert!(DEEPEST * (WIDTH - 1) < StackRoom::CAPACITY);

/// A triangle's box, as in [`Extent`]; number 3 holds the triangle's index as bits.
#[derive(Clone, Copy)]
pub(super) struct Leaf(Eight);

impl Leaf {
    pub fn new(triangle: u32, min: Vec3A, max: Vec3A) -> Self {
        let Extent(Eight(mut numbers)) = Extent::new(min, max);
        numbers[3] = f32::from_bits(triangle);
        Self(Eight(numbers))
    }

    pub fn triangle(&self) -> u32 {
        self.0.0[3].to_bits()
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

/// Triangles that become one child, with the box about them and the box about their doubled centres.
pub(super) struct Range<'a> {
    leaves: &'a mut [Leaf],
    bounds: Extent,
    centers: Extent,
}

impl<'a> Range<'a> {
    #[inline(always)]
    fn new<L: Lanes>(lanes: L, leaves: &'a mut [Leaf]) -> Self {
        let empty = lanes.splat(f32::INFINITY);
        let (mut bounds, mut centers) = (empty, empty);
        for leaf in &*leaves {
            let leaf = lanes.load(&leaf.0.0);
            bounds = lanes.min(bounds, leaf);
            centers = lanes.min(centers, center_of(lanes, leaf));
        }
        Self {
            leaves,
            bounds: Extent(lanes.store(bounds)),
            centers: Extent(lanes.store(centers)),
        }
    }

    pub fn leaves(&self) -> &[Leaf] {
        self.leaves
    }

    pub fn len(&self) -> usize {
        self.leaves.len()
    }

    /// The corners of the box about the triangles.
    pub fn bounds(&self) -> [Vec3A; 2] {
        [self.bounds.min(), self.bounds.max()]
    }

    /// Cuts the range into up to eight, none empty, for a node at this depth.
    pub fn split_wide(self, depth: usize, instructions: Instructions) -> Vec<Self> {
        let by_area = depth < HALVED_BELOW;
        let mut parts = Vec::with_capacity(WIDTH);
        parts.push(self);
        while parts.len() < WIDTH {
            let size = |part: &Self| {
                #[expect(clippy::cast_precision_loss, reason = "a size to compare")]
                if by_area {
                    part.bounds.area()
                } else {
                    part.leaves.len() as f32
                }
            };
            let splittable = (parts.iter().enumerate()).filter(|(_, p)| p.leaves.len() > WIDTH);
            let largest = splittable.max_by(|(_, a), (_, b)| size(a).total_cmp(&size(b)));
            let Some((largest, _)) = largest else { break };
            let range = parts.swap_remove(largest);
            let (a, b) = instructions.run(Split { range, by_area });
            parts.extend([a, b]);
        }
        parts
    }

    /// Partitions the leaves at a cut, without branches: a processor would mispredict every other one.
    #[inline(always)]
    fn split_at<L: Lanes>(self, lanes: L, cut: &Cut) -> (Self, Self) {
        // `max` with +infinity, for a leaf on the other side, widens no box; `max` with -infinity changes no number.
        const GATE: [f32; 2] = [f32::INFINITY, f32::NEG_INFINITY];
        let Self { leaves, .. } = self;
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
            leaves,
            bounds,
            centers: Extent(lanes.store(centers)),
        };
        let [bounds_a, bounds_b] = cut.bounds;
        (part(a, bounds_a, below), part(b, bounds_b, above))
    }
}

/// A range to cut in two, neither empty: by area, or by count.
struct Split<'a> {
    range: Range<'a>,
    by_area: bool,
}

impl<'a> Work for Split<'a> {
    type Output = (Range<'a>, Range<'a>);

    #[inline(always)]
    fn run<L: Lanes>(self, lanes: L) -> Self::Output {
        let Self { range, by_area } = self;
        let cut = match range.leaves.len() {
            _ if !by_area => None,
            count if count < WORTH_16_BINS => Binning::<8>::new(lanes, &range).best(lanes),
            _ => Binning::<16>::new(lanes, &range).best(lanes),
        };
        if let Some(cut) = cut {
            return range.split_at(lanes, &cut);
        }
        let (a, b) = range.leaves.split_at_mut(range.leaves.len() / 2);
        (Range::new(lanes, a), Range::new(lanes, b))
    }
}

/// All triangles as one range.
pub(super) struct Whole<'a>(pub &'a mut [Leaf]);

impl<'a> Work for Whole<'a> {
    type Output = Range<'a>;

    #[inline(always)]
    fn run<L: Lanes>(self, lanes: L) -> Range<'a> {
        Range::new(lanes, self.0)
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
