//! A ray's way through a tree.

use super::{
    node::{Child, Node, Packet, Plane, WIDTH},
    ray::TreeRay,
    simd::{Lanes, Stack, Work},
};

/// Hands the triangles that a ray may hit to `visit`, each with its packet and lane, nearer boxes first; `visit` returns
/// the new end of the interval, as [`TreeRay::end`] has it.
///
/// Where `SIFT` is false, triangles are judged by their boxes alone.
pub(super) struct Walk<'a, F, const SIFT: bool> {
    pub nodes: &'a [Node],
    pub packets: &'a [Packet],
    pub ray: &'a TreeRay,
    pub end: f32,
    pub visit: F,
}

impl<F: FnMut(&Packet, usize) -> f32, const SIFT: bool> Work for Walk<'_, F, SIFT> {
    type Output = ();

    #[inline(always)]
    fn run<L: Lanes>(self, lanes: L) {
        let Self {
            nodes,
            packets,
            ray,
            mut end,
            mut visit,
        } = self;
        let boxes = Boxes::new(lanes, ray);
        let sieve = Sieve::new(lanes, ray);
        let mut stack = Stack::new();
        let mut child = Child::node(0);
        loop {
            if child.is_packet() {
                let packet = &packets[child.index()];
                let mut hit = if SIFT {
                    sieve.may_hit(lanes, packet, end)
                } else {
                    present(lanes, packet)
                };
                while hit != 0 {
                    let lane = hit.trailing_zeros() as usize % WIDTH;
                    hit &= hit - 1;
                    end = visit(packet, lane);
                }
            } else {
                let node = &nodes[child.index()];
                let (hit, enter) = boxes.may_hit(lanes, node, end);
                if hit != 0 {
                    child = nearest(lanes, (nodes, packets), node, hit, enter, &mut stack);
                    continue;
                }
            }
            loop {
                let Some(item) = stack.pop() else { return };
                if begins(item) <= end {
                    child = Child::from_bits(low(item));
                    break;
                }
            }
        }
    }
}

/// The nearest of the children in `hit`; the others go onto the stack, farthest first.
#[inline(always)]
fn nearest<L: Lanes>(
    lanes: L,
    lists: (&[Node], &[Packet]),
    node: &Node,
    mut hit: u32,
    enter: L::F,
    stack: &mut Stack,
) -> Child {
    let enter = lanes.store(enter);
    let mut next = || {
        let lane = hit.trailing_zeros() as usize % WIDTH;
        hit &= hit - 1;
        (hit, item(enter[lane], node.children[lane]))
    };
    let (rest, first) = next();
    if rest == 0 {
        return Child::from_bits(low(first));
    }
    let (rest, second) = next();
    let (mut near, far) = if first <= second {
        (first, second)
    } else {
        (second, first)
    };
    prefetch(lanes, lists, near);
    prefetch(lanes, lists, far);
    if rest == 0 {
        stack.push(far);
        return Child::from_bits(low(near));
    }
    let start = stack.len();
    stack.push(far);
    loop {
        let (rest, mut other) = next();
        prefetch(lanes, lists, other);
        if other < near {
            (near, other) = (other, near);
        }
        stack.push(other);
        // Into its place among those above `start`.
        let items = stack.above(start);
        let mut at = items.len() - 1;
        while at > 0 && items[at - 1] < other {
            items[at] = items[at - 1];
            at -= 1;
        }
        items[at] = other;
        if rest == 0 {
            return Child::from_bits(low(near));
        }
    }
}

#[inline(always)]
fn prefetch<L: Lanes>(lanes: L, (nodes, packets): (&[Node], &[Packet]), item: u64) {
    let child = Child::from_bits(low(item));
    if child.is_packet() {
        let packet = &packets[child.index()];
        lanes.prefetch(&packet.corners[0][0]);
        lanes.prefetch(&packet.corners[0][2]);
        lanes.prefetch(&packet.corners[1][1]);
        lanes.prefetch(&packet.corners[2][0]);
        lanes.prefetch(&packet.corners[2][2]);
    } else {
        let node = &nodes[child.index()];
        lanes.prefetch(&node.planes[0]);
        lanes.prefetch(&node.planes[2]);
        lanes.prefetch(&node.planes[4]);
        lanes.prefetch(&node.children);
    }
}

/// A child and where its box begins, so that the nearer is the smaller number: floats that are not negative are ordered
/// as their bits are.
#[inline(always)]
fn item(begins: f32, child: Child) -> u64 {
    u64::from(begins.to_bits()) << 32 | u64::from(child.bits())
}

#[inline(always)]
#[expect(clippy::cast_possible_truncation, reason = "the lower half")]
fn low(item: u64) -> u32 {
    item as u32
}

#[inline(always)]
#[expect(clippy::cast_possible_truncation, reason = "the upper half")]
fn begins(item: u64) -> f32 {
    f32::from_bits((item >> 32) as u32)
}

