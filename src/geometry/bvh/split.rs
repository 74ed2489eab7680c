//! Where ranges of triangles are cut: by the surface area heuristic (Mac Donald & Booth 1990), estimated in bins (Wald,
//! "On fast Construction of SAH-based Bounding Volume Hierarchies", RT 2007).
//!
//! A range is cut until there are eight, the one with the largest surface always first: that makes a node.
//!
//! A library's builder was tried in its place: under the same nodes, the trees of obvhs 0.4 (PLOC, medium quality) took a
//! ray 2 to 35 % longer on the benchmark's meshes and 1.2 to 2.5 times as long to build, with twice the memory; its
//! faster presets were worse on rays. That is what these lines buy.

use super::{node::WIDTH, simd::StackRoom};
use glam::{BVec4A, Vec4};

/// Triangles from which on a range is sorted into 16 bins along each axis; fewer are into 8: more bins would cost more
/// than they tell.
const WORTH_16_BINS: usize = 64;
/// Below this depth ranges are halved by count, whatever that does to their boxes, so that no input makes the tree
/// deeper than [`DEEPEST`].
const HALVED_BELOW: usize = 22;
/// Nodes on the longest way down: what lies below `HALVED_BELOW` holds 8^11 triangles.
const DEEPEST: usize = HALVED_BELOW + 10;
// Of each node on the way down, all children but one may wait.
const _: () = assert!(DEEPEST * (WIDTH - 1) < StackRoom::CAPACITY);

/// A triangle's box; the last component of `min` carries its index as bits.
#[derive(Clone, Copy)]
pub(super) struct Leaf {
    min: Vec4,
    max: Vec4,
}

impl Leaf {
    pub fn new(triangle: u32, min: Vec4, max: Vec4) -> Self {
        let min = min.with_w(f32::from_bits(triangle));
        Self { min, max }
    }

    pub fn triangle(&self) -> u32 {
        self.min.w.to_bits()
    }

    /// Twice the middle of its box.
    #[inline(always)]
    fn center(&self) -> Vec4 {
        self.min + self.max
    }
}

/// A box, of which the last components mean nothing.
#[derive(Clone, Copy)]
struct Extent {
    min: Vec4,
    max: Vec4,
}

impl Extent {
    const EMPTY: Self = Self {
        min: Vec4::INFINITY,
        max: Vec4::NEG_INFINITY,
    };

    #[inline(always)]
    fn union(self, min: Vec4, max: Vec4) -> Self {
        Self {
            min: self.min.min(min),
            max: self.max.max(max),
        }
    }

    /// [`Extent::union`] with a point, or with nothing.
    #[inline(always)]
    fn union_where(self, wanted: bool, point: Vec4) -> Self {
        let wanted = BVec4A::splat(wanted);
        self.union(
            Vec4::select(wanted, point, Self::EMPTY.min),
            Vec4::select(wanted, point, Self::EMPTY.max),
        )
    }

    /// Half the surface.
    fn area(&self) -> f32 {
        let size = (self.max - self.min).truncate();
        size.x * size.y + size.y * size.z + size.z * size.x
    }
}

/// Triangles that become one child, with the box about them and that about their centres (doubled).
pub(super) struct Range<'a> {
    leaves: &'a mut [Leaf],
    bounds: Extent,
    centers: Extent,
}

impl<'a> Range<'a> {
    pub fn new(leaves: &'a mut [Leaf]) -> Self {
        let empty = (Extent::EMPTY, Extent::EMPTY);
        let (bounds, centers) = leaves.iter().fold(empty, |(bounds, centers), leaf| {
            let center = leaf.center();
            (
                bounds.union(leaf.min, leaf.max),
                centers.union(center, center),
            )
        });
        Self {
            leaves,
            bounds,
            centers,
        }
    }

    pub fn leaves(&self) -> &[Leaf] {
        self.leaves
    }

    pub fn len(&self) -> usize {
        self.leaves.len()
    }

    /// The corners of the box about the triangles; the last components mean nothing.
    pub fn bounds(&self) -> [Vec4; 2] {
        [self.bounds.min, self.bounds.max]
    }

    /// Into up to eight, none empty, for a node at this depth.
    pub fn split_wide(self, depth: usize) -> Vec<Self> {
        let mut parts = Vec::with_capacity(WIDTH);
        parts.push(self);
        while parts.len() < WIDTH {
            let size = |part: &Self| {
                #[expect(clippy::cast_precision_loss, reason = "a size to compare")]
                if depth < HALVED_BELOW {
                    part.bounds.area()
                } else {
                    part.leaves.len() as f32
                }
            };
            let splittable = (parts.iter().enumerate()).filter(|(_, p)| p.leaves.len() > WIDTH);
            let largest = splittable.max_by(|(_, a), (_, b)| size(a).total_cmp(&size(b)));
            let Some((largest, _)) = largest else { break };
            let (a, b) = parts.swap_remove(largest).split(depth < HALVED_BELOW);
            parts.extend([a, b]);
        }
        parts
    }

