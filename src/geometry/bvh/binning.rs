//! The best cut of a range of triangles, by the surface area heuristic, estimated in bins (Wald, "On fast Construction
//! of SAH-based Bounding Volume Hierarchies", RT 2007).

use super::{
    build_primitive::{BuildPrimitive, Extent},
    node::{WIDTH, to_u32},
    simd::Lanes,
};
use glam::Vec3A;

/// Maps centres to bins.
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
pub(super) struct Cut {
    bins: Bins,
    axis: usize,
    /// The first bin above the cut.
    first_above: u32,
    /// The boxes about the triangles below and above it.
    pub bounds: [Extent; 2],
}

impl Cut {
    #[inline(always)]
    pub fn is_below(&self, primitive: &BuildPrimitive) -> bool {
        self.bins.along(self.axis, primitive.center(self.axis)) < self.first_above
    }
}

/// The cut of triangles with the least expected cost, for so many bins along each axis; `None` when all are in one bin.
/// `centers` is the box about their doubled centres.
#[inline(always)]
pub(super) fn best_cut<const BINS: usize, L: Lanes>(
    lanes: L,
    primitives: &[BuildPrimitive],
    centers: &Extent,
) -> Option<Cut> {
    let bins = Bins::new(centers, to_u32(BINS - 1));
    // Of the triangles in each bin: the boxes about them, and how many they are.
    let mut extents = [[Extent::EMPTY; BINS]; 3];
    let mut counts = [[0; BINS]; 3];
    for primitive in primitives {
        let numbers = lanes.load(&primitive.0.0);
        let center = Vec3A::new(
            primitive.center(0),
            primitive.center(1),
            primitive.center(2),
        );
        for (axis, bin) in bins.of(center).into_iter().enumerate() {
            let bin = bin as usize % BINS;
            let extent = &mut extents[axis][bin].0;
            *extent = lanes.store(lanes.min(lanes.load(&extent.0), numbers));
            counts[axis][bin] += 1;
        }
    }
    let mut best: Option<(f32, usize, usize)> = None;
    for (axis, (extents, counts)) in extents.iter().zip(&counts).enumerate() {
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
    for (bin, extent) in extents[axis].iter().enumerate() {
        let side = &mut bounds[usize::from(bin >= first_above)];
        *side = side.union(lanes, &extent.0);
    }
    Some(Cut {
        bins,
        axis,
        first_above: to_u32(first_above),
        bounds,
    })
}

/// The expected cost of a ray: surface times number of leaves. Infinite for no triangles.
#[expect(clippy::cast_precision_loss, reason = "an estimate")]
#[inline(always)]
fn cost(extent: &Extent, count: usize) -> f32 {
    if count == 0 {
        return f32::INFINITY;
    }
    extent.area() * count.div_ceil(WIDTH) as f32
}