/// Which lanes hold a triangle.
#[inline(always)]
fn present<L: Lanes>(lanes: L, packet: &Packet) -> u32 {
    let x = lanes.load(&packet.corners[0][0]);
    lanes.le(x, x)
}

/// A ray against the eight boxes of a node.
struct Boxes<L: Lanes> {
    entry: [Plane; 3],
    exit: [Plane; 3],
    inverse: [L::F; 3],
    entry_offset: [L::F; 3],
    exit_offset: [L::F; 3],
}

impl<L: Lanes> Boxes<L> {
    #[inline(always)]
    fn new(lanes: L, ray: &TreeRay) -> Self {
        let splat = |v: [f32; 3]| v.map(|x| lanes.splat(x));
        Self {
            entry: ray.entry,
            exit: ray.exit,
            inverse: splat(ray.inverse),
            entry_offset: splat(ray.entry_offset),
            exit_offset: splat(ray.exit_offset),
        }
    }

    /// Which boxes the ray may enter before `end`, and where.
    #[inline(always)]
    fn may_hit(&self, lanes: L, node: &Node, end: f32) -> (u32, L::F) {
        let at = |side: [Plane; 3], offset: [L::F; 3], axis: usize| {
            let plane = lanes.load(&node.planes[side[axis] as usize]);
            lanes.mul_sub(plane, self.inverse[axis], offset[axis])
        };
        let enter = |axis| at(self.entry, self.entry_offset, axis);
        let leave = |axis| at(self.exit, self.exit_offset, axis);
        // 0 comes second: of zeros of both signs it is the one that is kept.
        let begin = lanes.max(
            lanes.max(enter(0), enter(1)),
            lanes.max(enter(2), lanes.splat(0.0)),
        );
        let end = lanes.min(
            lanes.min(leave(0), leave(1)),
            lanes.min(leave(2), lanes.splat(end)),
        );
        (lanes.le(begin, end), begin)
    }
}

/// A ray against the eight triangles of a packet.
struct Sieve<L: Lanes> {
    axes: [usize; 3],
    origin: [L::F; 2],
    slope: [L::F; 2],
    sign: L::F,
    signed_origin: L::F,
    reach: L::F,
    reach_5: L::F,
    reach_behind: L::F,
    reach_scalar: f32,
}

impl<L: Lanes> Sieve<L> {
    #[inline(always)]
    fn new(lanes: L, ray: &TreeRay) -> Self {
        Self {
            axes: ray.axes,
            origin: ray.origin.map(|x| lanes.splat(x)),
            slope: ray.slope.map(|x| lanes.splat(x)),
            sign: lanes.splat(ray.sign),
            signed_origin: lanes.splat(ray.signed_origin),
            reach: lanes.splat(ray.reach),
            reach_5: lanes.splat(5.0 * ray.reach),
            reach_behind: lanes.splat(-ray.reach),
            reach_scalar: ray.reach,
        }
    }

    /// Which triangles the ray may hit before `end`; see [`super::ray`] for the bounds.
    #[inline(always)]
    fn may_hit(&self, lanes: L, packet: &Packet, end: f32) -> u32 {
        let seen = |corner: usize| {
            let [x, y, along] = self
                .axes
                .map(|axis| lanes.load(&packet.corners[corner][axis]));
            let t = lanes.mul_sub(along, self.sign, self.signed_origin);
            let x = lanes.sub_mul(lanes.sub(x, self.origin[0]), self.slope[0], t);
            let y = lanes.sub_mul(lanes.sub(y, self.origin[1]), self.slope[1], t);
            (t, x, y)
        };
        let [(ta, xa, ya), (tb, xb, yb), (tc, xc, yc)] = [seen(0), seen(1), seen(2)];
        let edge = |x1, y1, x2, y2| lanes.mul_sub(x1, y2, lanes.mul(y1, x2));
        let (u, v, w) = (
            edge(xb, yb, xc, yc),
            edge(xc, yc, xa, ya),
            edge(xa, ya, xb, yb),
        );
        let least = lanes.min(lanes.min(u, v), w);
        let greatest = lanes.max(lanes.max(u, v), w);
        let size = |x, y| lanes.max(lanes.abs(x), lanes.abs(y));
        let m = lanes.max(lanes.max(size(xa, ya), size(xb, yb)), size(xc, yc));
        let e = {
            let minus_10_u = lanes.splat(-5.0 * f32::EPSILON);
            let slack = lanes.sub_mul(self.reach_5, m, minus_10_u);
            lanes.mul(lanes.add(m, self.reach), slack)
        };
        let minus_e = lanes.sub(lanes.splat(0.0), e);
        let one_sign = lanes.le(minus_e, least) | lanes.le(greatest, e);
        let nearest = lanes.min(lanes.min(ta, tb), tc);
        let farthest = lanes.max(lanes.max(ta, tb), tc);
        let limit = lanes.splat(end + self.reach_scalar);
        one_sign & lanes.le(nearest, limit) & lanes.le(self.reach_behind, farthest)
    }
}