    /// In two, neither empty.
    fn split(self, by_area: bool) -> (Self, Self) {
        let cut = match self.leaves.len() {
            _ if !by_area => None,
            count if count < WORTH_16_BINS => Binning::<8>::new(&self).best(),
            _ => Binning::<16>::new(&self).best(),
        };
        if let Some(cut) = cut {
            return self.split_at(&cut);
        }
        let (a, b) = self.leaves.split_at_mut(self.leaves.len() / 2);
        (Self::new(a), Self::new(b))
    }

    /// Without a branch, of which a processor would foresee every other one only.
    fn split_at(self, cut: &Cut) -> (Self, Self) {
        let Self { leaves, .. } = self;
        let [mut below, mut above] = [Extent::EMPTY; 2];
        let mut count = 0;
        for i in 0..leaves.len() {
            // Read before it moves: what was just written is slow to read.
            let leaf = leaves[i];
            let is_below = cut.is_below(&leaf);
            leaves.swap(i, count);
            below = below.union_where(is_below, leaf.center());
            above = above.union_where(!is_below, leaf.center());
            count += usize::from(is_below);
        }
        let (a, b) = leaves.split_at_mut(count);
        let part = |leaves, bounds, centers| Self {
            leaves,
            bounds,
            centers,
        };
        let [bounds_a, bounds_b] = cut.bounds;
        (part(a, bounds_a, below), part(b, bounds_b, above))
    }
}

/// From centres to bins.
#[derive(Clone, Copy)]
struct Bins {
    origin: Vec4,
    scale: Vec4,
    /// Numbers less than their count, which is a power of two.
    mask: u32,
}

impl Bins {
    /// 2^23.
    const INTEGER: f32 = 8_388_608.0;

    #[expect(clippy::cast_precision_loss, reason = "a small number")]
    fn new(centers: &Extent, mask: u32) -> Self {
        let size = centers.max - centers.min;
        let scale = Vec4::splat(mask as f32) / size;
        Self {
            origin: centers.min,
            scale: Vec4::select(size.cmpgt(Vec4::ZERO), scale, Vec4::ZERO),
            mask,
        }
    }

    /// The bin of a centre along each axis. Of a float between 2^23 and 2^24 the last bits are an integer; taking no more
    /// than them gives some bin, always the same, even for what overflows.
    #[inline(always)]
    fn of(&self, center: Vec4) -> [u32; 3] {
        let at = (center - self.origin) * self.scale + Vec4::splat(Self::INTEGER);
        let [x, y, z, _] = at.to_array();
        [x, y, z].map(|x| x.to_bits() & self.mask)
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
        let center = leaf.min[self.axis] + leaf.max[self.axis];
        self.bins.along(self.axis, center) < self.first_above
    }
}

/// How many triangles fall into each bin along each axis, and the boxes about them.
struct Binning<const BINS: usize> {
    bins: Bins,
    extents: [[Extent; BINS]; 3],
    counts: [[usize; BINS]; 3],
}

impl<const BINS: usize> Binning<BINS> {
    fn new(range: &Range) -> Self {
        let bins = Bins::new(&range.centers, narrow(BINS - 1));
        let mut extents = [[Extent::EMPTY; BINS]; 3];
        let mut counts = [[0; BINS]; 3];
        for leaf in &*range.leaves {
            for (axis, bin) in bins.of(leaf.center()).into_iter().enumerate() {
                let bin = bin as usize % BINS;
                let extent = &mut extents[axis][bin];
                *extent = extent.union(leaf.min, leaf.max);
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
    fn best(&self) -> Option<Cut> {
        let mut best: Option<(f32, usize, usize)> = None;
        for axis in 0..3 {
            let (extents, counts) = (&self.extents[axis], &self.counts[axis]);
            let mut costs_above = [f32::INFINITY; BINS];
            let (mut extent, mut count) = (Extent::EMPTY, 0);
            for bin in (1..BINS).rev() {
                extent = extent.union(extents[bin].min, extents[bin].max);
                count += counts[bin];
                costs_above[bin] = cost(&extent, count);
            }
            let (mut extent, mut count) = (Extent::EMPTY, 0);
            for bin in 1..BINS {
                extent = extent.union(extents[bin - 1].min, extents[bin - 1].max);
                count += counts[bin - 1];
                let cost = cost(&extent, count) + costs_above[bin];
                if best.is_none_or(|(least, ..)| cost < least) && cost < f32::INFINITY {
                    best = Some((cost, axis, bin));
                }
            }
        }
        let (_, axis, first_above) = best?;
        let (below, above) = self.extents[axis].split_at(first_above);
        let bounds = [below, above].map(|side| {
            side.iter()
                .fold(Extent::EMPTY, |all, bin| all.union(bin.min, bin.max))
        });
        Some(Cut {
            bins: self.bins,
            axis,
            first_above: narrow(first_above),
            bounds,
        })
    }
}

/// Surface times packets: what a ray is expected to pay; infinite for nothing at all.
#[expect(clippy::cast_precision_loss, reason = "an estimate")]
fn cost(extent: &Extent, count: usize) -> f32 {
    if count == 0 {
        return f32::INFINITY;
    }
    extent.area() * count.div_ceil(WIDTH) as f32
}

#[expect(clippy::cast_possible_truncation, reason = "a number of bins")]
fn narrow(bin: usize) -> u32 {
    bin as u32
}
